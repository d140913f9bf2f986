#pragma once

// SurfaceSampler: points and normals of a surface for small parameter triangles, by the fastest way its
// patches offer.

#include <array>
#include <span>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Uniform grid on a triangle in barycentric coordinates, in the order of GridPattern.
struct BarycentricGrid {
  /// Makes the grid with `density` intervals per side.
  explicit BarycentricGrid(int density);
  int density;
  std::vector<Vector2> points;  ///< barycentric coordinates of corners 1 and 2
  /// Points on the sides from corner 0 to 1, 1 to 2, 2 to 0, in these directions.
  std::array<std::vector<int>, 3> sides;
};

/// Shared grid of a density from 1 to 12, made at its first use. Thread-safe.
const BarycentricGrid& barycentric_grid(int density);

/// Evaluator of a surface, to which it keeps a reference. Thread-safe.
class SurfaceSampler {
 public:
  explicit SurfaceSampler(const Surface& surface) : surface_(surface) {}

  const Surface& surface() const { return surface_; }
  const PatchSet& patches() const { return surface_.patches(); }

  Vector3 position(Index patch, const Vector2& parameter) const;
  /// Unit normal; where it is undefined, that of a point 1e-4 of the domain further inside. Zero if both
  /// fail.
  Vector3 normal(Index patch, const Vector2& parameter) const;
  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const {
    patches().positions(patch, parameters, out);
  }
  void normals(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const;
  PatchPoint second_order(Index patch, const Vector2& parameter) const {
    return patches().evaluate(patch, parameter, Order::second);
  }

 private:
  const Surface& surface_;
};

}  // namespace hariko
