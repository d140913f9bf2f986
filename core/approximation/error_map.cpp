#include "core/approximation/error_map.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/surface_projector.hpp"
#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr std::size_t points_per_task = 256;
/// Numbers of samples for meshes without parts: per facet, and at least and at most on the whole surface.
constexpr std::size_t samples_a_facet = 12, fewest_samples = 20'000, most_samples = 2'000'000;
/// Number of samples around which the largest distance is searched for.
constexpr std::size_t looked_round = 32;
constexpr int halvings = 7;
/// Offset from an edge at which its surface's normals are taken, relative to the way to the facet's opposite
/// corner.
constexpr double beside = 1e-3;

class ErrorMapper {
 public:
  ErrorMapper(const Surface& surface, const TriangleMesh& mesh, std::span<const ParameterFacet> parts,
              const ErrorMapOptions& options, const CancelToken& cancel)
      : sampler_(surface),
        mesh_(mesh),
        parts_(parts),
        options_(options),
        cancel_(cancel),
        positions_(moved(mesh, surface.origin())),
        tree_(positions_, mesh.triangles) {}

  bool run(const Progress& progress) {
    if (parts_.empty())
      sample_patches();
    else
      sample_parts();
    progress.report(0.1);
    compare_samples();
    progress.report(0.4);
    look_round_the_largest();
    progress.report(0.5);
    const SurfaceProjector feet(sampler_);
    measure_mesh(feet);
    progress.report(0.9);
    measure_folds(feet);
    progress.report(1);
    return !cancel_.cancelled();
  }
  MeshErrorMap take() { return std::move(map_); }

 private:
  static std::vector<Vector3> moved(const TriangleMesh& mesh, const Vector3& origin) {
    std::vector<Vector3> out = mesh.positions;
    const Vector3 by = mesh.origin - origin;
    for (Vector3& p : out) p += by;
    return out;
  }
  std::size_t facet_count() const { return mesh_.triangles.size(); }
  TriangleCorners corners(std::size_t facet) const {
    const auto& t = mesh_.triangles[facet];
    return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
  }
  template <class Body>
  void each(std::size_t count, const Body& body) const {
    parallel_for(count, points_per_task, [&](std::size_t begin, std::size_t end) {
      if (cancel_.cancelled()) return;
      for (std::size_t i = begin; i < end; ++i) body(i);
    });
  }

  void sample_parts() {
    const BarycentricGrid grid(options_.density);
    for (std::size_t f = 0; f < parts_.size(); ++f) {
      const ParameterPieces pieces = pieces_of(parts_[f]);
      map_.facet_samples.push_back(Index(map_.samples.size()));
      const auto p = corners(f);
      const double area = 0.5 * area_vector(p[0], p[1], p[2]).norm();
      for (int piece = 0; piece < pieces.count; ++piece)
        for (const Vector2& at : grid.points) {
          map_.samples.push_back({Vector3::Zero(), parts_[f].patch,
                                  at_barycentric(pieces.triangle[std::size_t(piece)], at.x(), at.y()),
                                  Index(f)});
          weight_.push_back(area / double(pieces.count * int(grid.points.size())));
        }
    }
  }
  void sample_patches() {
    const Surface& surface = sampler_.surface();
    const double wanted = double(std::clamp(samples_a_facet * facet_count(), fewest_samples, most_samples)) /
                          double(surface.patch_count());
    const bool square = surface.domain() == Domain::square;
    const GridPattern pattern{surface.domain(),
                              std::clamp(int(std::sqrt(square ? wanted : 2 * wanted)), 2, 512)};
    const auto parameters = pattern.parameters();
    for (Index p = 0; p < surface.patch_count(); ++p)
      for (const Vector2& at : parameters) map_.samples.push_back({Vector3::Zero(), p, at, no_index});
    weight_.resize(map_.samples.size());
    each(map_.samples.size(), [&](std::size_t i) {
      const SurfaceSample& sample = map_.samples[i];
      const PatchPoint at =
          sampler_.surface().patches().evaluate(sample.patch, sample.parameter, Order::first);
      weight_[i] = at.ds.cross(at.dt).norm();
    });
  }

  void compare_samples() {
    std::vector<SurfaceSample>& samples = map_.samples;
    map_.distance.points.resize(samples.size());
    map_.normal_angle.points.resize(samples.size());
    nearest_.resize(samples.size());
    each(samples.size(), [&](std::size_t i) {
      SurfaceSample& sample = samples[i];
      sample.position = sampler_.position(sample.patch, sample.parameter);
      TriangleTree::Nearest found;
      if (sample.facet == no_index) {
        found = tree_.nearest(sample.position);
        sample.facet = found.triangle;
      } else {
        const double own = tree_.triangle(sample.facet).distance(sample.position);
        found = tree_.nearest(sample.position, own);
        // Up to rounding, its own facet is as near as any.
        if (found.triangle == no_index || found.distance >= own * (1 - 1e-12)) found = {sample.facet, own};
      }
      nearest_[i] = found.triangle;
      map_.distance.points[i] = float(found.distance);
      const Vector3& facet = tree_.triangle(sample.facet).normal();
      const Vector3 normal = sampler_.normal(sample.patch, sample.parameter);
      map_.normal_angle.points[i] =
          facet.isZero(0) || normal.isZero(0) ? 0.0F : float(angle_between(facet, normal));
    });
    if (cancel_.cancelled()) return;
    gather(map_.distance, [&](std::size_t i) { return nearest_[i]; });
    gather(map_.normal_angle, [&](std::size_t i) { return samples[i].facet; });
  }
  template <class FacetOf>
  void gather(ErrorField& field, const FacetOf& facet_of_sample) {
    field.facets.assign(facet_count(), 0.0F);
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < map_.samples.size(); ++i) {
      const double value = double(field.points[i]);
      sum += weight_[i] * value;
      weights += weight_[i];
      const Index facet = facet_of_sample(i);
      note(field, facet, value, map_.samples[i].position);
    }
    if (weights > 0) field.mean = sum / weights;
  }
  static void note(ErrorField& field, Index facet, double value, const Vector3& place) {
    field.facets[facet] = std::max(field.facets[facet], float(value));
    if (!(value > field.largest)) return;
    field.largest = value;
    field.facet = facet;
    field.place = place;
  }

  /// Searches the neighbourhoods of the samples with the largest distances on ever finer crosses.
  void look_round_the_largest() {
    if (cancel_.cancelled()) return;
    std::vector<std::size_t> order(map_.samples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t count = std::min(looked_round, order.size());
    const std::vector<float>& value = map_.distance.points;
    std::partial_sort(
        order.begin(), order.begin() + std::ptrdiff_t(count), order.end(),
        [&](std::size_t a, std::size_t b) { return value[a] > value[b] || (value[a] == value[b] && a < b); });
    const double first =
        parts_.empty() ? 1 / std::sqrt(double(map_.samples.size()) / double(sampler_.surface().patch_count()))
                       : 0;
    for (std::size_t k = 0; k < count; ++k) {
      const SurfaceSample& sample = map_.samples[order[k]];
      double step = first;
      if (!parts_.empty()) {
        const auto& w = parts_[sample.facet].parameter;
        step = ((w[1] - w[0]).norm() + (w[2] - w[0]).norm()) / (2 * options_.density);
      }
      climb(sample, step);
    }
  }
  void climb(const SurfaceSample& sample, double step) {
    const bool square = sampler_.surface().domain() == Domain::square;
    Vector2 at = sample.parameter;
    double best = tree_.nearest(sample.position).distance;
    for (int round = 0; round < halvings; ++round, step /= 2) {
      const Vector2 centre = at;
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
          const Vector2 p = centre + step * Vector2(i, j);
          if (p.minCoeff() < 0 || (square ? p.maxCoeff() > 1 : p.sum() > 1)) continue;
          const Vector3 position = sampler_.position(sample.patch, p);
          const auto found = tree_.nearest(position);
          if (!(found.distance > best)) continue;
          best = found.distance;
          at = p;
          note(map_.distance, found.triangle, best, position);
        }
    }
  }

  void measure_mesh(const SurfaceProjector& feet) {
    ErrorField& field = map_.mesh_distance;
    field.points.assign(positions_.size(), 0.0F);
    std::vector<char> used(positions_.size(), 0);
    for (const auto& t : mesh_.triangles)
      for (const Index v : t) used[v] = 1;
    each(positions_.size(), [&](std::size_t v) {
      if (used[v]) field.points[v] = float(feet.foot(positions_[v]).distance);
    });
    std::vector<Vector2> inner;
    for (const Vector2& at : BarycentricGrid(options_.density).points)
      if (at.maxCoeff() < 1 && at.sum() > 0) inner.push_back(at);
    std::vector<std::pair<float, Vector3>> worst(facet_count(), {0.0F, Vector3::Zero()});
    std::vector<double> mean(facet_count(), 0.0);
    each(facet_count(), [&](std::size_t f) {
      const auto p = corners(f);
      double sum = 0;
      const auto look = [&](const Vector3& at, float distance) {
        sum += double(distance);
        if (distance > worst[f].first) worst[f] = {distance, at};
      };
      for (std::size_t c = 0; c < 3; ++c) look(p[c], field.points[mesh_.triangles[f][c]]);
      for (const Vector2& at : inner) {
        const Vector3 point = p[0] + at.x() * (p[1] - p[0]) + at.y() * (p[2] - p[0]);
        look(point, float(feet.foot(point).distance));
      }
      mean[f] = sum / double(inner.size() + 3);
    });
    if (cancel_.cancelled()) return;
    field.facets.assign(facet_count(), 0.0F);
    double sum = 0, areas = 0;
    for (std::size_t f = 0; f < facet_count(); ++f) {
      const auto p = corners(f);
      const double area = area_vector(p[0], p[1], p[2]).norm();
      sum += area * mean[f];
      areas += area;
      note(field, Index(f), double(worst[f].first), worst[f].second);
    }
    if (areas > 0) field.mean = sum / areas;
  }

  struct Edge {
    Index low, high, facet, corner;
    bool operator<(const Edge& other) const {
      return std::tie(low, high, facet, corner) < std::tie(other.low, other.high, other.facet, other.corner);
    }
  };
  /// Normal of the surface beside an edge, on a facet's side of it.
  Vector3 normal_beside(const SurfaceProjector& feet, const Edge& edge) const {
    if (!parts_.empty() && parts_[edge.facet].pole < 0) {
      const auto& w = parts_[edge.facet].parameter;
      return sampler_.normal(parts_[edge.facet].patch, 0.5 * (w[edge.corner] + w[(edge.corner + 1) % 3]));
    }
    const auto p = corners(edge.facet);
    const Vector3 middle = 0.5 * (p[edge.corner] + p[(edge.corner + 1) % 3]);
    const SurfaceFoot foot = feet.foot(middle + beside * (p[(edge.corner + 2) % 3] - middle));
    return sampler_.normal(foot.patch, foot.parameter);
  }
  void measure_folds(const SurfaceProjector& feet) {
    if (cancel_.cancelled()) return;
    ErrorField& field = map_.fold_angle;
    field.facets.assign(facet_count(), 0.0F);
    field.points.assign(positions_.size(), 0.0F);
    std::vector<Edge> edges;
    edges.reserve(3 * facet_count());
    for (Index f = 0; f < facet_count(); ++f)
      for (Index c = 0; c < 3; ++c) {
        const Index a = mesh_.triangles[f][c], b = mesh_.triangles[f][(c + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b), f, c});
      }
    std::sort(edges.begin(), edges.end());
    // Fold per pair of facets at one edge, which are adjacent in the order.
    std::vector<double> fold(edges.size(), -1.0);
    each(edges.size(), [&](std::size_t k) {
      if (k == 0 || edges[k].low != edges[k - 1].low || edges[k].high != edges[k - 1].high) return;
      const Vector3 &a = tree_.triangle(edges[k - 1].facet).normal(),
                    &b = tree_.triangle(edges[k].facet).normal();
      if (a.isZero(0) || b.isZero(0)) return;
      const double angle = angle_between(a, b);
      const bool crease =
          angle > options_.crease &&
          angle_between(normal_beside(feet, edges[k - 1]), normal_beside(feet, edges[k])) > options_.crease;
      if (!crease) fold[k] = angle;
    });
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (fold[k] < 0) continue;
      sum += fold[k];
      ++count;
      const Vector3 middle = 0.5 * (positions_[edges[k].low] + positions_[edges[k].high]);
      for (const Index f : {edges[k - 1].facet, edges[k].facet}) note(field, f, fold[k], middle);
      for (const Index v : {edges[k].low, edges[k].high})
        field.points[v] = std::max(field.points[v], float(fold[k]));
    }
    if (count > 0) field.mean = sum / double(count);
  }

  SurfaceSampler sampler_;
  const TriangleMesh& mesh_;
  std::span<const ParameterFacet> parts_;
  const ErrorMapOptions& options_;
  const CancelToken& cancel_;
  std::vector<Vector3> positions_;  ///< relative to the surface's origin
  TriangleTree tree_;
  std::vector<double> weight_;  ///< per sample: its share of the area
  std::vector<Index> nearest_;  ///< nearest facet of each sample
  MeshErrorMap map_;
};

}  // namespace

Result<MeshErrorMap> mesh_error_map(const Surface& surface, const TriangleMesh& mesh,
                                    std::span<const ParameterFacet> parts, const ErrorMapOptions& options,
                                    const CancelToken& cancel, const Progress& progress) {
  HARIKO_ASSERT(parts.empty() || parts.size() == mesh.triangles.size(), "one part a triangle");
  HARIKO_ASSERT(options.density >= 1 && options.density <= 16, "samples a facet's side");
  if (surface.patch_count() == 0 || mesh.triangles.empty())
    return make_error(e_mesh_nothing, "There is nothing to compare.",
                      "Select an object with a surface and a mesh of it.");
  ErrorMapper mapper(surface, mesh, parts, options, cancel);
  if (!mapper.run(progress)) return make_error(e_cancelled, "Measuring the mesh was cancelled.");
  return mapper.take();
}

}  // namespace hariko
