#include "core/drawing/page_occlusion.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr double bin_size = 8;  ///< page units
constexpr int most_bins = 512;  ///< along a side of the page

int bin_count(double length) {
  return std::clamp(int(std::ceil(length / bin_size)), 1, most_bins);
}

}  // namespace

PageOcclusion::PageOcclusion(const DrawingView& view)
    : view_(view), columns_(bin_count(view.width)), rows_(bin_count(view.height)) {
  bins_.resize(std::size_t(columns_) * std::size_t(rows_));
}

int PageOcclusion::column(double x) const {
  return std::clamp(int(std::floor(std::clamp(x / view_.width, -1.0, 2.0) * columns_)), 0, columns_ - 1);
}
int PageOcclusion::row(double y) const {
  return std::clamp(int(std::floor(std::clamp(y / view_.height, -1.0, 2.0) * rows_)), 0, rows_ - 1);
}

namespace {

/// Part of a convex polygon where a function that is linear on its sides is not negative.
template <class Function>
std::vector<Vector3> part_of(const std::vector<Vector3>& polygon, Function value) {
  std::vector<Vector3> out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double from = value(a), to = value(b);
    if (from >= 0) out.push_back(a);
    if ((from >= 0) != (to >= 0)) out.push_back(a + from / (from - to) * (b - a));
  }
  return out;
}

}  // namespace

void PageOcclusion::add(const std::array<Vector3, 3>& triangle) {
  const auto before_eye = [&](const Vector3& p) {
    return (p - view_.eye).dot(view_.forward) - 0.5 * view_.near_plane;
  };
  const bool whole = view_.orthographic || std::all_of(triangle.begin(), triangle.end(),
                                                       [&](const Vector3& p) { return before_eye(p) >= 0; });
  if (whole && !view_.section) return add_clipped(triangle);
  std::vector<Vector3> kept(triangle.begin(), triangle.end());
  if (!whole) kept = part_of(kept, before_eye);
  if (view_.section)
    kept = part_of(kept, [&](const Vector3& p) { return -view_.section->signedDistance(p); });
  for (std::size_t k = 2; k < kept.size(); ++k) add_clipped({kept[0], kept[k - 1], kept[k]});
}

void PageOcclusion::add_clipped(const std::array<Vector3, 3>& triangle) {
  Triangle out;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 p = view_.project(triangle[k]);
    if (!p.allFinite()) return;
    out.page[k] = p.head<2>();
    out.nearness[k] = nearness(p.z());
  }
  const auto [left, right] = std::minmax({out.page[0].x(), out.page[1].x(), out.page[2].x()});
  const auto [top, bottom] = std::minmax({out.page[0].y(), out.page[1].y(), out.page[2].y()});
  if (right < -page_margin || left > view_.width + page_margin || bottom < -page_margin ||
      top > view_.height + page_margin)
    return;
  const auto number = std::uint32_t(triangles_.size());
  triangles_.push_back(out);
  for (int r = row(top); r <= row(bottom); ++r)
    for (int c = column(left); c <= column(right); ++c)
      bins_[std::size_t(r) * std::size_t(columns_) + std::size_t(c)].push_back(number);
}

bool PageOcclusion::hides(const Vector3& point, double slack) const {
  const Vector3 p = view_.project(point);
  const Vector2 at = p.head<2>();
  const double own = nearness(p.z() - slack);
  for (const std::uint32_t number :
       bins_[std::size_t(row(at.y())) * std::size_t(columns_) + std::size_t(column(at.x()))]) {
    const Triangle& t = triangles_[number];
    std::array<double, 3> share;
    for (std::size_t k = 0; k < 3; ++k) share[k] = cross(t.page[(k + 1) % 3] - at, t.page[(k + 2) % 3] - at);
    const bool inside = (share[0] >= 0 && share[1] >= 0 && share[2] >= 0) ||
                        (share[0] <= 0 && share[1] <= 0 && share[2] <= 0);
    const double area = share[0] + share[1] + share[2];
    if (!inside || area == 0) continue;
    double near = 0;
    for (std::size_t k = 0; k < 3; ++k) near += share[k] / area * t.nearness[k];
    if (near > own) return true;
  }
  return false;
}

}  // namespace hariko
