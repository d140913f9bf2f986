#include "core/analysis/measures.hpp"

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/analysis/curvature.hpp"
#include "core/analysis/quadrature.hpp"
#include "core/base/parallel.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

struct PatchMeasures {
  double area = 0, volume = 0, bending = 0;
  Vector3 moment = Vector3::Zero();  ///< integral of the position over the area
  Vector3 facing = Vector3::Zero();  ///< integral of the normal over the area
};

PatchMeasures measure_patch(std::span<const PatchPoint> points, const DomainRule& rule) {
  PatchMeasures sum;
  for (std::size_t k = 0; k < rule.points.size(); ++k) {
    const PatchPoint& point = points[k];
    const Vector3 cross = point.ds.cross(point.dt);
    const double area = rule.weights[k] * cross.norm();
    sum.area += area;
    sum.volume += rule.weights[k] * point.position.dot(cross) / 3;
    sum.moment += area * point.position;
    sum.facing += rule.weights[k] * cross;
    if (const auto at = shape_operator(point)) sum.bending += area * at->squares();
  }
  return sum;
}

}  // namespace

Measures measure(const Surface& surface, const CancelToken& cancel) {
  Measures out;
  if (surface.patch_count() == 0) return out;
  const DomainRule rule = gauss_rule(surface.domain(), 10);
  const auto batch = surface.patches().batch(rule.points);
  std::vector<PatchMeasures> each(surface.patch_count());
  parallel_for(each.size(), 8, [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    std::vector<PatchPoint> points(rule.points.size());
    for (std::size_t p = begin; p < end; ++p) {
      const Index patch[] = {static_cast<Index>(p)};
      batch->evaluate(patch, Order::second, points);
      each[p] = measure_patch(points, rule);
    }
  });
  if (cancel.cancelled()) return out;

  double volume = 0;
  Vector3 moment = Vector3::Zero(), facing = Vector3::Zero();
  for (const PatchMeasures& patch : each) {
    out.area += patch.area;
    out.bending += patch.bending;
    volume += patch.volume;
    moment += patch.moment;
    facing += patch.facing;
  }
  // Volume about the centroid: the normals of a closed surface sum to zero except for the error of the
  // quadrature.
  if (out.area > 0) volume -= moment.dot(facing) / (3 * out.area);
  if (Adjacency(surface).closed()) out.volume = volume;
  return out;
}

}  // namespace hariko
