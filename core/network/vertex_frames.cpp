#include "core/network/vertex_frames.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/base/disjoint_sets.hpp"
#include "core/network/fan_angles.hpp"
#include "core/network/kept_form.hpp"
#include "core/network/network.hpp"
#include "core/network/short_edges.hpp"
#include "core/network/vertex_fan.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
/// Least share of a flat corner between its split vector and either edge: 9 degrees.
constexpr double least_place = 0.05;

class FrameBuilder {
 public:
  FrameBuilder(const Polyhedron& polyhedron, const Shaping& shaping, const VertexFrameOptions& options)
      : polyhedron_(polyhedron), mesh_(polyhedron.topology()), shaping_(shaping), options_(options) {
    for (const FrameRequest& request : options.requests) requests_[request.vertex] = &request;
  }

  Result<VertexFrames> build() {
    const Index count = mesh_.half_edge_count();
    frames_.kind.assign(mesh_.vertex_count(), FrameKind::isolated);
    frames_.ends.resize(2 * std::size_t(count));
    frames_.length.assign(2 * std::size_t(count), 1.0);
    frames_.step.assign(count, 0.0);
    frames_.half_turn.assign(count, false);
    frames_.split_gain.assign(count, 1.0);
    mark_sharp_edges();
    if (auto failed = divide_fans()) return *failed;
    const bool metric = options_.frames == Frames::metric;
    frames_.charts =
        metric ? metric_charts(polyhedron_, frames_.half_turn, side_shares()) : equal_charts(mesh_);
    if (metric) take_kept_areas();
    if (metric) mark_unit_vertices();
    if (metric) find_own_steps();
    for (Index v = 0; v < mesh_.vertex_count(); ++v) place_vertex(v);
    if (metric && !options_.joined.empty()) share_gains();
    return std::move(frames_);
  }

 private:
  void mark_sharp_edges() {
    frames_.sharp.resize(mesh_.edge_count());
    for (Index e = 0; e < mesh_.edge_count(); ++e) frames_.sharp[e] = mesh_.is_border_edge(e);
    for (const auto& [id, on] : shaping_.crease)
      if (const Index e = polyhedron_.find(id); on && e != no_index) frames_.sharp[e] = true;
  }

  std::optional<Message> divide_fans() {
    FanDivider divider(polyhedron_, shaping_, frames_.sharp);
    frames_.basis_begin.reserve(mesh_.vertex_count() + 1);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      frames_.basis_begin.push_back(divider.basis_count());
      sector_begin_.push_back(sectors_.size());
      if (mesh_.outgoing(v) == no_index) continue;
      fan_ = fan_of(mesh_, v);
      const auto request = requests_.find(v);
      const auto divided = divider.divide(v, fan_, request == requests_.end() ? nullptr : request->second);
      if (!divided) return divided.error();
      frames_.kind[v] = divided->kind;
      for (const Sector& sector : divided->sectors) mark_half_turns(sector);
      sectors_.insert(sectors_.end(), divided->sectors.begin(), divided->sectors.end());
    }
    frames_.basis_begin.push_back(divider.basis_count());
    sector_begin_.push_back(sectors_.size());
    return std::nullopt;
  }

  void take_kept_areas() {
    for (const auto& [id, factor] : shaping_.kept_area) {
      const Index f = polyhedron_.find(id);
      if (f == no_index) continue;
      frames_.kept_area.resize(mesh_.face_count(), 1.0);
      frames_.kept_area[f] = factor;
    }
  }

  /// Positions of corners that kept forms put on a side of their face, per half-edge; empty where there are
  /// none.
  std::vector<double> side_shares() const {
    std::vector<double> out;
    for (const auto& entry : shaping_.form) {
      const KeptForm& form = entry.second;
      const Index v = polyhedron_.find(entry.first);
      if (v == no_index || mesh_.outgoing(v) == no_index) continue;
      const Fan fan = fan_of(mesh_, v);
      const auto part = [&](const FanEdge& each) {
        const KeptForm::Edge* edge = form.find(other_end(each));
        return edge ? edge->side : 0;
      };
      for (std::size_t k = 0; k < fan.corners.size(); ++k) {
        const double behind = part(fan.edges[k]), before = part(fan.edges[(k + 1) % fan.edges.size()]);
        if (!(behind > 0 && before > 0) || fan.edges.size() < 3) continue;
        out.resize(mesh_.half_edge_count(), 0.0);
        out[fan.corners[k]] = before / (before + behind);
      }
    }
    return out;
  }

  void mark_unit_vertices() {
    unit_.assign(mesh_.vertex_count(), false);
    for (const Index h : options_.joined) unit_[mesh_.origin(h)] = unit_[mesh_.target(h)] = true;
    for (const auto& [id, pin] : shaping_.pin)
      if (const Index v = polyhedron_.find(id); v != no_index && pin.kind == Pin::Kind::tangents)
        unit_[v] = true;
  }

  /// Steps around smooth vertices from their own corners alone.
  void find_own_steps() {
    own_step_.assign(mesh_.half_edge_count(), 0.0);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (frames_.kind[v] != FrameKind::smooth || unit_[v]) continue;
      fan_ = fan_of(mesh_, v);
      const Sector& sector = sectors_[sector_begin_[v]];
      const std::vector<double> steps = own_steps(sector, seen_angles(sector));
      for (std::size_t j = 0; j < steps.size(); ++j) own_step_[corner(sector, j)] = steps[j];
    }
  }

  Index corner(const Sector& sector, std::size_t j) const {
    return fan_.corners[(sector.first + j) % fan_.corners.size()];
  }
  const FanEdge& edge(const Sector& sector, std::size_t j) const {
    return fan_.edges[(sector.first + j) % fan_.edges.size()];
  }

  void mark_half_turns(const Sector& sector) {
    const bool turns = sector.image == Sector::Image::straight ||
                       (sector.image == Sector::Image::line && sector.corners == 1);
    for (std::size_t j = 0; turns && j < sector.corners; ++j) frames_.half_turn[corner(sector, j)] = true;
  }

  void place_vertex(Index v) {
    if (mesh_.outgoing(v) == no_index) return;
    fan_ = fan_of(mesh_, v);
    const std::span<Sector> sectors(sectors_.data() + sector_begin_[v],
                                    sector_begin_[v + 1] - sector_begin_[v]);
    const bool metric = options_.frames == Frames::metric && !unit_[v];
    const KeptForm* form = metric ? shaping_.form.find(polyhedron_.vertex_id(v)) : nullptr;
    kept_ = form ? kept_edges(*form) : std::vector<KeptForm::Edge>{};
    std::vector<std::vector<double>> angles;
    for (Sector& sector : sectors) {
      const bool turns = frames_.half_turn[corner(sector, 0)];
      angles.push_back(metric && !turns ? metric_angles(sector) : equal_angles(sector));
    }
    const std::vector<double> lengths =
        metric ? lengths_beside_flat_corners(fan_lengths(sectors), sectors, angles)
               : std::vector<double>(fan_.edges.size(), 1.0);
    for (std::size_t s = 0; s < sectors.size(); ++s) {
      place(sectors[s], angles[s], lengths);
      if (options_.frames == Frames::metric) find_gain(sectors[s], metric);
    }
    if (form) add_offset(v, *form);
  }

  /// Kept form of each edge of the fan. Edges without an entry are interpolated between the nearest known
  /// edges; empty where the form knows no edge of the fan.
  std::vector<KeptForm::Edge> kept_edges(const KeptForm& form) const {
    const std::size_t n = fan_.edges.size();
    std::vector<KeptForm::Edge> out(n);
    std::vector<const KeptForm::Edge*> known;
    for (const FanEdge& each : fan_.edges) known.push_back(form.find(other_end(each)));
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t before = 0, after = 0;
      const auto back = [&] { return known[(k + n - before % n) % n]; };
      const auto ahead = [&] { return known[(k + after) % n]; };
      while (before < n && !back()) ++before;
      while (after < n && !ahead()) ++after;
      if (before == n) return {};
      const double share = before + after == 0 ? 0 : double(before) / double(before + after);
      out[k].turn = (1 - share) * back()->turn + share * ahead()->turn;
      out[k].stretch = (1 - share) * back()->stretch + share * ahead()->stretch;
      if (known[k]) out[k].lean = known[k]->lean;
    }
    return out;
  }

  VertexId other_end(const FanEdge& each) const {
    return polyhedron_.vertex_id(each.at_origin ? mesh_.target(each.half_edge)
                                                : mesh_.origin(each.half_edge));
  }

  void add_offset(Index v, const KeptForm& form) {
    frames_.offset.resize(frames_.basis_count(), Vector3::Zero());
    add_form_offset(polyhedron_, frames_, v, form, frames_.offset);
  }

  /// Angle of each edge of the sector from its first one, in equal frames.
  static std::vector<double> equal_angles(const Sector& sector) {
    std::vector<double> angles(sector.corners + 1);
    for (std::size_t j = 0; j <= sector.corners; ++j)
      angles[j] = sector.opening * double(j) / double(sector.corners);
    return angles;
  }

  /// Corner angles of the sector in the charts of their faces.
  std::vector<double> seen_angles(const Sector& sector) const {
    std::vector<double> seen(sector.corners);
    for (std::size_t j = 0; j < sector.corners; ++j)
      seen[j] = corner_angle(mesh_, frames_.charts, corner(sector, j));
    return seen;
  }

  std::vector<double> own_steps(const Sector& sector, std::span<const double> seen) const {
    std::vector<Index> sides(sector.corners);
    for (std::size_t j = 0; j < sector.corners; ++j)
      sides[j] = mesh_.side_count(mesh_.face(corner(sector, j)));
    return fan_steps(seen, sides, sector.opening, sector.image == Sector::Image::smooth);
  }

  std::vector<double> metric_angles(Sector& sector) const {
    const std::vector<double> seen = seen_angles(sector);
    if (sector.image == Sector::Image::corner)
      sector.opening = std::clamp(std::accumulate(seen.begin(), seen.end(), 0.0), pi / 6, 2 * pi / 3);
    const bool smooth = sector.image == Sector::Image::smooth;
    std::vector<double> steps =
        limited_steps(smooth ? steps_beside_short_edges(mesh_, frames_.charts, fan_.corners, own_step_)
                             : own_steps(sector, seen),
                      seen, sector.opening);
    if (!kept_.empty()) {
      std::vector<double> turns;
      for (std::size_t j = 0; j <= sector.corners; ++j)
        turns.push_back(kept_[(sector.first + j) % kept_.size()].turn);
      steps = turned_steps(std::move(steps), turns, seen, sector.opening);
    }
    std::vector<double> angles(sector.corners + 1, 0.0);
    std::partial_sum(steps.begin(), steps.end(), angles.begin() + 1);
    angles.back() = sector.opening;
    return angles;
  }

  /// Lengths of the edges in space, kept above zero relative to the longest. The two edges of a half-turn
  /// corner share one length.
  std::vector<double> fan_lengths(std::span<const Sector> sectors) const {
    std::vector<double> lengths;
    double longest = 0;
    for (const FanEdge& each : fan_.edges) {
      lengths.push_back(frames_.charts.edge_length[mesh_.edge(each.half_edge)]);
      longest = std::max(longest, lengths.back());
    }
    if (!(longest > 0)) longest = frames_.charts.mean_length;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      lengths[k] = fan_length(lengths[k], longest);
      if (!kept_.empty()) lengths[k] *= std::exp(kept_[k].stretch);
    }
    for (const Sector& sector : sectors) {
      if (!frames_.half_turn[corner(sector, 0)]) continue;
      double& first = lengths[sector.first % lengths.size()];
      double& last = lengths[(sector.first + 1) % lengths.size()];
      first = last = std::sqrt(first * last);
    }
    return lengths;
  }

  /// Angle from the corner's first edge to its split vector, as a share of the corner's angle.
  double split_place(Index corner, std::size_t first, std::size_t second) const {
    const double lean = kept_.empty() ? 0 : (kept_[first].lean + kept_[second].lean) / 2;
    return std::clamp(place_in_corner(mesh_, frames_.charts, corner) + lean, least_place, 1 - least_place);
  }

  /// Lengths of edges, corrected beside flat corners. Between edges that are nearly opposite the split vector
  /// is the difference of two large vectors, so a small relative change of their lengths turns it far. There
  /// the ratio of lengths is the one that gives it its direction in the face's chart. The shorter edge
  /// changes more, as its curve is hardly affected.
  std::vector<double> lengths_beside_flat_corners(std::vector<double> lengths,
                                                  std::span<const Sector> sectors,
                                                  std::span<const std::vector<double>> angles) const {
    std::vector<double> logarithms(lengths.size(), 0.0);
    for (std::size_t s = 0; s < sectors.size(); ++s) {
      if (sectors[s].image == Sector::Image::corner || frames_.half_turn[corner(sectors[s], 0)]) continue;
      for (std::size_t j = 0; j < sectors[s].corners; ++j) {
        const Index h = corner(sectors[s], j);
        const double step = angles[s][j + 1] - angles[s][j];
        const double share = flat_share(step, corner_angle(mesh_, frames_.charts, h));
        if (share == 0) continue;
        const std::size_t first = (sectors[s].first + j) % lengths.size(),
                          second = (first + 1) % lengths.size();
        const double split = step * split_place(h, first, second);
        const double ratio = frames_.charts.area[mesh_.previous(h)] * std::sin(split) /
                             (frames_.charts.area[h] * std::sin(step - split));
        const double a = lengths[first], b = lengths[second], change = share * std::log(ratio * a / b);
        logarithms[first] -= change * b * b / (a * a + b * b);
        logarithms[second] += change * a * a / (a * a + b * b);
      }
    }
    for (std::size_t k = 0; k < lengths.size(); ++k) lengths[k] *= std::exp(logarithms[k]);
    return lengths;
  }

  void place(const Sector& sector, const std::vector<double>& angles, const std::vector<double>& lengths) {
    for (std::size_t j = 0; j <= sector.corners; ++j) {
      const double length = lengths[(sector.first + j) % lengths.size()];
      if (j < fan_.edges.size())  // in a closed fan the last edge is the first one
        set_edge(sector, j, scaled(image(sector, angles, j), length), length);
      if (j < sector.corners)
        frames_.step[corner(sector, j)] =
            options_.frames == Frames::equal || frames_.half_turn[corner(sector, j)]
                ? sector.opening / double(sector.corners)
                : angles[j + 1] - angles[j];
    }
  }

  static TangentCoefficients scaled(TangentCoefficients tangent, double length) {
    for (double& c : tangent.c) c *= length;
    return tangent;
  }

  /// Image of the unit vector along edge j.
  static TangentCoefficients image(const Sector& sector, const std::vector<double>& angles, std::size_t j) {
    const double angle = angles[j];
    const bool first = j == 0, last = j == sector.corners;
    switch (sector.image) {
      case Sector::Image::straight:
        return {{sector.basis[0], no_index}, {first ? 1.0 : -1.0, 0}};
      case Sector::Image::smooth:
        return {sector.basis, {std::sin(angle), std::cos(angle)}};
      case Sector::Image::line:
        if (first || last) return {{sector.basis[1], no_index}, {first ? sector.sign : -sector.sign, 0}};
        return {sector.basis, {std::sin(angle), sector.sign * std::cos(angle)}};
      case Sector::Image::corner:
        break;
    }
    if (first) return {{sector.basis[0], no_index}, {1, 0}};
    if (last) return {{sector.basis[1], no_index}, {1, 0}};
    return {sector.basis,
            {std::sin(sector.opening - angle) / std::sin(sector.opening),
             std::sin(angle) / std::sin(sector.opening)}};
  }

  void set_edge(const Sector& sector, std::size_t j, const TangentCoefficients& tangent, double length) {
    const FanEdge& at = edge(sector, j);
    const auto set = [&](Index end) {
      frames_.ends[end] = tangent;
      frames_.length[end] = length;
    };
    set(2 * at.half_edge + (at.at_origin ? 0 : 1));
    const Index twin = mesh_.twin(at.half_edge);
    if (twin != no_index) set(2 * twin + (at.at_origin ? 1 : 0));
  }

  /// Sets the split gain of a sector: one factor, so that its split vectors are as long, in the geometric
  /// mean, as the corners' arms in the face charts. A fan of unit lengths represents one with the mean length
  /// of its edges.
  void find_gain(const Sector& sector, bool metric) {
    if (frames_.half_turn[corner(sector, 0)]) return;
    const FaceCharts& charts = frames_.charts;
    double logarithms = 0;
    for (std::size_t j = 0; j < sector.corners; ++j) {
      const Index h = corner(sector, j);
      const double a = frames_.length[2 * h], b = frames_.length[2 * mesh_.previous(h) + 1];
      const double xa = charts.area[h], xb = charts.area[mesh_.previous(h)], step = frames_.step[h];
      const double along = xb * a + xa * b * std::cos(step), across = xa * b * std::sin(step);
      const double split = std::hypot(along, across) / (a * b * std::abs(std::sin(step)));
      logarithms += std::log(std::sqrt(charts.square[h]) / split);
    }
    logarithms /= double(sector.corners);
    if (!metric) logarithms -= mean_logarithm_of_lengths();
    const double kappa = std::exp(logarithms);
    for (std::size_t j = 0; j < sector.corners; ++j) {
      const Index h = corner(sector, j);
      frames_.split_gain[h] = kappa / (frames_.length[2 * h] * frames_.length[2 * mesh_.previous(h) + 1] *
                                       std::sin(frames_.step[h]));
    }
  }

  /// Equalises split gains along chains of given sides: a side that is given at both ends leaves the surface
  /// at one speed, which is proportional to the gains there.
  void share_gains() {
    DisjointSets chains(mesh_.vertex_count());
    for (const Index h : options_.joined) chains.join(mesh_.origin(h), mesh_.target(h));
    std::vector<double> logarithms(mesh_.vertex_count(), 0.0), counts(mesh_.vertex_count(), 0.0);
    const auto for_corners = [&](const auto& body) {
      std::vector<bool> done(mesh_.vertex_count(), false);
      for (const Index joined : options_.joined)
        for (const Index v : {mesh_.origin(joined), mesh_.target(joined)}) {
          if (done[v]) continue;
          done[v] = true;
          for (Index h = mesh_.outgoing(v); h != no_index; h = mesh_.rotate(h))
            if (!frames_.half_turn[h]) body(chains.find(v), frames_.split_gain[h]);
        }
    };
    for_corners([&](Index chain, double gain) {
      logarithms[chain] += std::log(gain);
      counts[chain] += 1;
    });
    for_corners([&](Index chain, double& gain) { gain = std::exp(logarithms[chain] / counts[chain]); });
  }

  double mean_logarithm_of_lengths() const {
    double longest = 0, sum = 0;
    const auto length = [&](const FanEdge& each) {
      return frames_.charts.edge_length[mesh_.edge(each.half_edge)];
    };
    for (const FanEdge& each : fan_.edges) longest = std::max(longest, length(each));
    if (!(longest > 0)) longest = frames_.charts.mean_length;
    for (const FanEdge& each : fan_.edges) sum += std::log(fan_length(length(each), longest));
    return sum / double(fan_.edges.size());
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const Shaping& shaping_;
  const VertexFrameOptions& options_;
  std::map<Index, const FrameRequest*> requests_;
  VertexFrames frames_;
  Fan fan_;
  std::vector<Sector> sectors_;            ///< sectors of all vertices, in order
  std::vector<std::size_t> sector_begin_;  ///< per vertex, plus one
  std::vector<bool> unit_;        ///< per vertex: keeps equal angles and unit lengths; empty in equal frames
  std::vector<double> own_step_;  ///< per corner, 0 at vertices that are not smooth
  std::vector<KeptForm::Edge> kept_;  ///< kept form of the edges of `fan_`; empty where nothing is kept
};

}  // namespace

Result<VertexFrames> build_vertex_frames(const Polyhedron& polyhedron, const Shaping& shaping,
                                         const VertexFrameOptions& options) {
  return FrameBuilder(polyhedron, shaping, options).build();
}

}  // namespace hariko
