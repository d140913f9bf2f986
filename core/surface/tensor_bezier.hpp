#pragma once

// BezierPatchSet: tensor-product Bezier patches of any degree, polynomial or rational, as a PatchSet.

#include <vector>

#include "core/surface/bezier_patch.hpp"
#include "core/surface/patch.hpp"
#include "core/surface/triangle_collocation.hpp"

namespace hariko {

/// Tensor-product Bezier patches of possibly different degrees, polynomial or rational.
class BezierPatchSet final : public PatchSet {
 public:
  /// Takes patches that pass `check_patch` (asserted).
  explicit BezierPatchSet(std::vector<BezierPatch> patches);

  const BezierPatch& patch(Index i) const { return patches_[i]; }

  Domain domain() const override { return Domain::square; }
  Index patch_count() const override { return static_cast<Index>(patches_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;

  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const override;
  /// Degree of the hull: degree_s + degree_t where that is at most TriangleCollocation::max_degree, otherwise
  /// 0.
  int hull_degree(Index patch) const override;
  void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
            std::span<HullBall> out) const override;
  ExactForm exact_form(Index patch) const override { return patches_[patch]; }

 private:
  void rational_hull(Index patch, const ParameterTriangle& triangle, std::span<HullBall> out) const;

  std::vector<BezierPatch> patches_;
  /// Homogeneous control points (w x, w y, w z, w) of rational patches.
  std::vector<std::vector<Eigen::Vector4d>> homogeneous_;
};

}  // namespace hariko
