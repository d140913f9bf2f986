#include "core/gaussmap/outlines/outline_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/gaussmap/sphere/arc_crossings.hpp"
#include "core/gaussmap/sphere/spherical_delaunay.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
// Limits of gaussmap.md 7.
constexpr double same_point = 1e-9;                             // relative to the size
constexpr double same_normal = 1e-6;                            // radians
constexpr double coarse_step = 45;                              // degrees
constexpr double uneven_ratio = 6;                              // ratio of the largest to the median step
constexpr double slanted_warning = 2, slanted_error = 10;       // degrees
constexpr double concave_warning = 1e-9, concave_error = 1e-3;  // relative to the size

/// Worst of the points with the same fault, and their count.
struct Worst {
  double value = 0;
  std::size_t count = 0;
  OutlinePoint point;
  void take(double other, const OutlinePoint& at) {
    if (count++ == 0 || other > value) {
      value = other;
      point = at;
    }
  }
  std::string others() const {
    return count < 2 ? ""
                     : " (and so at " + std::to_string(count - 1) +
                           (count == 2 ? " other point)" : " other points)");
  }
};

class Check {
 public:
  Check(const Outline& outline, GaussMode mode, CurvatureSign sign)
      : outline_(outline), mode_(mode), sign_(sign), size_(outline.size()) {}

  /// Faults that prevent any computation.
  std::vector<Message> unusable() {
    check_values();
    if (out_.empty()) check_points();
    return std::move(out_);
  }

  std::vector<Message> run() {
    check_values();
    if (out_.empty()) check_points();
    if (!out_.empty()) return std::move(out_);
    normals_ = unit_normals(outline_);
    check_steps();
    check_slants();
    if (mode_ == GaussMode::position) return std::move(out_);
    check_curvature();
    if (const auto pair = crossing_arcs(normals_))
      error(e_image_crosses,
            "The Gauss image is not simple: the arc from " + name(outline_point(outline_, pair->first)) +
                " crosses the arc from " + name(outline_point(outline_, pair->second)) + ".",
            "Give normals that no two points of the surface share, or use the mode position.",
            outline_point(outline_, pair->first));
    if (sign_ == CurvatureSign::positive) check_convexity();
    return std::move(out_);
  }

 private:
  std::string name(const OutlinePoint& point) const { return to_string(outline_, point); }
  static Element element(const OutlinePoint& point) { return element_of(VertexId{point.number}); }
  void error(Code code, std::string text, std::string remedy, const OutlinePoint& point) {
    out_.push_back(make_error(code, std::move(text), std::move(remedy), element(point)));
  }
  void warn(Code code, std::string text, std::string remedy, const OutlinePoint& point) {
    out_.push_back(make_warning(code, std::move(text), std::move(remedy), element(point)));
  }
  /// Calls body(loop, point, previous place, next place) for all points.
  template <class Body>
  void for_points(Body&& body) const {
    OutlinePoint point;
    for (const OutlineLoop& loop : outline_.loops) {
      const std::size_t count = loop.points.size();
      for (point.place = 0; point.place < count; ++point.place, ++point.number)
        body(loop, point, (point.place + count - 1) % count, (point.place + 1) % count);
      ++point.loop;
    }
  }

  void check_values();
  void check_points();
  void check_steps();
  void check_slants();
  void check_curvature();
  void check_convexity();

  const Outline& outline_;
  GaussMode mode_;
  CurvatureSign sign_;
  double size_;
  std::vector<std::vector<Vector3>> normals_;
  std::vector<Message> out_;
};

void Check::check_values() {
  OutlinePoint first;
  if (outline_.loops.empty())
    error(e_outline_too_few, "The outline has no loop.", "Draw a loop of at least four points.", first);
  for (const OutlineLoop& loop : outline_.loops) {
    HARIKO_ASSERT(loop.normals.size() == loop.points.size(), "one normal a point");
    HARIKO_ASSERT(loop.curvature.empty() || loop.curvature.size() == loop.points.size(),
                  "one curvature a point");
    if (loop.points.size() < 4)
      error(e_outline_too_few,
            "Loop " + std::to_string(first.loop) + " has " + std::to_string(loop.points.size()) +
                " points, but a loop needs at least four.",
            "Add points to the loop, or remove it.", first);
    ++first.loop;
    first.number += static_cast<Index>(loop.points.size());
  }
  bool found = false;
  for_points([&](const OutlineLoop& loop, const OutlinePoint& point, std::size_t, std::size_t) {
    const bool fine = loop.points[point.place].allFinite() && loop.normals[point.place].allFinite() &&
                      (loop.curvature.empty() || std::isfinite(loop.curvature[point.place]));
    if (fine || found) return;
    found = true;
    error(e_outline_not_finite,
          "The position, normal or curvature of " + name(point) + " is not a finite number.",
          "Give it finite numbers.", point);
  });
  // Beyond this size squares and products overflow.
  if (!found && !out_.size() && !(size_ < 1e100))
    error(e_outline_not_finite, "The outline is too large to be computed with.", "Make it smaller.", {});
}

void Check::check_points() {
  Worst same, zero;
  for_points([&](const OutlineLoop& loop, const OutlinePoint& point, std::size_t, std::size_t next) {
    const double distance = (loop.points[point.place] - loop.points[next]).norm();
    if (!(distance >= same_point * size_) || distance == 0) same.take(-distance, point);
    if (!(loop.normals[point.place].stableNorm() > 1e-100)) zero.take(0, point);
  });
  if (same.count)
    error(e_same_point,
          "The outline's " + name(same.point) + " lies where the next one lies" + same.others() + ".",
          "Remove one of the two.", same.point);
  if (zero.count)
    error(e_zero_normal, "The normal of " + name(zero.point) + " has no length" + zero.others() + ".",
          "Give it a direction.", zero.point);
}

void Check::check_steps() {
  Worst same, coarse;
  std::vector<double> steps;
  for_points([&](const OutlineLoop&, const OutlinePoint& point, std::size_t, std::size_t next) {
    const double step = angle_between(normals_[point.loop][point.place], normals_[point.loop][next]);
    steps.push_back(step);
    if (step < same_normal) same.take(-step, point);
    if (step * degrees > coarse_step) coarse.take(step, point);
  });
  if (same.count && mode_ != GaussMode::position)
    error(e_same_normal,
          "The outline's " + name(same.point) + " and the next one have the same normal" + same.others() +
              ": flat or developable along the boundary.",
          "Turn the normals along the outline, or use the mode position.", same.point);
  if (coarse.count)
    error(e_coarse_normals,
          "The normal turns " + rounded_text(coarse.value * degrees, 3) + " degrees from " +
              name(coarse.point) + " to the next" + coarse.others() + ".",
          "Sample the outline more densely.", coarse.point);
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const auto largest = std::max_element(steps.begin(), steps.end());
  if (*largest > uneven_ratio * *middle && mode_ != GaussMode::position) {
    const OutlinePoint point = outline_point(outline_, Index(largest - steps.begin()));
    warn(w_uneven_normals,
         "The normal turns unevenly: " + rounded_text(*largest / *middle, 3) +
             " times the usual step after " + name(point) + ".",
         "Resample the outline uniformly in the turning of its normals.", point);
  }
}

void Check::check_slants() {
  Worst warning, wrong;
  for_points([&](const OutlineLoop& loop, const OutlinePoint& point, std::size_t previous, std::size_t next) {
    const Vector3 chord = loop.points[next] - loop.points[previous];
    if (!(chord.norm() > 0)) return;  // previous and next point coincide: no direction
    const Vector3& normal = normals_[point.loop][point.place];
    const double slant = std::abs(std::asin(std::clamp(normal.dot(chord.normalized()), -1.0, 1.0))) * degrees;
    if (slant > slanted_error)
      wrong.take(slant, point);
    else if (slant > slanted_warning)
      warning.take(slant, point);
  });
  const auto text = [&](const Worst& worst) {
    return "The normal at " + name(worst.point) + " is " + rounded_text(worst.value, 3) +
           " degrees off the perpendicular of the outline" + worst.others() + ".";
  };
  const std::string remedy = "Make the normals perpendicular to the outline.";
  if (wrong.count) error(e_normal_tangent, text(wrong), remedy, wrong.point);
  if (warning.count) warn(w_normal_tangent, text(warning), remedy, warning.point);
}

void Check::check_curvature() {
  const bool needed = mode_ != GaussMode::umbilic;
  OutlinePoint first, positive, negative;
  std::size_t positives = 0, negatives = 0;
  for (const OutlineLoop& loop : outline_.loops) {
    if (loop.curvature.empty() && needed)
      return error(
          e_no_curvature,
          "Loop " + std::to_string(first.loop) + " has no Gaussian curvature, which this mode needs.",
          "Give the curvature along the loop, or use the mode round (umbilic) or position.", first);
    ++first.loop;
    first.number += static_cast<Index>(loop.points.size());
  }
  bool zero = false;
  for_points([&](const OutlineLoop& loop, const OutlinePoint& point, std::size_t, std::size_t) {
    if (loop.curvature.empty() || zero) return;
    const double value = loop.curvature[point.place];
    if (value == 0) {
      zero = true;
      error(e_zero_curvature, "The Gaussian curvature at " + name(point) + " is zero.",
            "Give another curvature, or use the mode position.", point);
    }
    if (value > 0 && positives++ == 0) positive = point;
    if (value < 0 && negatives++ == 0) negative = point;
  });
  if (positives && negatives)
    error(e_mixed_curvature,
          "The Gaussian curvature is positive at " + name(positive) + " and negative at " + name(negative) +
              ".",
          "Give curvature of one sign, or use the mode position.", negative);
  else if (negatives && mode_ == GaussMode::paper)
    error(e_negative_curvature,
          "The Gaussian curvature at " + name(negative) + " is negative, which this mode cannot do.",
          "Use the mode round (umbilic) or curvature.", negative);
}

void Check::check_convexity() {
  std::vector<Vector3> points, normals;
  for (std::size_t l = 0; l < outline_.loops.size(); ++l) {
    points.insert(points.end(), outline_.loops[l].points.begin(), outline_.loops[l].points.end());
    normals.insert(normals.end(), normals_[l].begin(), normals_[l].end());
  }
  double largest = 0;
  Index cut = 0, plane = 0;
  for (Index k = 0; k < points.size(); ++k)
    for (Index i = 0; i < points.size(); ++i)
      if (const double beyond = normals[k].dot(points[i] - points[k]); beyond > largest) {
        largest = beyond;
        cut = i;
        plane = k;
      }
  if (largest <= concave_warning * size_) return;
  const OutlinePoint at = outline_point(outline_, plane);
  const std::string text = "The tangent plane of " + name(at) + " cuts off " +
                           name(outline_point(outline_, cut)) + " by " + rounded_text(largest, 3) +
                           ": no convex surface has these normals.";
  const std::string remedy =
      "Turn the normals outward, or choose negative curvature for the shape of a saddle.";
  if (largest > concave_error * size_)
    error(e_not_convex, text, remedy, at);
  else
    warn(w_not_convex, text, remedy, at);
}

}  // namespace

std::vector<std::vector<Vector3>> unit_normals(const Outline& outline) {
  std::vector<std::vector<Vector3>> out;
  for (const OutlineLoop& loop : outline.loops) {
    out.emplace_back();
    for (const Vector3& normal : loop.normals) out.back().push_back(normal.stableNormalized());
  }
  return out;
}

CurvatureSign curvature_sign(const Outline& outline, CurvatureSign fallback) {
  for (const OutlineLoop& loop : outline.loops)
    for (const double value : loop.curvature)
      if (value != 0) return value > 0 ? CurvatureSign::positive : CurvatureSign::negative;
  return fallback;
}

std::optional<Message> unusable(const Outline& outline) {
  const std::vector<Message> messages = Check(outline, GaussMode::position, {}).unusable();
  return messages.empty() ? std::nullopt : std::optional(messages.front());
}

std::vector<Message> check_outline(const Outline& outline, GaussMode mode, CurvatureSign sign) {
  return Check(outline, mode, curvature_sign(outline, sign)).run();
}

}  // namespace hariko
