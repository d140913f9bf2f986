#include "core/envelope/enclosure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/envelope/pulled_vertices.hpp"
#include "core/envelope/valley_push.hpp"
#include "core/envelope/violations.hpp"

namespace hariko {

namespace {

constexpr int coarse_cells = 14, fine_cells = 28;
constexpr double largest_growth = 1.6;  ///< of what all solids begin with
constexpr double growth_step = 0.05;
constexpr double valley_growth = 1.25, valley_growth_step = 0.03;  ///< where valley vertices do most of it
constexpr int hopeless_builds = 10;
constexpr double hopeless_worst = 60;  ///< tolerances
constexpr int first_star_build = 3, first_growing_build = 6;
constexpr double star_worst = 20;       ///< tolerances
constexpr double star_share = 0.7;      ///< of the farthest point outside
constexpr double star_reach = 0.12;     ///< of the diagonal
constexpr double tautest_waist = 0.25;  ///< of what the search makes of bridges
constexpr double cut_step = 0.6;
constexpr int first_pinning_build = 4;
constexpr double pin_spacing = 0.4;  ///< of the thinning distance

class Search {
 public:
  Search(std::span<const PlacedSolid> solids, const EnclosureSettings& settings, GrowthState start)
      : solids_(solids),
        settings_(settings),
        state_(std::move(start)),
        coarse_(coarse_cells),
        fine_(fine_cells) {
    if (state_.sigma.size() != solids.size()) state_.sigma.assign(solids.size(), 1);
    largest_ = largest_growth * *std::min_element(state_.sigma.begin(), state_.sigma.end());
    diagonal_ = scene_diagonal(solids);
    if (settings.valleys) grown_ = *settings.valleys->solids;
    for (const PlacedSolid& solid : solids) {
      double sum = 0;
      for (const Vector3& u : solid.unit_vertices) sum += (solid.to_world * u).norm();
      radius_.push_back(sum / double(solid.unit_vertices.size()));
    }
  }

  EnclosedNetwork run(const CancelToken& cancel) {
    EnclosedNetwork best;
    best.worst = 1e300;
    const double tolerance = settings_.tolerance * diagonal_;
    for (int build = 1; build <= settings_.largest_builds && !cancel.cancelled(); ++build) {
      const GrowthState used = state_;
      CurveNetwork network = make();
      if (network.patches.empty()) break;
      const ListedViolations which = grown_ ? ListedViolations::all : ListedViolations::worst;
      Violations found = find_violations(network, solids_, tolerance, coarse_, which);
      if (settings_.fine && found.worst <= tolerance)
        found = find_violations(network, solids_, tolerance, fine_, which);
      std::optional<EnclosureReport> check;
      if (settings_.strict && found.worst <= tolerance) {
        check = check_network(network, solids_, diagonal_, cancel);
        add_outside(network, *check, found);
      }
      const bool better = found.worst < best.worst;
      if (found.worst > tolerance) {
        repair(network, found, build);
        if (settings_.symmetry) even_state();
      }
      if (better) {
        best.worst = found.worst;
        best.enclosed = found.worst <= tolerance;
        best.network = std::move(network);
        best.state = used;
        best.check = std::move(check);
      }
      best.builds = build;
      if (best.enclosed) break;
      if (settings_.valleys && build >= hopeless_builds && best.worst > hopeless_worst * tolerance) break;
    }
    best.diagonal = diagonal_;
    if (settings_.strict && !best.check && !best.network.patches.empty())
      best.check = check_network(best.network, solids_, diagonal_, cancel);
    best.state.kept.clear();
    for (const CageVertex& v : best.network.cage.vertices)
      if (v.solid != no_index && v.vertex != no_index) best.state.kept.emplace(v.solid, v.vertex);
    return best;
  }

 private:
  /// What the independent check found goes the way of the search's own findings.
  static void add_outside(const CurveNetwork& network, const EnclosureReport& check, Violations& found) {
    const std::size_t stars = std::size_t(std::count_if(network.splits.begin(), network.splits.end(),
                                                        [](const auto& split) { return split.has_value(); }));
    // Patches of the surface are whole ones, or quarters where some face is split.
    std::vector<Index> face;
    for (const CurveNetwork::Place& place : network.patch_places)
      face.insert(face.end(), stars > 0 && !network.splits[place.face] ? 4 : 1, place.face);
    for (const OutsidePoint& miss : check.points) {
      found.worst = std::max(found.worst, miss.distance);
      found.outside.push_back({face[miss.patch], miss.solid, miss.point, miss.distance});
    }
  }

  CurveNetwork make() {
    HullCageInput input;
    input.solids = solids_;
    input.growth = state_.sigma;
    input.diagonal = diagonal_;
    input.detail = settings_.detail;
    input.merge_angle = settings_.merge_angle;
    input.pinned = &state_.pinned;
    input.kept = &state_.kept;
    input.offsets = settings_.offsets;
    input.symmetry = settings_.symmetry;
    NetworkCage cage = hull_cage(input);
    if (grown_ && !cage.faces.empty()) cage = sunk(std::move(cage));
    cuts_ = state_.cuts;
    if (settings_.waists)
      for (const auto& [pair, factor] : *settings_.waists)
        cuts_.try_emplace(pair, 1.0).first->second *= factor;
    CurveSettings curves;
    curves.solids = solids_;
    curves.waist = settings_.waist;
    curves.cuts = &cuts_;
    curves.fullness = settings_.fullness;
    if (settings_.valleys) curves.slide = settings_.valleys->settings.slide;
    return curve_network(std::move(cage), curves);
  }

  NetworkCage sunk(NetworkCage hull) {
    grown_->grow(solids_, state_.sigma);
    ValleyCageInput input;
    input.solids = solids_;
    input.growth = state_.sigma;
    input.grown = &*grown_;
    input.diagonal = diagonal_;
    input.settings = settings_.valleys->settings;
    input.pushes = &state_.pushes;
    input.stars = &state_.stars;
    const auto of_hull = Index(hull.vertices.size());
    NetworkCage cage = valley_cage(std::move(hull), input);
    if (cage.faces.empty()) return cage;
    const auto even = [&] {
      if (settings_.symmetry) make_symmetric(cage, *settings_.symmetry, solids_, diagonal_);
    };
    even();
    if (settings_.symmetry && !cage.mirror) return {};
    if (settings_.offsets && pull_vertices(cage, of_hull, solids_, *settings_.offsets)) even();
    return !settings_.symmetry || cage.mirror ? cage : NetworkCage{};
  }

  /// What was changed for a solid is changed for its image.
  void even_state() {
    const SceneSymmetry& symmetry = *settings_.symmetry;
    for (Index s = 0; s < solids_.size(); ++s) {
      double& own = state_.sigma[s];
      double& other = state_.sigma[symmetry.solid[s]];
      own = other = std::max(own, other);
    }
    const std::map<std::pair<Index, Index>, double> cuts = state_.cuts;
    for (const auto& [pair, factor] : cuts) {
      const auto image = std::minmax(symmetry.solid[pair.first], symmetry.solid[pair.second]);
      double& other = state_.cuts.try_emplace(image, 1.0).first->second;
      other = std::min(other, factor);
    }
    for (std::set<SolidVertex>* corners : {&state_.pinned, &state_.stars})
      for (const SolidVertex& corner : std::vector<SolidVertex>(corners->begin(), corners->end()))
        corners->insert(symmetry.image(corner));
  }

  std::vector<Index> owners(const CurveNetwork& network, Index face) const {
    std::vector<Index> out;
    for (const Index v : network.cage.faces[face].loop)
      if (network.cage.vertices[v].solid != no_index) out.push_back(network.cage.vertices[v].solid);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  /// Tightens the bridges of a face; false where one is as taut as it may be.
  bool cut(const std::vector<Index>& owners, std::set<std::pair<Index, Index>>& changed) {
    for (std::size_t i = 0; i < owners.size(); ++i)
      for (std::size_t j = i + 1; j < owners.size(); ++j)
        if (const auto found = state_.cuts.find({owners[i], owners[j]});
            found != state_.cuts.end() && settings_.waist * found->second * cut_step < tautest_waist)
          return false;
    for (std::size_t i = 0; i < owners.size(); ++i)
      for (std::size_t j = i + 1; j < owners.size(); ++j)
        if (changed.insert({owners[i], owners[j]}).second)
          state_.cuts.try_emplace({owners[i], owners[j]}, 1.0).first->second *= cut_step;
    return true;
  }

  bool pin(const CurveNetwork& network, const Violations& found) {
    if (found.outside.empty()) return false;
    const auto worst = std::max_element(found.outside.begin(), found.outside.end(),
                                        [](const auto& a, const auto& b) { return a.height < b.height; });
    const PlacedSolid& solid = solids_[worst->solid];
    Index nearest = 0;
    double least = 1e300;
    for (Index v = 0; v < solid.unit_vertices.size(); ++v)
      if (const double square = (solid.world(solid.unit_vertices[v]) - worst->point).squaredNorm();
          square < least)
        least = square, nearest = v;
    const SolidVertex key{worst->solid, nearest};
    // Pins close to each other make slivers; growth reaches what lies that close to a pinned vertex.
    const Vector3 place = solid.world(solid.unit_vertices[nearest], state_.sigma[worst->solid]);
    for (const auto& [s, v] : state_.pinned)
      if ((solids_[s].world(solids_[s].unit_vertices[v], state_.sigma[s]) - place).norm() <
          pin_spacing * settings_.detail * diagonal_)
        return false;
    const bool used =
        std::any_of(network.cage.vertices.begin(), network.cage.vertices.end(),
                    [&](const auto& v) { return v.solid == key.first && v.vertex == key.second; });
    return !used && state_.pinned.insert(key).second;
  }

  /// Corners of solids that stay far outside are put into the faces that cut them off.
  bool add_stars(const CurveNetwork& network, const Violations& found) {
    double worst = star_worst * settings_.tolerance * diagonal_ / star_share;
    for (const auto& violation : found.outside) worst = std::max(worst, violation.height);
    bool added = false;
    for (const auto& violation : found.outside) {
      if (violation.height < star_share * worst) continue;
      const PlacedSolid& solid = solids_[violation.solid];
      double least = star_reach * diagonal_;
      Index nearest = no_index;
      for (Index v = 0; v < solid.unit_vertices.size(); ++v)
        if (const double d = (solid.world(solid.unit_vertices[v]) - violation.point).norm(); d < least)
          least = d, nearest = v;
      if (nearest == no_index) continue;
      const Vector3 place = solid.world(solid.unit_vertices[nearest]);
      const bool hidden = std::any_of(solids_.begin(), solids_.end(), [&](const PlacedSolid& other) {
        return &other != &solid && other.depth(place) > 0;
      });
      const auto& vertices = network.cage.vertices;
      const bool used = std::any_of(vertices.begin(), vertices.end(), [&](const CageVertex& v) {
        return v.solid == violation.solid && v.vertex == nearest;
      });
      if (!hidden && !used) added = state_.stars.emplace(violation.solid, nearest).second || added;
    }
    return added;
  }

  void repair(const CurveNetwork& network, const Violations& all, int build) {
    Violations found = all;
    if (grown_) {
      if (build >= first_star_build && add_stars(network, all)) return;
      const Violations rest = push_valleys(network, all, *grown_, solids_, diagonal_, state_.pushes);
      // What the valleys have not reached by then, the solids have to.
      if (build < first_growing_build) found = rest;
    } else if (build >= first_pinning_build && pin(network, found)) {
      return;
    }
    const double largest = grown_ ? valley_growth : largest_,
                 step = grown_ ? valley_growth_step : growth_step;
    std::vector<double> wanted(solids_.size(), 0);
    std::set<std::pair<Index, Index>> changed;
    const auto grow = [&](Index solid, double depth) { wanted[solid] = std::max(wanted[solid], depth); };
    for (const auto& violation : found.in_solid) {
      const std::vector<Index> own = owners(network, violation.face);
      if (std::binary_search(own.begin(), own.end(), violation.solid))
        grow(violation.solid, violation.depth);
      else if (!(own.size() > 1 && cut(own, changed)))
        for (const Index o : own) grow(o, violation.depth);
    }
    for (const auto& violation : found.outside)
      for (const Index o : owners(network, violation.face)) grow(o, violation.height);
    for (std::size_t s = 0; s < wanted.size(); ++s)
      if (wanted[s] > 0)
        state_.sigma[s] =
            std::min(largest, state_.sigma[s] * (1 + std::min(step, 1.1 * wanted[s] / radius_[s]) + 1e-5));
  }

  std::span<const PlacedSolid> solids_;
  EnclosureSettings settings_;
  GrowthState state_;
  double largest_ = largest_growth;
  std::optional<GrownSolids> grown_;  ///< for valleys
  std::map<std::pair<Index, Index>, double> cuts_;
  EnvelopeGrid coarse_, fine_;
  double diagonal_ = 0;
  std::vector<double> radius_;
};

}  // namespace

EnclosedNetwork search_enclosure(std::span<const PlacedSolid> solids, const EnclosureSettings& settings,
                                 GrowthState start, const CancelToken& cancel) {
  return Search(solids, settings, std::move(start)).run(cancel);
}

EnclosureReport check_network(const CurveNetwork& network, std::span<const PlacedSolid> solids,
                              double diagonal, const CancelToken& cancel) {
  constexpr double chord_slack = 1e-5;  // of the diagonal: the triangles lie inside of a convex surface
  return check_enclosure(network_surface(network, Vector3::Zero()), solids, {16, 400, 0.001 * diagonal, true},
                         chord_slack * diagonal, cancel);
}

std::vector<Index> folded_patches(const CurveNetwork& network) {
  constexpr int cells = 10;
  const EnvelopeGrid grid(cells);
  std::vector<Vector3> positions(grid.point_count()), normals(grid.point_count());
  std::vector<Index> folded;
  for (Index p = 0; p < network.patches.size(); ++p) {
    grid.evaluate(network.patches[p], positions, normals);
    const auto at = [&](int i, int j) -> const Vector3& { return normals[std::size_t(j * (cells + 1) + i)]; };
    bool fold = false;
    for (int j = 1; j < cells; ++j)
      for (int i = 1; i < cells; ++i) {
        const double u = double(i) / cells, v = double(j) / cells;
        const Vector3 blend = (1 - u) * (1 - v) * at(0, 0) + u * (1 - v) * at(cells, 0) +
                              u * v * at(cells, cells) + (1 - u) * v * at(0, cells);
        fold = fold || !(at(i, j).dot(blend) > 0);
      }
    if (fold) folded.push_back(p);
  }
  return folded;
}

}  // namespace hariko
