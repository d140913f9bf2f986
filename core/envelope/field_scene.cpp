#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "core/envelope/bar_rings.hpp"
#include "core/envelope/field_cage.hpp"
#include "core/envelope/network_cage.hpp"

namespace hariko {

namespace {

constexpr double touching = 0.02;  ///< of the least thickness
constexpr double bridged = 1.5;    ///< of the thinner solid
constexpr double closing = 0.4;    ///< of the thinner solid: gaps between solids that are connected anyway
constexpr double bar_radius = 0.42, facing = 0.6, sunk = 0.3;

struct Gap {
  double distance;
  Index a, b;
};

class Clustering {
 public:
  Clustering(FieldScene& scene, const EnvelopeInput& input)
      : scene_(scene), solids_(input.solids), settings_(input.settings), parent_(scene.distances.size()) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  void run() {
    measure();
    double least = 1e300;
    for (const SolidDistance& d : scene_.distances) least = std::min(least, d.thickness());
    std::vector<std::pair<Gap, bool>> bars;
    for (const Gap& gap : gaps_) {
      const double thin = thinner(gap);
      const bool apart = find(gap.a) != find(gap.b);
      if (gap.distance < touching * least) {
        join(gap);
        scene_.fillets[std::minmax(gap.a, gap.b)] = wanted_fillet(gap);
      } else if (apart && gap.distance <= bridged * thin) {
        join(gap);
        bars.push_back({gap, true});
      } else if (!apart && scene_.distances.size() < 12 && gap.distance <= closing * thin &&
                 free_between(gap)) {
        bars.push_back({gap, false});
      }
    }
    std::vector<Index> number(parent_.size(), no_index);
    for (Index s = 0; s < parent_.size(); ++s) {
      Index& n = number[find(s)];
      if (n == no_index) n = Index(scene_.clusters.size()), scene_.clusters.emplace_back();
      scene_.clusters[n].solids.push_back(s);
    }
    for (const auto& [gap, needed] : bars) scene_.clusters[number[find(gap.a)]].bars.push_back(bar(gap));
  }

 private:
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(const Gap& gap) {
    parent_[std::max(find(gap.a), find(gap.b))] = std::min(find(gap.a), find(gap.b));
  }
  double thinner(const Gap& gap) const {
    return std::min(scene_.distances[gap.a].thickness(), scene_.distances[gap.b].thickness());
  }

  void measure() {
    const auto one_way = [&](Index a, Index b) {
      double least = 1e300;
      for (const Vector3& p : scene_.points[a]) least = std::min(least, scene_.distances[b](p));
      return least;
    };
    for (Index a = 0; a < scene_.distances.size(); ++a)
      for (Index b = a + 1; b < scene_.distances.size(); ++b) {
        const SolidDistance &da = scene_.distances[a], &db = scene_.distances[b];
        const double bound = (da.centre() - db.centre()).norm() - da.reach() - db.reach();
        if (bound > bridged * std::min(da.thickness(), db.thickness())) continue;
        gaps_.push_back({std::min(one_way(a, b), one_way(b, a)), a, b});
      }
    std::stable_sort(gaps_.begin(), gaps_.end(),
                     [](const Gap& x, const Gap& y) { return x.distance < y.distance; });
  }

  /// Mean of the points of a that face b.
  Vector3 face_of(Index a, Index b, const Gap& gap) const {
    Vector3 sum = Vector3::Zero();
    double weights = 0;
    for (const Vector3& p : scene_.points[a]) {
      const double x = std::max(0.0, 1 - (scene_.distances[b](p) - gap.distance) / (facing * thinner(gap)));
      sum += x * x * p;
      weights += x * x;
    }
    return weights > 0 ? Vector3(sum / weights) : scene_.distances[a].centre();
  }

  bool free_between(const Gap& gap) const {
    const Vector3 middle = 0.5 * (face_of(gap.a, gap.b, gap) + face_of(gap.b, gap.a, gap));
    for (Index s = 0; s < scene_.distances.size(); ++s)
      if (s != gap.a && s != gap.b && scene_.distances[s](middle) < 0.2 * gap.distance) return false;
    return true;
  }

  double wanted_fillet(const Gap& gap) const {
    return wanted_thickness(settings_, SolidPair::of(solids_[gap.a].id, solids_[gap.b].id));
  }

  FieldBar bar(const Gap& gap) const {
    const double radius = bar_radius * thinner(gap);
    const auto end = [&](Index a, Index b) {
      Vector3 p = face_of(a, b, gap);
      const SolidDistance& d = scene_.distances[a];
      for (int step = 0; step < 40 && d(p) > -sunk * radius; ++step) p -= 0.1 * radius * d.gradient(p);
      return p;
    };
    const Vector3 from = end(gap.a, gap.b), to = end(gap.b, gap.a);
    // Its ends are sunk into solids of different sizes, so the middle of what can be seen is another.
    const Vector3 middle = 0.5 * (face_of(gap.a, gap.b, gap) + face_of(gap.b, gap.a, gap));
    return {SolidPair::of(solids_[gap.a].id, solids_[gap.b].id), middle, (to - from).stableNormalized(),
            radius, SolidDistance::capsule(from, to, radius)};
  }

  FieldScene& scene_;
  std::span<const Solid> solids_;
  const EnvelopeSettings& settings_;
  std::vector<Index> parent_;
  std::vector<Gap> gaps_;
};

}  // namespace

FieldScene field_scene(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                       const Vector3& origin) {
  FieldScene scene;
  for (const Solid& solid : input.solids)
    scene.distances.emplace_back(solid, input.settings.clearance, origin);
  scene.points.resize(input.solids.size());
  for (const PlacedSolid& solid : placed)
    for (const Vector3& p : solid.test_points) scene.points[solid.owner].push_back(p);
  scene.diagonal = scene_diagonal(placed);
  if (input.settings.symmetry != SymmetryPlane::none)
    scene.symmetry = static_cast<Eigen::Index>(input.settings.symmetry) - 1;
  Clustering(scene, input).run();
  return scene;
}

}  // namespace hariko
