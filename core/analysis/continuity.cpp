#include "core/analysis/continuity.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/curvature.hpp"
#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr int normal_samples = 33;
constexpr int curvature_samples = 21;
constexpr double degenerate_share = 1e-9;
constexpr double fold_angle = 1e-6;
constexpr int mean_density = 4;

/// Mean of |ds x dt| of every patch over a coarse grid.
std::vector<double> mean_jacobians(const Surface& surface) {
  std::vector<double> out(surface.patch_count(), 0.0);
  const GridPattern pattern{surface.domain(), mean_density};
  const auto count = static_cast<std::size_t>(pattern.point_count());
  parallel_for(out.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<PatchPoint> points(count);
    for (std::size_t p = begin; p < end; ++p) {
      const Index patch[] = {static_cast<Index>(p)};
      surface.patches().evaluate_grid(patch, pattern, points);
      for (const PatchPoint& point : points) out[p] += point.ds.cross(point.dt).norm() / double(count);
    }
  });
  return out;
}

/// The two sides of a seam as curves over one fraction x.
class SeamSides {
 public:
  SeamSides(const Surface& surface, const Seam& seam) : surface_(surface), seam_(seam) {}

  PatchPoint first(double x, Order order) const {
    return at(seam_.first, seam_.first_begin + x * (seam_.first_end - seam_.first_begin), order);
  }
  PatchPoint second(double x, Order order) const {
    return at(seam_.second, seam_.second_begin + x * (seam_.second_end - seam_.second_begin), order);
  }
  /// Normal of the node at x = 0 or 1, zero when there is no node or the node has no tangent plane.
  Vector3 node_normal(bool at_end) const {
    const double fraction = at_end ? seam_.first_end : seam_.first_begin;
    if (fraction != 0 && fraction != 1) return Vector3::Zero();
    const int corner = (seam_.first.side + (fraction == 1 ? 1 : 0)) % corner_count(surface_.domain());
    return surface_.node_normal(surface_.node(seam_.first.patch, corner));
  }

 private:
  PatchPoint at(PatchSide side, double fraction, Order order) const {
    return surface_.patches().evaluate(side.patch, side_parameter(surface_.domain(), side.side, fraction),
                                       order);
  }
  const Surface& surface_;
  const Seam& seam_;
};

struct NormalJump {
  double angle = 0;
  bool folded = false;
};

NormalJump jump_between(const Vector3& a, const Vector3& b) {
  const double sine = a.cross(b).norm(), cosine = a.dot(b);
  const double planes = std::atan2(sine, std::abs(cosine));
  if (cosine < 0 && planes <= fold_angle) return {planes, true};
  return {std::atan2(sine, cosine), false};
}

/// Unit normal, zero where the derivatives span less than the threshold.
Vector3 normal_above(const PatchPoint& point, double threshold) {
  const Vector3 cross = point.ds.cross(point.dt);
  const double length = cross.norm();
  if (!(length > threshold)) return Vector3::Zero();
  return cross / length;
}

/// Radians by which rounding of the control points alone (a few units in the last place of the position) may
/// turn the normal; infinite where there is none.
double turn_by_rounding(const PatchPoint& point) {
  constexpr double rounding = 1e-15;
  return rounding * point.position.norm() * (point.ds.norm() + point.dt.norm()) /
         point.ds.cross(point.dt).norm();
}

/// True at vertices of very high tension, whose tangents are tiny.
bool beyond_resolution(const PatchPoint& point) {
  constexpr double resolution = 1e-11;
  return turn_by_rounding(point) > resolution;
}

void compare_normals(const SeamSides& sides, double first_threshold, double second_threshold,
                     SeamContinuity& out) {
  for (int k = 0; k < normal_samples; ++k) {
    const double x = double(k) / (normal_samples - 1);
    const PatchPoint p = sides.first(x, Order::first), q = sides.second(x, Order::first);
    out.gap = std::max(out.gap, (p.position - q.position).norm());

    Vector3 n = normal_above(p, first_threshold), m = normal_above(q, second_threshold);
    NormalJump jump;
    const bool end = k == 0 || k == normal_samples - 1;
    if (const Vector3 plane = end ? sides.node_normal(k > 0) : Vector3::Zero(); !plane.isZero(0)) {
      if (n.isZero(0) || beyond_resolution(p)) n = plane;
      if (m.isZero(0) || beyond_resolution(q)) m = plane;
      const NormalJump a = jump_between(n, plane), b = jump_between(m, plane);
      jump = {std::max(a.angle, b.angle), a.folded || b.folded};
    } else if (n.isZero(0) || m.isZero(0) || (end && (beyond_resolution(p) || beyond_resolution(q)))) {
      ++out.degenerate;
      continue;
    } else {
      jump = jump_between(n, m);
      // Where a surface is nearly singular along a seam, both normals are rounding.
      if (!jump.folded && beyond_resolution(p) && jump.angle <= turn_by_rounding(p) + turn_by_rounding(q)) {
        ++out.degenerate;
        continue;
      }
    }
    if (jump.folded) ++out.folded;
    out.normal_jump = std::max(out.normal_jump, jump.angle);
  }
}

void compare_curvatures(const SeamSides& sides, SeamContinuity& out) {
  double jump = 0, norm = 0;
  for (int k = 0; k < curvature_samples; ++k) {
    const double x = (k + 0.5) / curvature_samples;
    const auto a = curvature(sides.first(x, Order::second)), b = curvature(sides.second(x, Order::second));
    if (!a || !b) continue;
    ++out.curvature_samples;
    const double difference = (a->tensor - b->tensor).norm();
    out.largest_curvature_jump = std::max(out.largest_curvature_jump, difference);
    jump += difference * difference;
    const double mean = (a->tensor.norm() + b->tensor.norm()) / 2;
    norm += mean * mean;
  }
  if (out.curvature_samples == 0) return;
  out.curvature_jump = std::sqrt(jump / out.curvature_samples);
  out.curvature = std::sqrt(norm / out.curvature_samples);
}

}  // namespace

ContinuityReport continuity(const Surface& surface, const CancelToken& cancel) {
  ContinuityReport report;
  if (surface.patch_count() == 0) return report;
  const std::vector<Seam>& seams = surface.seams();
  const std::vector<double> means = mean_jacobians(surface);
  std::vector<SeamContinuity> each(seams.size());
  parallel_for(seams.size(), 8, [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    for (std::size_t i = begin; i < end; ++i) {
      const SeamSides sides(surface, seams[i]);
      compare_normals(sides, degenerate_share * means[seams[i].first.patch],
                      degenerate_share * means[seams[i].second.patch], each[i]);
      compare_curvatures(sides, each[i]);
    }
  });
  if (cancel.cancelled()) return report;

  double jump = 0, norm = 0, largest = 0;
  bool any = false;
  for (std::size_t i = 0; i < seams.size(); ++i) {
    const SeamContinuity& seam = each[i];
    report.largest_gap = std::max(report.largest_gap, seam.gap);
    if (seams[i].intended == Continuity::g0) continue;
    any = true;
    largest = std::max(largest, seam.normal_jump);
    report.degenerate_samples += seam.degenerate;
    report.folded_samples += seam.folded;
    jump += seam.curvature_samples * seam.curvature_jump * seam.curvature_jump;
    norm += seam.curvature_samples * seam.curvature * seam.curvature;
  }
  if (any) {
    report.largest_normal_jump = largest;
    report.rms_curvature_jump = norm > 0 ? std::sqrt(jump / norm) : 0.0;
  }
  report.seams = std::move(each);
  return report;
}

std::vector<Continuity> classify(const Surface& surface, const ContinuityReport& report,
                                 const ContinuityTolerance& tolerance) {
  HARIKO_ASSERT(report.seams.size() == surface.seams().size(), "the report is of another surface");
  // Curvature times size below this is the rounding of a plane.
  constexpr double flat = 1e-9;
  std::vector<Continuity> classes(report.seams.size(), Continuity::g0);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const SeamContinuity& seam = report.seams[i];
    if (seam.normal_jump * 180 / std::numbers::pi > tolerance.angle || seam.folded > 0) continue;
    const double size = surface.patch_scale(surface.seams()[i].first.patch);
    const bool even =
        seam.curvature * size <= flat || seam.curvature_jump <= tolerance.curvature * seam.curvature;
    classes[i] = even ? Continuity::g2 : Continuity::g1;
  }
  return classes;
}

}  // namespace hariko
