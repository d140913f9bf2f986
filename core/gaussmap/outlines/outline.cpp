#include "core/gaussmap/outlines/outline.hpp"

#include <cmath>

namespace hariko {

std::size_t Outline::point_count() const {
  std::size_t count = 0;
  for (const OutlineLoop& loop : loops) count += loop.points.size();
  return count;
}

bool Outline::has_curvature() const {
  for (const OutlineLoop& loop : loops)
    if (loop.curvature.size() != loop.points.size()) return false;
  return !loops.empty();
}

double Outline::size() const {
  Vector3 low = Vector3::Constant(HUGE_VAL), high = -low;
  for (const OutlineLoop& loop : loops)
    for (const Vector3& point : loop.points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  return point_count() == 0 ? 0 : (high - low).norm();
}

std::string to_string(const Outline& outline, const OutlinePoint& point) {
  std::string text = "point " + std::to_string(point.place);
  if (outline.loops.size() > 1) text += " of loop " + std::to_string(point.loop);
  return text;
}

OutlinePoint outline_point(const Outline& outline, Index number) {
  OutlinePoint out{0, number, number};
  while (out.place >= outline.loops[out.loop].points.size()) {
    out.place -= outline.loops[out.loop].points.size();
    ++out.loop;
    HARIKO_ASSERT(out.loop < outline.loops.size(), "no point has this number");
  }
  return out;
}

}  // namespace hariko
