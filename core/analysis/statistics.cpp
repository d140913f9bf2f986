#include "core/analysis/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/analysis/curvature.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr int density = 8;
constexpr std::size_t patches_per_task = 32;

struct Sum {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  CurvatureStatistics range{
      {infinity, -infinity}, {infinity, -infinity}, {infinity, -infinity}, {infinity, -infinity}};
  bool any = false;

  static void widen(CurvatureRange& range, const CurvatureRange& by) {
    range.least = std::min(range.least, by.least);
    range.greatest = std::max(range.greatest, by.greatest);
  }
  void add(const ShapeOperator& at) {
    const double mean = at.mean(), gauss = at.gauss(), radius = std::hypot((at.t11 - at.t22) / 2, at.t12);
    add({{gauss, gauss}, {mean, mean}, {mean + radius, mean + radius}, {mean - radius, mean - radius}});
    any = true;
  }
  void add(const CurvatureStatistics& by) {
    widen(range.gauss, by.gauss);
    widen(range.mean, by.mean);
    widen(range.k1, by.k1);
    widen(range.k2, by.k2);
  }
};

}  // namespace

std::optional<CurvatureStatistics> curvature_statistics(const Surface& surface, const CancelToken& cancel) {
  if (surface.patch_count() == 0) return std::nullopt;
  const PatchSet& patches = surface.patches();
  const GridPattern pattern{surface.domain(), density};
  const int corners = corner_count(surface.domain());
  const auto count = static_cast<std::size_t>(pattern.point_count());
  std::vector<Sum> each((surface.patch_count() + patches_per_task - 1) / patches_per_task);

  parallel_for(each.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<PatchPoint> points(count);
    std::vector<char> skip(count);
    for (std::size_t task = begin; task < end && !cancel.cancelled(); ++task) {
      const std::size_t last = std::min<std::size_t>(surface.patch_count(), (task + 1) * patches_per_task);
      for (std::size_t p = task * patches_per_task; p < last; ++p) {
        const Index patch[] = {static_cast<Index>(p)};
        patches.evaluate_grid(patch, pattern, points);
        std::fill(skip.begin(), skip.end(), char{0});
        for (int c = 0; c < corners; ++c)
          if (patches.second_order_at_corner(patch[0], c) != CornerSecondOrder::exact)
            skip[static_cast<std::size_t>(pattern.side(c)[0])] = 1;
        for (std::size_t i = 0; i < count; ++i)
          if (!skip[i])
            if (const auto at = shape_operator(points[i])) each[task].add(*at);
      }
    }
  });
  Sum total;
  for (const Sum& sum : each)
    if (sum.any) {
      total.add(sum.range);
      total.any = true;
    }
  if (!total.any || cancel.cancelled()) return std::nullopt;
  return total.range;
}

}  // namespace hariko
