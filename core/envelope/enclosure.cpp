#include "core/envelope/enclosure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr int coarse_cells = 14, fine_cells = 28;
constexpr double largest_growth = 1.6;
constexpr double tautest_waist = 0.25;  ///< of what the search makes of bridges
constexpr double cut_step = 0.6;
constexpr int first_pinning_build = 4;
constexpr double pin_spacing = 0.4;  ///< of the thinning distance

/// The samples of one build, patch by patch, with a ball round each patch.
struct Samples {
  std::size_t per_patch = 0;
  std::vector<Vector3> positions, normals;
  std::vector<Vector3> centre;
  std::vector<double> radius;
};

Samples take_samples(const CurveNetwork& network, const EnvelopeGrid& grid) {
  Samples out;
  out.per_patch = grid.point_count();
  out.positions.resize(out.per_patch * network.patches.size());
  out.normals.resize(out.positions.size());
  for (std::size_t p = 0; p < network.patches.size(); ++p) {
    const std::span positions = std::span(out.positions).subspan(p * out.per_patch, out.per_patch);
    grid.evaluate(network.patches[p], positions,
                  std::span(out.normals).subspan(p * out.per_patch, out.per_patch));
    Vector3 low = positions[0], high = positions[0];
    for (const Vector3& x : positions) low = low.cwiseMin(x), high = high.cwiseMax(x);
    const Vector3 centre = 0.5 * (low + high);
    double square = 0;
    for (const Vector3& x : positions) square = std::max(square, (x - centre).squaredNorm());
    out.centre.push_back(centre);
    out.radius.push_back(std::sqrt(square));
  }
  return out;
}

/// Deepest sample of a face in a solid, and the worst test point of a solid outside.
struct Violations {
  struct InSolid {
    Index face, solid;
    double depth;
  };
  struct Outside {
    Index face, solid;
    Vector3 point;
    double height;
  };
  std::vector<InSolid> in_solid;  ///< one a face and solid
  std::vector<Outside> outside;   ///< one a face and solid, the worst
  double worst = 0;
};

class EnclosureTest {
 public:
  EnclosureTest(const CurveNetwork& network, std::span<const PlacedSolid> solids, double tolerance)
      : network_(network), solids_(solids), tolerance_(tolerance) {}

  Violations run(const EnvelopeGrid& grid) {
    const Samples samples = take_samples(network_, grid);
    for (Index p = 0; p < network_.patches.size(); ++p) test_patch(samples, p);
    for (Index s = 0; s < solids_.size(); ++s)
      for (const Vector3& z : solids_[s].test_points) test_point(samples, s, z);
    return std::move(out_);
  }

 private:
  void test_patch(const Samples& samples, Index patch) {
    const Index face = network_.patch_places[patch].face;
    for (Index s = 0; s < solids_.size(); ++s) {
      const PlacedSolid& solid = solids_[s];
      const double far = solid.reach + samples.radius[patch];
      if ((samples.centre[patch] - solid.centre).squaredNorm() > far * far) continue;
      double deepest = 0;
      for (std::size_t i = 0; i < samples.per_patch; ++i)
        deepest = std::max(deepest, solid.depth(samples.positions[patch * samples.per_patch + i]));
      out_.worst = std::max(out_.worst, deepest);
      if (!(deepest > tolerance_)) continue;
      const auto known = std::find_if(out_.in_solid.begin(), out_.in_solid.end(),
                                      [&](const auto& v) { return v.face == face && v.solid == s; });
      if (known == out_.in_solid.end())
        out_.in_solid.push_back({face, s, deepest});
      else
        known->depth = std::max(known->depth, deepest);
    }
  }

  /// The least height above the tangent planes at the four nearest samples.
  void test_point(const Samples& samples, Index solid, const Vector3& z) {
    struct Near {
      double square;
      std::size_t sample;
    };
    std::array<Near, 4> near;
    near.fill({1e300, 0});
    order_.clear();
    for (Index p = 0; p < samples.centre.size(); ++p)
      order_.emplace_back(std::max(0.0, (z - samples.centre[p]).norm() - samples.radius[p]), p);
    std::sort(order_.begin(), order_.end());
    for (const auto& [bound, patch] : order_) {
      if (bound * bound >= near[3].square) break;
      for (std::size_t i = patch * samples.per_patch; i < (patch + 1) * samples.per_patch; ++i) {
        const double square = (samples.positions[i] - z).squaredNorm();
        if (square >= near[3].square) continue;
        std::size_t at = 3;
        while (at > 0 && near[at - 1].square > square) near[at] = near[at - 1], --at;
        near[at] = {square, i};
      }
    }
    double height = 1e300;
    for (const Near& n : near)
      height = std::min(height, (z - samples.positions[n.sample]).dot(samples.normals[n.sample]));
    out_.worst = std::max(out_.worst, height);
    if (!(height > tolerance_)) return;
    const Index face = network_.patch_places[near[0].sample / samples.per_patch].face;
    const auto known = std::find_if(out_.outside.begin(), out_.outside.end(),
                                    [&](const auto& v) { return v.face == face && v.solid == solid; });
    if (known == out_.outside.end())
      out_.outside.push_back({face, solid, z, height});
    else if (height > known->height)
      known->height = height, known->point = z;
  }

  const CurveNetwork& network_;
  std::span<const PlacedSolid> solids_;
  double tolerance_;
  Violations out_;
  std::vector<std::pair<double, Index>> order_;
};

class Search {
 public:
  Search(std::span<const PlacedSolid> solids, const EnclosureSettings& settings, GrowthState start)
      : solids_(solids),
        settings_(settings),
        state_(std::move(start)),
        coarse_(coarse_cells),
        fine_(fine_cells) {
    if (state_.sigma.size() != solids.size()) state_.sigma.assign(solids.size(), 1);
    diagonal_ = scene_diagonal(solids);
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
      Violations found = EnclosureTest(network, solids_, tolerance).run(coarse_);
      if (settings_.fine && found.worst <= tolerance)
        found = EnclosureTest(network, solids_, tolerance).run(fine_);
      std::optional<EnclosureReport> check;
      if (settings_.strict && found.worst <= tolerance) {
        check = check_network(network, solids_, diagonal_, cancel);
        add_outside(network, *check, found);
      }
      const bool better = found.worst < best.worst;
      if (found.worst > tolerance) repair(network, found, build);
      if (better) {
        best.worst = found.worst;
        best.enclosed = found.worst <= tolerance;
        best.network = std::move(network);
        best.state = used;
        best.check = std::move(check);
      }
      best.builds = build;
      if (best.enclosed) break;
    }
    best.diagonal = diagonal_;
    if (settings_.strict && !best.check && !best.network.patches.empty())
      best.check = check_network(best.network, solids_, diagonal_, cancel);
    best.state.kept.clear();
    for (const CageVertex& v : best.network.cage.vertices) best.state.kept.emplace(v.solid, v.vertex);
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
    NetworkCage cage = hull_cage(input);
    cuts_ = state_.cuts;
    if (settings_.waists)
      for (const auto& [pair, factor] : *settings_.waists)
        cuts_.try_emplace(pair, 1.0).first->second *= factor;
    CurveSettings curves;
    curves.solids = solids_;
    curves.waist = settings_.waist;
    curves.cuts = &cuts_;
    curves.fullness = settings_.fullness;
    return curve_network(std::move(cage), curves);
  }

  std::vector<Index> owners(const CurveNetwork& network, Index face) const {
    std::vector<Index> out;
    for (const Index v : network.cage.faces[face].loop) out.push_back(network.cage.vertices[v].solid);
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

  void repair(const CurveNetwork& network, const Violations& found, int build) {
    if (build >= first_pinning_build && pin(network, found)) return;
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
        state_.sigma[s] = std::min(
            largest_growth, state_.sigma[s] * (1 + std::min(0.05, 1.1 * wanted[s] / radius_[s]) + 1e-5));
  }

  std::span<const PlacedSolid> solids_;
  EnclosureSettings settings_;
  GrowthState state_;
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
  constexpr int density = 16, points = 400;
  constexpr double chord_slack = 1e-5;  // of the diagonal: the triangles lie inside of a convex surface
  return check_enclosure(network_surface(network, Vector3::Zero()), solids, density, points,
                         chord_slack * diagonal, cancel);
}

std::size_t folded_patches(const CurveNetwork& network) {
  constexpr int cells = 10;
  const EnvelopeGrid grid(cells);
  std::vector<Vector3> positions(grid.point_count()), normals(grid.point_count());
  std::size_t folded = 0;
  for (std::size_t p = 0; p < network.patches.size(); ++p) {
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
    folded += fold;
  }
  return folded;
}

}  // namespace hariko
