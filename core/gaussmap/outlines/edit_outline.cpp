#include "core/gaussmap/outlines/edit_outline.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/geometry/rotation.hpp"

namespace hariko {
namespace {

/// Drops curvature unless all loops have it.
void harmonise(Outline& outline) {
  if (outline.has_curvature()) return;
  for (OutlineLoop& loop : outline.loops) loop.curvature.clear();
}

/// Renumbers a loop's message for the whole outline.
Message of_outline(Message message, Index first) {
  if (message.element.kind == Element::Kind::vertex) message.element.id += first;
  return message;
}

/// Calls body(loop, number of its first point, places of its points that are among the given ones).
template <class Body>
void for_loops(const Outline& outline, const std::set<Index>& numbers, Body&& body) {
  Index first = 0;
  for (std::size_t l = 0; l < outline.loops.size(); ++l) {
    const auto count = Index(outline.loops[l].points.size());
    std::set<Index> places;
    for (auto at = numbers.lower_bound(first); at != numbers.end() && *at < first + count; ++at)
      places.insert(*at - first);
    body(l, first, places);
    first += count;
  }
  HARIKO_ASSERT(numbers.empty() || *numbers.rbegin() < first, "numbers of points");
}

}  // namespace

Index first_number(const Outline& outline, std::size_t loop) {
  std::size_t first = 0;
  for (std::size_t l = 0; l < loop; ++l) first += outline.loops[l].points.size();
  return Index(first);
}

Outline with_points(const Outline& outline, std::span<const Index> numbers, std::span<const Vector3> points) {
  HARIKO_ASSERT(numbers.size() == points.size(), "one point a number");
  Outline out = outline;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const OutlinePoint at = outline_point(outline, numbers[i]);
    out.loops[at.loop].points[at.place] = points[i];
  }
  for (std::size_t l = 0; l < out.loops.size(); ++l) {
    OutlineLoop& loop = out.loops[l];
    if (loop.points.size() < 3 || loop.points == outline.loops[l].points) continue;
    const auto before = loop_tangents(outline.loops[l].points), after = loop_tangents(loop.points);
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      if (before[i] != after[i]) loop.normals[i] = least_rotation(before[i], after[i]) * loop.normals[i];
  }
  return out;
}

Outline with_normals(const Outline& outline, std::span<const Index> numbers,
                     std::span<const Vector3> normals) {
  HARIKO_ASSERT(numbers.size() == normals.size(), "one normal a number");
  Outline out = outline;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const OutlinePoint at = outline_point(outline, numbers[i]);
    out.loops[at.loop].normals[at.place] = normals[i];
  }
  return out;
}

Outline tilted(const Outline& outline, const std::set<Index>& numbers, double radians) {
  Outline out = outline;
  for_loops(outline, numbers, [&](std::size_t l, Index, const std::set<Index>& places) {
    if (places.empty()) return;
    OutlineLoop& loop = out.loops[l];
    const auto tangents = loop_tangents(loop.points);
    // The surface lies on the left: rotating the normal away from it, to the right, is a rotation about the
    // tangent from the left over the normal.
    for (const Index place : places)
      loop.normals[place] = Eigen::AngleAxisd(radians, tangents[place]) * loop.normals[place];
  });
  return out;
}

Outline with_spread_normals(const Outline& outline, const std::set<Index>& given) {
  Outline out = outline;
  for_loops(outline, given, [&](std::size_t l, Index, const std::set<Index>& places) {
    if (places.empty() || out.loops[l].points.size() < 3) return;
    std::vector<std::pair<std::size_t, Vector3>> normals;
    for (const Index place : places) normals.emplace_back(place, out.loops[l].normals[place]);
    out.loops[l].normals = spread_normals(out.loops[l].points, normals);
  });
  return out;
}

Outline turned_inside_out(const Outline& outline) {
  Outline out;
  for (const OutlineLoop& loop : outline.loops) {
    out.loops.push_back(reversed(loop));
    for (Vector3& normal : out.loops.back().normals) normal = -normal;
  }
  return out;
}

Result<Outline> resampled(const Outline& outline, std::size_t count, LoopMeasure measure) {
  Outline out;
  for (std::size_t l = 0; l < outline.loops.size(); ++l) {
    auto loop = resample_loop(outline.loops[l], count, measure);
    if (!loop) return of_outline(loop.error(), first_number(outline, l));
    out.loops.push_back(*std::move(loop));
  }
  return out;
}

Result<Outline> with_point_after(const Outline& outline, Index number) {
  const OutlinePoint at = outline_point(outline, number);
  auto loop = with_point_after(outline.loops[at.loop], at.place);
  if (!loop) return of_outline(loop.error(), number - Index(at.place));
  Outline out = outline;
  out.loops[at.loop] = *std::move(loop);
  return out;
}

Result<Outline> without_points(const Outline& outline, const std::set<Index>& numbers) {
  Outline out;
  for_loops(outline, numbers, [&](std::size_t l, Index, const std::set<Index>& places) {
    const OutlineLoop& loop = outline.loops[l];
    if (loop.points.size() < places.size() + 4) return;
    OutlineLoop& left = out.loops.emplace_back();
    for (Index i = 0; i < loop.points.size(); ++i) {
      if (places.contains(i)) continue;
      left.points.push_back(loop.points[i]);
      left.normals.push_back(loop.normals[i]);
      if (!loop.curvature.empty()) left.curvature.push_back(loop.curvature[i]);
    }
  });
  if (out.loops.empty())
    return make_error(e_outline_too_few, "No loop would keep the four points that it needs.",
                      "Delete the object instead.");
  harmonise(out);
  return out;
}

Outline with_loop(const Outline& outline, OutlineLoop loop) {
  Outline out = outline;
  out.loops.push_back(std::move(loop));
  harmonise(out);
  return out;
}

std::vector<double> distances_along(const Outline& outline, const std::set<Index>& from) {
  std::vector<double> out;
  for_loops(outline, from, [&](std::size_t l, Index first, const std::set<Index>& places) {
    const auto& points = outline.loops[l].points;
    const std::size_t count = points.size();
    out.resize(first + count, HUGE_VAL);
    for (const Index place : places) out[first + place] = 0;
    // Two passes round the loop in each direction reach all points.
    for (std::size_t k = 0; k < 2 * count; ++k) {
      const std::size_t i = k % count, next = (i + 1) % count;
      out[first + next] = std::min(out[first + next], out[first + i] + (points[next] - points[i]).norm());
    }
    for (std::size_t k = 2 * count; k-- > 0;) {
      const std::size_t i = k % count, next = (i + 1) % count;
      out[first + i] = std::min(out[first + i], out[first + next] + (points[next] - points[i]).norm());
    }
  });
  return out;
}

std::set<Index> whole_loops(const Outline& outline, const std::set<Index>& numbers) {
  std::set<Index> out;
  for_loops(outline, numbers, [&](std::size_t l, Index first, const std::set<Index>& places) {
    if (places.empty()) return;
    for (Index i = 0; i < outline.loops[l].points.size(); ++i) out.insert(out.end(), first + i);
  });
  return out;
}

}  // namespace hariko
