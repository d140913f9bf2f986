#include "core/drawing/occlusion.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr double bin_size = 8;  ///< of the page
constexpr int most_bins = 512;  ///< along a side

int bin_count(double length) {
  return std::clamp(int(std::ceil(length / bin_size)), 1, most_bins);
}

double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

Occlusion::Occlusion(const DrawingView& view)
    : view_(view), columns_(bin_count(view.width)), rows_(bin_count(view.height)) {
  bins_.resize(std::size_t(columns_) * std::size_t(rows_));
}

int Occlusion::column(double x) const {
  return std::clamp(int(std::floor(std::clamp(x / view_.width, -1.0, 2.0) * columns_)), 0, columns_ - 1);
}
int Occlusion::row(double y) const {
  return std::clamp(int(std::floor(std::clamp(y / view_.height, -1.0, 2.0) * rows_)), 0, rows_ - 1);
}

void Occlusion::add(const std::array<Vector3, 3>& triangle) {
  if (!view_.section) return add_clipped(triangle);
  std::vector<Vector3> kept;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 &a = triangle[k], &b = triangle[(k + 1) % 3];
    const double from = view_.section->signedDistance(a), to = view_.section->signedDistance(b);
    if (from <= 0) kept.push_back(a);
    if ((from <= 0) != (to <= 0)) kept.push_back(a + from / (from - to) * (b - a));
  }
  for (std::size_t k = 2; k < kept.size(); ++k) add_clipped({kept[0], kept[k - 1], kept[k]});
}

void Occlusion::add_clipped(const std::array<Vector3, 3>& triangle) {
  Triangle out;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 p = view_.project(triangle[k]);
    if (!view_.in_front(p.z()) || !p.allFinite()) return;
    out.page[k] = p.head<2>();
    out.nearness[k] = nearness(p.z());
  }
  const auto number = std::uint32_t(triangles_.size());
  triangles_.push_back(out);
  const auto [left, right] = std::minmax({out.page[0].x(), out.page[1].x(), out.page[2].x()});
  const auto [top, bottom] = std::minmax({out.page[0].y(), out.page[1].y(), out.page[2].y()});
  for (int r = row(top); r <= row(bottom); ++r)
    for (int c = column(left); c <= column(right); ++c)
      bins_[std::size_t(r) * std::size_t(columns_) + std::size_t(c)].push_back(number);
}

bool Occlusion::hides(const Vector3& point, double slack) const {
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
