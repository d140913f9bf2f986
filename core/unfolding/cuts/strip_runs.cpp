#include "core/unfolding/cuts/strip_runs.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace hariko {

namespace {

/// Largest distance of sides from the straight line of their strip, in strip widths.
constexpr double most_off = 0.125;

/// Side of a joint on its piece, which lies on its left.
struct JointSide {
  Index joint = no_index;
  std::size_t which = 0;
  Index piece = no_index;
  Vector2 from, to;
};

class Runs {
 public:
  Runs(const FacetGraph& graph, const FlatLayout& layout, const std::vector<Joint>& joints,
       const PaperSettings& settings, double longest)
      : joints_(joints), off_(most_off * settings.strip_width), longest_(longest), sides_(joints.size()) {
    for (Index j = 0; j < joints.size(); ++j) {
      if (joints[j].tab) continue;
      const FacetEdge& edge = graph.edge(joints[j].edge);
      for (std::size_t k = 0; k < 2; ++k) {
        const FacetCorners& corners = layout.corners[edge.facets[k]];
        sides_[j][k] = {j, k, layout.piece_of[edge.facets[k]], corners[edge.sides[k]],
                        corners[(edge.sides[k] + 1) % 3]};
        begins_[key(sides_[j][k].piece, sides_[j][k].from)].push_back({j, k});
      }
    }
  }

  std::vector<StripRun> find() {
    std::vector<char> taken(joints_.size(), 0);
    std::vector<StripRun> out;
    for (Index j = 0; j < joints_.size(); ++j) {
      if (joints_[j].tab || taken[j]) continue;
      out.push_back(run_of(j, taken));
    }
    return out;
  }

 private:
  using Key = std::tuple<Index, double, double>;
  using Place = std::pair<Index, std::size_t>;  ///< joint, and number of its side
  static Key key(Index piece, const Vector2& p) { return {piece, p.x(), p.y()}; }

  /// Grows a run from a joint to one end, then to the other.
  StripRun run_of(Index first, std::vector<char>& taken) {
    std::vector<Place> run{{first, 0}};
    taken[first] = 1;
    grow(run, taken);
    // Reverses the run: the second side leads now.
    std::reverse(run.begin(), run.end());
    for (Place& place : run) place.second = 1 - place.second;
    grow(run, taken);
    StripRun out;
    for (const Place& place : run) {
      out.joints.push_back(place.first);
      out.length += length(place.first);
    }
    if (out.joints.front() > out.joints.back()) std::reverse(out.joints.begin(), out.joints.end());
    return out;
  }

  /// Appends joints whose leading side begins where that of the last one ends, and whose other side ends
  /// where that one's other side begins.
  void grow(std::vector<Place>& run, std::vector<char>& taken) const {
    for (;;) {
      const auto [last, leading] = run.back();
      const JointSide &own = sides_[last][leading], &other = sides_[last][1 - leading];
      const auto found = begins_.find(key(own.piece, own.to));
      if (found == begins_.end()) return;
      const Place* next = nullptr;
      for (const Place& place : found->second) {
        const JointSide& beyond = sides_[place.first][1 - place.second];
        if (!taken[place.first] && beyond.piece == other.piece && beyond.to == other.from) next = &place;
      }
      if (!next) return;
      run.push_back(*next);
      if (!straight(run)) {
        run.pop_back();
        return;
      }
      taken[next->first] = 1;
    }
  }

  double length(Index joint) const { return (sides_[joint][0].to - sides_[joint][0].from).norm(); }

  bool straight(const std::vector<Place>& run) const {
    double sum = 0;
    for (const Place& place : run) sum += length(place.first);
    if (sum > longest_) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = [&](const Place& place) -> const JointSide& {
        return sides_[place.first][k == 0 ? place.second : 1 - place.second];
      };
      const Vector2 from = k == 0 ? at(run.front()).from : at(run.front()).to,
                    to = k == 0 ? at(run.back()).to : at(run.back()).from;
      const double chord = (to - from).norm();
      if (!(chord > 0)) return false;
      const Vector2 along = (to - from) / chord, across(-along.y(), along.x());
      double before = 0;
      for (const Place& place : run) {
        const Vector2 d = (k == 0 ? at(place).to : at(place).from) - from;
        if (std::abs(across.dot(d)) > off_ || along.dot(d) < before) return false;
        before = along.dot(d);
      }
    }
    return true;
  }

  const std::vector<Joint>& joints_;
  double off_, longest_;
  std::vector<std::array<JointSide, 2>> sides_;
  std::map<Key, std::vector<Place>> begins_;
};

}  // namespace

std::vector<StripRun> strip_runs(const FacetGraph& graph, const FlatLayout& layout,
                                 const std::vector<Joint>& joints, const PaperSettings& settings,
                                 double longest) {
  return Runs(graph, layout, joints, settings, longest).find();
}

}  // namespace hariko
