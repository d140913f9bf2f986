#include "core/approximation/surface_sampler.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Unit normal by the fast formula; by `unit_normal`, which avoids overflow and underflow, where necessary.
Vector3 quick_normal(const PatchPoint& point) {
  const Vector3 cross = point.ds.cross(point.dt);
  const double square = cross.squaredNorm(), sides = point.ds.squaredNorm() * point.dt.squaredNorm();
  const bool plain = square > 1e-12 * sides && square > 1e-200 && square < 1e200;
  return plain ? Vector3(cross / std::sqrt(square)) : unit_normal(point);
}

}  // namespace

BarycentricGrid::BarycentricGrid(int n) : density(n) {
  const GridPattern pattern{Domain::triangle, n};
  points = pattern.parameters();
  for (int side = 0; side < 3; ++side) sides[std::size_t(side)] = pattern.side(side);
}

const BarycentricGrid& barycentric_grid(int density) {
  constexpr int highest = 12;
  static std::array<std::once_flag, highest + 1> made;
  static std::array<std::unique_ptr<const BarycentricGrid>, highest + 1> grids;
  HARIKO_ASSERT(density >= 1 && density <= highest, "density out of range");
  const auto at = std::size_t(density);
  std::call_once(made[at], [&] { grids[at] = std::make_unique<const BarycentricGrid>(density); });
  return *grids[at];
}

Vector3 SurfaceSampler::position(Index patch, const Vector2& parameter) const {
  return patches().evaluate(patch, parameter, Order::first).position;
}

Vector3 SurfaceSampler::normal(Index patch, const Vector2& parameter) const {
  PatchPoint point;
  patches().first_order(patch, {&parameter, 1}, {&point, 1});
  const Vector3 out = quick_normal(point);
  return out.isZero(0) ? patches().inner_normal(patch, parameter) : out;
}

void SurfaceSampler::normals(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const {
  constexpr std::size_t block = 32;
  std::array<PatchPoint, block> points;
  for (std::size_t begin = 0; begin < parameters.size(); begin += block) {
    const std::size_t count = std::min(block, parameters.size() - begin);
    patches().first_order(patch, parameters.subspan(begin, count), {points.data(), count});
    for (std::size_t k = 0; k < count; ++k) {
      out[begin + k] = quick_normal(points[k]);
      if (out[begin + k].isZero(0)) out[begin + k] = patches().inner_normal(patch, parameters[begin + k]);
    }
  }
}

}  // namespace hariko
