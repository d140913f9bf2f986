#include "core/offset/offset_folds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/analysis/curvature.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr int fold_density = 8;
constexpr std::size_t fold_patches_per_task = 4;
constexpr double smallest_step = 1e-4, left_out_at_corners = 1e-3;

/// Largest curvature towards one side on a patch.
struct Bend {
  double curvature = 0;
  Vector2 parameter = Vector2::Zero();
};

class BendSearch {
 public:
  BendSearch(const Surface& surface, Index patch) : surface_(surface), patch_(patch) {
    for (int c = 0; c < corner_count(surface.domain()); ++c)
      exact_[std::size_t(c)] = surface.patches().second_order_at_corner(patch, c) == CornerSecondOrder::exact;
  }

  /// Largest curvature for which `sign` is positive: 1 is away from the normal, so inside.
  Bend largest(const std::vector<Vector2>& parameters, std::span<const PatchPoint> points,
               double sign) const {
    Bend best;
    for (std::size_t k = 0; k < parameters.size(); ++k) take(best, parameters[k], points[k], sign);
    if (best.curvature > 0) climb(best, sign);
    return best;
  }

 private:
  bool allowed(const Vector2& q) const {
    const bool triangle = surface_.domain() == Domain::triangle;
    if (q.minCoeff() < 0 || q.maxCoeff() > 1 || (triangle && q.sum() > 1)) return false;
    for (int c = 0; c < corner_count(surface_.domain()); ++c)
      if (!exact_[std::size_t(c)] &&
          (q - corner_parameter(surface_.domain(), c)).cwiseAbs().maxCoeff() < left_out_at_corners)
        return false;
    return true;
  }
  bool take(Bend& best, const Vector2& q, const PatchPoint& point, double sign) const {
    if (!allowed(q)) return false;
    const auto k = curvature(point);
    if (!k) return false;
    const double bend = sign > 0 ? k->k1 : -k->k2;
    if (!(bend > best.curvature)) return false;
    best = {bend, q};
    return true;
  }
  /// Goes to the best of four neighbours, with half the step where none is better.
  void climb(Bend& best, double sign) const {
    constexpr int most_moves = 64;
    double step = 0.5 / fold_density;
    for (int move = 0; move < most_moves && step > smallest_step; ++move) {
      const Vector2 from = best.parameter;
      bool better = false;
      for (const Vector2& way : {Vector2(step, 0), Vector2(-step, 0), Vector2(0, step), Vector2(0, -step)}) {
        const Vector2 q = from + way;
        if (allowed(q)) better |= take(best, q, surface_.patches().evaluate(patch_, q, Order::second), sign);
      }
      if (!better) step /= 2;
    }
  }

  const Surface& surface_;
  Index patch_;
  std::array<bool, 4> exact_{};
};

}  // namespace

OffsetFolds offset_folds(const Surface& surface, double distance, const CancelToken& cancel) {
  OffsetFolds out;
  const Index count = surface.patch_count();
  if (count == 0) return out;
  const GridPattern pattern{surface.domain(), fold_density};
  const std::vector<Vector2> parameters = pattern.parameters();
  std::vector<std::array<Bend, 2>> bends(count);
  parallel_for(count, fold_patches_per_task, [&](std::size_t begin, std::size_t end) {
    std::vector<PatchPoint> points(parameters.size());
    for (std::size_t p = begin; p < end && !cancel.cancelled(); ++p) {
      const std::array<Index, 1> patch{Index(p)};
      surface.patches().evaluate_grid(patch, pattern, points);
      const BendSearch search(surface, Index(p));
      bends[p] = {search.largest(parameters, points, 1), search.largest(parameters, points, -1)};
    }
  });
  const std::size_t side = distance < 0 ? 0 : 1;
  double worst = 0;
  for (Index p = 0; p < count; ++p) {
    const auto& [inside, outside] = bends[p];
    if (inside.curvature > 0) out.inside = std::min(out.inside, 1 / inside.curvature);
    if (outside.curvature > 0) out.outside = std::min(out.outside, 1 / outside.curvature);
    const Bend& bend = bends[p][side];
    if (bend.curvature * std::abs(distance) >= 1) ++out.patches;
    if (bend.curvature > worst) {
      worst = bend.curvature;
      out.worst = p;
      out.place = surface.patches().evaluate(p, bend.parameter, Order::first).position;
    }
  }
  return out;
}

}  // namespace hariko
