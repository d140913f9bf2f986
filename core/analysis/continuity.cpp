#include "core/analysis/continuity.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

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

/// Mean of |ds x dt| over a coarse grid, per patch.
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

/// Fractions x of a seam at which its two sides are compared.
std::vector<double> fractions_of(Order order) {
  std::vector<double> out;
  if (order == Order::first)
    for (int k = 0; k < normal_samples; ++k) out.push_back(double(k) / (normal_samples - 1));
  else
    for (int k = 0; k < curvature_samples; ++k) out.push_back((k + 0.5) / curvature_samples);
  return out;
}

/// Evaluation of both sides of seams to one order. Whole sides use tables by side number, parts of sides are
/// evaluated point by point.
class SeamSampler {
 public:
  SeamSampler(const Surface& surface, Order order)
      : surface_(surface), order_(order), fractions_(fractions_of(order)) {
    for (int side = 0; side < corner_count(surface.domain()); ++side) {
      std::vector<Vector2> parameters;
      for (const double x : fractions_) parameters.push_back(side_parameter(surface.domain(), side, x));
      sides_.push_back(surface.patches().batch(std::move(parameters)));
    }
  }

  std::size_t count() const { return fractions_.size(); }

  /// Evaluates the side: out[k] at fraction k of its part from `begin` to `end`.
  void sample(PatchSide side, double begin, double end, std::span<PatchPoint> out) const {
    const bool forward = begin == 0 && end == 1;
    if (!forward && !(begin == 1 && end == 0)) {
      for (std::size_t k = 0; k < count(); ++k)
        out[k] = surface_.patches().evaluate(
            side.patch, side_parameter(surface_.domain(), side.side, begin + fractions_[k] * (end - begin)),
            order_);
      return;
    }
    const Index patch[] = {side.patch};
    sides_[side.side]->evaluate(patch, order_, out);
    if (!forward) std::reverse(out.begin(), out.end());
  }

 private:
  const Surface& surface_;
  Order order_;
  std::vector<double> fractions_;
  std::vector<std::unique_ptr<const BatchEvaluation>> sides_;
};

/// Points of both sides of one seam.
struct SeamPoints {
  std::vector<PatchPoint> first, second;
  explicit SeamPoints(std::size_t count) : first(count), second(count) {}
  void take(const SeamSampler& sampler, const Seam& seam) {
    sampler.sample(seam.first, seam.first_begin, seam.first_end, first);
    sampler.sample(seam.second, seam.second_begin, seam.second_end, second);
  }
};

/// Normal of the node at an end of a seam, zero when there is no node or the node has no tangent plane.
Vector3 node_normal(const Surface& surface, const Seam& seam, bool at_end) {
  const double fraction = at_end ? seam.first_end : seam.first_begin;
  if (fraction != 0 && fraction != 1) return Vector3::Zero();
  const int corner = (seam.first.side + (fraction == 1 ? 1 : 0)) % corner_count(surface.domain());
  return surface.node_normal(surface.node(seam.first.patch, corner));
}

struct NormalJump {
  double angle = 0;
  bool folded = false;
};

NormalJump jump_between(const Vector3& a, const Vector3& b) {
  const double sine = a.cross(b).norm(), cosine = a.dot(b);
  const double angle = std::atan2(sine, cosine);
  const double planes = std::numbers::pi - angle;
  if (cosine < 0 && planes <= fold_angle) return {std::atan2(sine, -cosine), true};
  return {angle, false};
}

/// Unit normal, zero where |ds x dt| does not exceed the threshold.
Vector3 normal_above(const PatchPoint& point, double threshold) {
  const Vector3 cross = point.ds.cross(point.dt);
  const double length = cross.norm();
  if (!(length > threshold)) return Vector3::Zero();
  return cross / length;
}

/// Angle in radians by which the rounding of the control points alone (a few units in the last place of the
/// position) may turn the normal; infinite where there is no normal.
double turn_by_rounding(const PatchPoint& point) {
  constexpr double rounding = 1e-15;
  return rounding * point.position.norm() * (point.ds.norm() + point.dt.norm()) /
         point.ds.cross(point.dt).norm();
}

/// Whether `turn_by_rounding` exceeds 1e-11: true at vertices of very high tension, whose tangents are tiny.
bool beyond_resolution(const PatchPoint& point) {
  constexpr double share = 1e-15 / 1e-11;  // rounding to resolution
  const double s = point.ds.squaredNorm(), t = point.dt.squaredNorm();
  return share * share * point.position.squaredNorm() * (s + t + 2 * std::sqrt(s * t)) >
         point.ds.cross(point.dt).squaredNorm();
}

/// Compares positions and normals along a seam. `planes`: normals of the nodes at both ends.
void compare_normals(const SeamPoints& points, const std::array<Vector3, 2>& planes, double first_threshold,
                     double second_threshold, SeamContinuity& out) {
  for (int k = 0; k < normal_samples; ++k) {
    const PatchPoint &p = points.first[std::size_t(k)], &q = points.second[std::size_t(k)];
    out.gap = std::max(out.gap, (p.position - q.position).norm());

    Vector3 n = normal_above(p, first_threshold), m = normal_above(q, second_threshold);
    NormalJump jump;
    const bool end = k == 0 || k == normal_samples - 1;
    if (const Vector3 plane = end ? planes[k > 0 ? 1 : 0] : Vector3::Zero(); !plane.isZero(0)) {
      if (n.isZero(0) || beyond_resolution(p)) n = plane;
      if (m.isZero(0) || beyond_resolution(q)) m = plane;
      const NormalJump a = jump_between(n, plane), b = jump_between(m, plane);
      jump = {std::max(a.angle, b.angle), a.folded || b.folded};
    } else if (n.isZero(0) || m.isZero(0) || (end && (beyond_resolution(p) || beyond_resolution(q)))) {
      ++out.degenerate;
      continue;
    } else {
      jump = jump_between(n, m);
      // Both normals consist of rounding errors where a surface is nearly singular along a seam.
      if (!jump.folded && (beyond_resolution(p) || beyond_resolution(q)) &&
          jump.angle <= turn_by_rounding(p) + turn_by_rounding(q)) {
        ++out.degenerate;
        continue;
      }
    }
    if (jump.folded) ++out.folded;
    out.normal_jump = std::max(out.normal_jump, jump.angle);
  }
}

void compare_curvatures(const SeamPoints& points, SeamContinuity& out) {
  double jump = 0, norm = 0;
  for (std::size_t k = 0; k < points.first.size(); ++k) {
    const auto a = shape_operator(points.first[k]), b = shape_operator(points.second[k]);
    if (!a || !b) continue;
    ++out.curvature_samples;
    const double difference = (a->tensor() - b->tensor()).norm();
    out.largest_curvature_jump = std::max(out.largest_curvature_jump, difference);
    jump += difference * difference;
    const double mean = (std::sqrt(a->squares()) + std::sqrt(b->squares())) / 2;
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
  const SeamSampler first_order(surface, Order::first), second_order(surface, Order::second);
  std::vector<SeamContinuity> each(seams.size());
  parallel_for(seams.size(), 64, [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    SeamPoints normals(first_order.count()), curvatures(second_order.count());
    for (std::size_t i = begin; i < end; ++i) {
      const Seam& seam = seams[i];
      normals.take(first_order, seam);
      compare_normals(normals, {node_normal(surface, seam, false), node_normal(surface, seam, true)},
                      degenerate_share * means[seam.first.patch], degenerate_share * means[seam.second.patch],
                      each[i]);
      curvatures.take(second_order, seam);
      compare_curvatures(curvatures, each[i]);
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
  // Curvature times size that a rounded plane may have.
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
