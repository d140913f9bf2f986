#include "core/envelope/cage_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace hariko {

namespace {

constexpr int sample_density = 6;  ///< 28 samples a patch
constexpr double overshoot = 1.15;
constexpr double largest_step = 0.25, largest_push = 1.0;  ///< of the cell
constexpr int strict_rounds = 10;
constexpr int check_density = 8, check_points = 200;
constexpr double chord_slack = 2e-5;  ///< of the diagonal

}  // namespace

Shaping length_tensions(const Polyhedron& cage) {
  const HalfEdgeMesh& mesh = cage.topology();
  std::vector<double> length;
  double mean = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    length.push_back((cage.position(mesh.origin(h)) - cage.position(mesh.target(h))).norm());
    mean += length.back() / double(mesh.edge_count());
  }
  Shaping out;
  std::vector<std::pair<EdgeId, double>> betas;
  for (Index e = 0; e < mesh.edge_count(); ++e)
    betas.emplace_back(cage.edge_id(e),
                       std::clamp(std::pow(mean / std::max(length[e], 1e-9 * mean), 0.7), 0.2, 5.0));
  std::sort(betas.begin(), betas.end());
  for (const auto& [edge, beta] : betas) out.beta.set(edge, beta);
  return out;
}

namespace {

class Pusher {
 public:
  Pusher(const CageSurfaceRequest& request, Polyhedron cage)
      : request_(request),
        input_{cage, length_tensions(cage), Mode::fair, request.origin},
        pattern_{Domain::triangle, sample_density},
        parameters_(pattern_.parameters()) {
    const HalfEdgeMesh& mesh = cage.topology();
    neighbours_.resize(mesh.vertex_count());
    for (Index h = 0; h < mesh.half_edge_count(); ++h) neighbours_[mesh.origin(h)].push_back(mesh.target(h));
    moved_.assign(mesh.vertex_count(), 0);
  }

  Result<CageSurface> run(const CancelToken& cancel) {
    CageSurface out{{}, input_.polyhedron, input_.shaping, 0, {}, 0, 0};
    int strict = 0;
    const double tolerance = request_.tolerance * request_.diagonal;
    for (;;) {
      auto made = surfacer_.rebuild(input_, Quality::final, cancel);
      if (!made) return made.error();
      out.made = std::move(made).value();
      pushes_.clear();
      pushes_.resize(moved_.size());
      take_samples(out.made.surface);
      out.worst = test();
      if (out.worst <= tolerance || out.rounds >= request_.rounds) {
        if (!request_.strict) break;
        out.check = check_enclosure(out.made.surface, request_.placed, check_density, check_points,
                                    chord_slack * request_.diagonal, cancel);
        if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
        if (out.check->worst <= 0.9 * tolerance || strict++ >= strict_rounds) break;
        pushes_.assign(moved_.size(), {});
        push_outside(*out.check);
      }
      ++out.rounds;
      apply();
    }
    out.folds = folds();
    out.cage = input_.polyhedron;
    return out;
  }

 private:
  struct Push {
    Vector3 direction = Vector3::Zero();  ///< weighted by depth
    double length = 0;
  };

  const HalfEdgeMesh& mesh() const { return input_.polyhedron.topology(); }

  void take_samples(const Surface& surface) {
    std::vector<Index> all(surface.patch_count());
    std::iota(all.begin(), all.end(), Index{0});
    per_patch_ = std::size_t(pattern_.point_count());
    positions_.resize(all.size() * per_patch_);
    normals_.resize(positions_.size());
    surface.patches().evaluate_grid(all, pattern_, positions_, normals_);
    centre_.clear();
    radius_.clear();
    for (std::size_t p = 0; p < all.size(); ++p) {
      const auto points = std::span(positions_).subspan(p * per_patch_, per_patch_);
      Vector3 low = points[0], high = points[0];
      for (const Vector3& x : points) low = low.cwiseMin(x), high = high.cwiseMax(x);
      centre_.push_back(0.5 * (low + high));
      radius_.push_back(0.5 * (high - low).norm());
    }
  }

  /// Lets the corners of a sample's face go along a direction, by shares that lift the sample by `depth`.
  void push(std::size_t sample, double depth, const Vector3& direction) {
    const auto patch = Index(sample / per_patch_);
    const Vector2& parameter = parameters_[sample % per_patch_];
    const Index face = mesh().face(patch), from = mesh().face_begin(face), to = mesh().face_end(face);
    const double central = (1 - parameter.x() - parameter.y()) / double(to - from);
    double squares = 0;
    const auto weight = [&](Index h) {
      return central + (mesh().origin(h) == mesh().origin(patch) ? parameter.x() : 0.0) +
             (mesh().origin(h) == mesh().target(patch) ? parameter.y() : 0.0);
    };
    for (Index h = from; h < to; ++h) squares += weight(h) * weight(h);
    for (Index h = from; h < to; ++h) {
      const double length = std::min(weight(h) / squares, 1.0) * depth;
      Push& at = pushes_[mesh().origin(h)];
      at.direction += length * direction;
      at.length = std::max(at.length, length);
    }
  }

  double test() {
    double worst = 0;
    const double tolerance = request_.tolerance * request_.diagonal;
    for (std::size_t p = 0; p < centre_.size(); ++p)
      for (const SolidDistance& solid : request_.distances) {
        if ((centre_[p] - solid.centre()).norm() > radius_[p] + solid.reach()) continue;
        for (std::size_t i = p * per_patch_; i < (p + 1) * per_patch_; ++i) {
          const double depth = -solid(positions_[i]);
          worst = std::max(worst, depth);
          if (!(depth > tolerance)) continue;
          const Vector3 g = solid.gradient(positions_[i]);
          push(i, depth, g.dot(normals_[i]) < 0.3 ? normals_[i] : g);
        }
      }
    for (const PlacedSolid& solid : request_.placed)
      for (const Vector3& z : solid.test_points) {
        const std::size_t near = nearest(z);
        const double height = (z - positions_[near]).dot(normals_[near]);
        worst = std::max(worst, height);
        if (height > tolerance) push(near, height, normals_[near]);
      }
    return worst;
  }

  std::size_t nearest(const Vector3& z) {
    order_.clear();
    for (std::size_t p = 0; p < centre_.size(); ++p)
      order_.emplace_back(std::max(0.0, (z - centre_[p]).norm() - radius_[p]), p);
    std::sort(order_.begin(), order_.end());
    double square = 1e300;
    std::size_t best = 0;
    for (const auto& [bound, p] : order_) {
      if (bound * bound >= square) break;
      for (std::size_t i = p * per_patch_; i < (p + 1) * per_patch_; ++i)
        if (const double s = (positions_[i] - z).squaredNorm(); s < square) square = s, best = i;
    }
    return best;
  }

  void push_outside(const EnclosureReport& check) {
    for (const OutsidePoint& miss : check.points) {
      std::size_t best = miss.patch * per_patch_;
      double square = 1e300;
      for (std::size_t i = miss.patch * per_patch_; i < (miss.patch + 1) * per_patch_; ++i)
        if (const double s = (positions_[i] - miss.point).squaredNorm(); s < square) square = s, best = i;
      push(best, miss.distance + 0.3 * request_.tolerance * request_.diagonal, normals_[best]);
    }
  }

  void apply() {
    std::vector<Vector3> move(moved_.size(), Vector3::Zero());
    for (std::size_t v = 0; v < move.size(); ++v) {
      if (!(pushes_[v].length > 0)) continue;
      const double length = std::min({overshoot * pushes_[v].length, largest_step * request_.cell[v],
                                      std::max(0.0, largest_push * request_.cell[v] - moved_[v])});
      move[v] = length * pushes_[v].direction.stableNormalized();
    }
    // Who stays behind its neighbours would make a dimple.
    const std::vector<Vector3> before = move;
    for (std::size_t v = 0; v < move.size(); ++v) {
      Vector3 mean = Vector3::Zero();
      for (const Index w : neighbours_[v]) mean += before[w] / double(neighbours_[v].size());
      if (before[v].norm() < 0.5 * mean.norm()) move[v] = 0.5 * mean;
    }
    std::vector<Index> vertices;
    std::vector<Vector3> positions;
    for (Index v = 0; v < move.size(); ++v) {
      moved_[v] += move[v].norm();
      vertices.push_back(v);
      positions.push_back(input_.polyhedron.position(v) + move[v]);
    }
    auto next = input_.polyhedron.with_positions(vertices, positions);
    if (next) input_.polyhedron = std::move(next).value();
  }

  std::size_t folds() const {
    std::size_t out = 0;
    const Polyhedron& cage = input_.polyhedron;
    for (Index f = 0; f < mesh().face_count(); ++f) {
      Vector3 area = Vector3::Zero();
      const Vector3& o = cage.position(mesh().origin(mesh().face_begin(f)));
      for (Index h = mesh().face_begin(f); h < mesh().face_end(f); ++h)
        area += (cage.position(mesh().origin(h)) - o).cross(cage.position(mesh().target(h)) - o);
      area = area.stableNormalized();
      for (Index h = mesh().face_begin(f); h < mesh().face_end(f); ++h) {
        bool folded = false;
        for (std::size_t i = h * per_patch_; i < (h + 1) * per_patch_; ++i)
          folded = folded || normals_[i].dot(area) < -0.1;
        out += folded;
      }
    }
    return out;
  }

  const CageSurfaceRequest& request_;
  PolyhedronSurfaceInput input_;
  PolyhedronSurfacer surfacer_;
  GridPattern pattern_;
  std::vector<Vector2> parameters_;
  std::vector<std::vector<Index>> neighbours_;
  std::vector<double> moved_;
  std::vector<Push> pushes_;
  std::size_t per_patch_ = 0;
  std::vector<Vector3> positions_, normals_, centre_;
  std::vector<double> radius_;
  std::vector<std::pair<double, std::size_t>> order_;
};

}  // namespace

Result<CageSurface> cage_surface(const CageSurfaceRequest& request, const CancelToken& cancel) {
  auto cage = Polyhedron::build(request.cage);
  if (!cage) return cage.error();
  return Pusher(request, std::move(cage).value()).run(cancel);
}

}  // namespace hariko
