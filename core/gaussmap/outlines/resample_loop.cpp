#include "core/gaussmap/outlines/resample_loop.hpp"

#include <algorithm>

#include "core/gaussmap/outlines/loop_curve.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/gaussmap/sphere/spherical_delaunay.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {
namespace {

constexpr int pieces = 32;  // samples of the curve between points, for measuring its length

void append(OutlineLoop& loop, const LoopCurve::Place& place, bool with_curvature) {
  loop.points.push_back(place.point);
  loop.normals.push_back(place.normal);
  if (with_curvature) loop.curvature.push_back(place.curvature);
}

}  // namespace

Result<OutlineLoop> resample_loop(const OutlineLoop& loop, std::size_t count, LoopMeasure measure) {
  HARIKO_ASSERT(count >= 4, "a loop has four points");
  if (auto message = unusable({{loop}})) return *std::move(message);
  const LoopCurve curve(loop);
  std::vector<double> length{0};
  LoopCurve::Place before = curve.at(0, 0);
  for (std::size_t i = 0; i < curve.piece_count(); ++i)
    for (int k = 1; k <= pieces; ++k) {
      const LoopCurve::Place here =
          k < pieces ? curve.at(i, double(k) / pieces) : curve.at((i + 1) % curve.piece_count(), 0);
      length.push_back(length.back() + (measure == LoopMeasure::arc
                                            ? (here.point - before.point).norm()
                                            : angle_between(here.normal, before.normal)));
      before = here;
    }
  if (!(length.back() > 1e-6))
    return make_error(e_same_normal, "The normals do not turn along the loop.",
                      "Turn them, or resample by the length of the loop.", element_of(VertexId{0}));
  OutlineLoop out;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = length.back() * double(k) / double(count);
    const auto above = std::upper_bound(length.begin(), length.end(), wanted);
    const auto sample = std::size_t(above - length.begin()) - 1;
    const double within = (wanted - length[sample]) / (length[sample + 1] - length[sample]);
    append(out, curve.at(sample / pieces, (double(sample % pieces) + within) / pieces),
           !loop.curvature.empty());
  }
  return out;
}

Result<OutlineLoop> with_point_after(const OutlineLoop& loop, std::size_t place) {
  HARIKO_ASSERT(place < loop.points.size(), "a point of the loop");
  if (auto message = unusable({{loop}})) return *std::move(message);
  const LoopCurve::Place made = LoopCurve(loop).at(place, 0.5);
  OutlineLoop out = loop;
  const auto at = std::ptrdiff_t(place + 1);
  out.points.insert(out.points.begin() + at, made.point);
  out.normals.insert(out.normals.begin() + at, made.normal);
  if (!loop.curvature.empty()) out.curvature.insert(out.curvature.begin() + at, made.curvature);
  return out;
}

OutlineLoop reversed(const OutlineLoop& loop) {
  return {{loop.points.rbegin(), loop.points.rend()},
          {loop.normals.rbegin(), loop.normals.rend()},
          {loop.curvature.rbegin(), loop.curvature.rend()}};
}

}  // namespace hariko
