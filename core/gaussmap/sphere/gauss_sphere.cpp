#include "core/gaussmap/sphere/gauss_sphere.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace hariko {
namespace {

/// Next site of each boundary site, in the direction in which the image lies on the left.
std::vector<Index> next_sites(const Outline& outline, bool reversed) {
  std::vector<Index> out(outline.point_count());
  Index first = 0;
  for (const OutlineLoop& loop : outline.loops) {
    const Index count = static_cast<Index>(loop.points.size());
    for (Index i = 0; i < count; ++i) {
      const Index after = (i + 1) % count;
      if (reversed)
        out[first + after] = first + i;
      else
        out[first + i] = first + after;
    }
    first += count;
  }
  return out;
}

}  // namespace

GaussSphere gauss_sphere(const Outline& outline, const OutlineSettings& settings, std::optional<Index> step,
                         const CancelToken& cancel) {
  GaussSphere out;
  for (const OutlineLoop& loop : outline.loops) {
    auto& image = out.loops.emplace_back();
    for (const Vector3& normal : loop.normals)
      if (normal.allFinite() && !normal.isZero()) image.push_back(normal.stableNormalized());
  }
  GaussOptions options = gauss_options(settings);
  Result<ControlPoints> made = control_points(outline, options, cancel);
  if (!made) {
    out.error = made.error();
    return out;
  }
  out.inserted = static_cast<Index>(made->points.size()) - made->boundary_count;
  if (step && *step < out.inserted) {
    options.most_points = *step;
    options.relaxation = 0;
    options.gap.reset();
    made = control_points(outline, options, cancel);
    if (!made) {
      out.error = made.error();
      return out;
    }
  }
  out.points = *std::move(made);
  if (settings.mode == GaussMode::position) return out;
  const bool reversed = curvature_sign(outline, settings.sign) == CurvatureSign::negative;
  std::vector<SphereMesh::Triangle> triangles = out.points->triangles;
  if (reversed)
    for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
  out.mesh.emplace(out.points->normals, next_sites(outline, reversed), std::move(triangles));
  return out;
}

std::vector<Vector3> tangent_facet(const GaussSphere& sphere, Index site) {
  if (!sphere.mesh || !sphere.points || sphere.mesh->is_boundary(site)) return {};
  const ControlPoints& points = *sphere.points;
  const SphereMesh::Ring& ring = sphere.mesh->ring(site);
  std::vector<Vector3> out;
  for (std::size_t k = 0; k < ring.neighbours.size(); ++k) {
    const Index a = ring.neighbours[k], b = ring.neighbours[(k + 1) % ring.neighbours.size()];
    Matrix3 planes;
    planes << points.normals[site].transpose(), points.normals[a].transpose(), points.normals[b].transpose();
    // Relative to the control point, so that planes far from the origin lose no digits.
    const Vector3& at = points.points[site];
    const Vector3 corner = planes.inverse() * Vector3(0, (points.points[a] - at).dot(points.normals[a]),
                                                      (points.points[b] - at).dot(points.normals[b]));
    if (!corner.allFinite()) return {};
    out.push_back(at + corner);
  }
  return out;
}

}  // namespace hariko
