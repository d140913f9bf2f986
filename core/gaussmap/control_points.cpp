#include "core/gaussmap/control_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/gaussmap/bending_fill.hpp"
#include "core/gaussmap/contact_points.hpp"
#include "core/gaussmap/sphere/delaunay_refinement.hpp"
#include "core/gaussmap/sphere/lloyd_relaxed_sites.hpp"
#include "core/gaussmap/sphere/paper_insertion.hpp"
#include "core/gaussmap/support_function_solve.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {
namespace {

Message point_limit(Index count) {
  return make_warning(w_too_many_points,
                      "The limit of " + std::to_string(count) + " inner points ends the insertion early.",
                      "Raise the limit, or the spacing.");
}

/// Normalised outline, moved to its centre and scaled to size 1. For negative curvature the Gauss map
/// reverses orientation: the loops are reversed in the input, the order of points and faces is restored in
/// the output.
class Problem {
 public:
  Problem(const Outline& outline, bool reversed) : reversed_(reversed), size_(outline.size()) {
    for (const OutlineLoop& loop : outline.loops)
      for (const Vector3& point : loop.points) middle_ += point / double(outline.point_count());
    Index first = 0;
    for (const OutlineLoop& loop : outline.loops) {
      const Index count = static_cast<Index>(loop.points.size());
      loops_.emplace_back();
      for (Index i = 0; i < count; ++i) {
        const Index k = reversed ? count - 1 - i : i;
        loops_.back().push_back(loop.normals[k].stableNormalized());
        boundary_.points.push_back((loop.points[k] - middle_) / size_);
        if (outline.has_curvature()) boundary_.curvature.push_back(loop.curvature[k] * size_ * size_);
        number_.push_back(first + k);
      }
      first += count;
    }
  }

  const std::vector<std::vector<Vector3>>& loops() const { return loops_; }
  bool reversed() const { return reversed_; }
  const BoundaryData& boundary() const { return boundary_; }
  double size() const { return size_; }

  /// Scales, moves and renumbers the solvers' results.
  void restore(ControlPoints& result, const Outline& outline) const {
    for (std::size_t i = 0; i < result.points.size(); ++i) {
      result.points[i] = result.points[i] * size_ + middle_;
      result.support[i] = result.support[i] * size_ + result.normals[i].dot(middle_);
      result.curvature[i] /= size_ * size_;
    }
    result.gap *= size_;
    const ControlPoints old = result;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      const OutlinePoint at = outline_point(outline, number_[i]);
      // The given values are copied, because scaling back and forth would round them.
      result.points[number_[i]] = outline.loops[at.loop].points[at.place];
      result.normals[number_[i]] = old.normals[i];
      result.support[number_[i]] = old.support[i];
      result.curvature[number_[i]] = old.curvature[i];
    }
    if (!reversed_) return;
    for (auto& triangle : result.triangles) {
      for (Index& v : triangle)
        if (v < number_.size()) v = number_[v];
      std::swap(triangle[1], triangle[2]);
    }
  }

 private:
  bool reversed_;
  double size_;
  Vector3 middle_ = Vector3::Zero();
  std::vector<std::vector<Vector3>> loops_;
  BoundaryData boundary_;
  std::vector<Index> number_;  ///< the outline's number of each boundary site
};

class Solver {
 public:
  Solver(const Problem& problem, const GaussOptions& options, const CancelToken& cancel)
      : problem_(problem), options_(options), cancel_(cancel) {}

  /// Runs all steps with one smallest radius, in steps of the outline.
  Result<ControlPoints> solve(double radius) {
    auto begun = SiteInsertion::begin(problem_.loops(), problem_.reversed());
    if (!begun) return begun.error();
    SiteInsertion insertion = std::move(begun).value();
    const double smallest = radius * insertion.boundary_spacing();
    if (options_.mode == GaussMode::paper) return by_paper(insertion, smallest);
    Index count = 0;
    while (count < options_.most_points && insertion.insert_next(smallest)) ++count;
    if (cancel_.cancelled()) return make_error(e_cancelled, "The computation was cancelled.");
    const SphereMesh mesh = relaxed(insertion.mesh(), options_.relaxation);
    ControlPoints out;
    auto support = linear_fill(mesh, problem_.boundary(), options_.mode == GaussMode::curvature);
    if (!support) return support.error();
    out.support = *std::move(support);
    out.triangles = mesh.triangles();
    if (cancel_.cancelled()) return make_error(e_cancelled, "The computation was cancelled.");
    take_contacts(mesh, out);
    if (count == options_.most_points && insertion.largest_radius() >= smallest)
      out.messages.push_back(point_limit(count));
    return out;
  }

 private:
  void take_contacts(const SphereMesh& mesh, ControlPoints& out) const {
    out.normals = mesh.sites();
    out.boundary_count = mesh.boundary_count();
    for (const Contact& contact : contact_points(mesh, problem_.boundary(), out.support)) {
      out.points.push_back(contact.point);
      out.curvature.push_back(contact.curvature);
    }
  }

  Result<ControlPoints> by_paper(SiteInsertion& insertion, double smallest) const {
    auto made = insert_by_paper(insertion, problem_.boundary(), smallest, options_.most_points, cancel_);
    if (!made) return made.error();
    const SphereMesh mesh = insertion.mesh();
    ControlPoints out;
    out.points = std::move(made->points);
    out.normals = mesh.sites();
    out.support = std::move(made->support);
    out.curvature = std::move(made->curvature);
    out.boundary_count = mesh.boundary_count();
    out.triangles = mesh.triangles();
    out.clamped_count = made->clamped_count;
    if (made->limited) out.messages.push_back(point_limit(options_.most_points));
    return out;
  }

  const Problem& problem_;
  const GaussOptions& options_;
  const CancelToken& cancel_;
};

/// Mode position, on the outline moved to its centre and scaled to size 1, without reordering.
Result<ControlPoints> by_position(const Outline& outline, const GaussOptions& options,
                                  const CancelToken& cancel) {
  Vector3 middle = Vector3::Zero();
  const double size = outline.size();
  for (const OutlineLoop& loop : outline.loops)
    for (const Vector3& point : loop.points) middle += point / double(outline.point_count());
  Outline scaled = outline;
  std::vector<Vector3> normals;
  for (OutlineLoop& loop : scaled.loops) {
    for (Vector3& point : loop.points) point = (point - middle) / size;
    for (const Vector3& normal : loop.normals) normals.push_back(normal.stableNormalized());
  }
  auto laid = position_mesh(scaled, options.radius, options.most_points);
  if (!laid) return laid.error();
  PositionMesh mesh = std::move(laid).value();
  auto filled = fill_positions(mesh, normals, 1, options.relaxation, cancel);
  if (!filled) return filled.error();
  ControlPoints out;
  out.normals = std::move(filled->normals);
  out.boundary_count = mesh.boundary_count;
  out.triangles = std::move(mesh.triangles);
  out.iterations = filled->iterations;
  if (mesh.limited) out.messages.push_back(point_limit(options.most_points));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const bool given = i < mesh.boundary_count;
    const OutlinePoint at = given ? outline_point(outline, Index(i)) : OutlinePoint{};
    out.points.push_back(given ? outline.loops[at.loop].points[at.place]
                               : Vector3(mesh.points[i] * size + middle));
    out.support.push_back(out.normals[i].dot(out.points[i]));
    const bool known = given && !outline.loops[at.loop].curvature.empty();
    out.curvature.push_back(known ? outline.loops[at.loop].curvature[at.place]
                                  : filled->curvature[i] / (size * size));
  }
  if (!filled->settled)
    out.messages.push_back(make_warning(
        w_not_settled, "The bending did not settle within " + std::to_string(out.iterations) + " steps.",
        "Sample the outline more densely, or check its normals."));
  return out;
}

/// Largest gap: height of the intersection of a face's three tangent planes above the face (gaussmap.md 3).
double largest_gap(const ControlPoints& result) {
  double largest = 0;
  for (const auto& [a, b, c] : result.triangles) {
    const Vector3 normal = area_vector(result.points[a], result.points[b], result.points[c]);
    Matrix3 planes;
    planes << result.normals[a].transpose(), result.normals[b].transpose(), result.normals[c].transpose();
    const Vector3 corner =
        planes.inverse() * Vector3(result.support[a], result.support[b], result.support[c]);
    if (corner.allFinite() && normal.norm() > 0)
      largest = std::max(largest, std::abs((corner - result.points[a]).dot(normal.normalized())));
  }
  return largest;
}

void add_result_warnings(ControlPoints& result, std::optional<CurvatureSign> sign) {
  Index flipped = 0, concave = 0;
  std::optional<Index> first_flipped, first_concave;
  for (const auto& [a, b, c] : result.triangles) {
    const Vector3 normal = area_vector(result.points[a], result.points[b], result.points[c]);
    if (normal.dot(result.normals[a] + result.normals[b] + result.normals[c]) > 0) continue;
    if (flipped++ == 0) first_flipped = a;
  }
  for (Index i = result.boundary_count; i < result.points.size(); ++i)
    if (!(result.curvature[i] > 0) && concave++ == 0) first_concave = i;
  if (flipped)
    result.messages.push_back(make_warning(
        w_flipped,
        std::to_string(flipped) + " faces are turned over, the first at vertex " +
            std::to_string(*first_flipped) + ".",
        "Sample the outline more densely, or choose another mode.", element_of(VertexId{*first_flipped})));
  if (concave && sign == CurvatureSign::positive)
    result.messages.push_back(make_warning(
        w_result_not_convex,
        "The surface is not convex at " + std::to_string(concave) + " inner points, the first being vertex " +
            std::to_string(*first_concave) + ".",
        "Check the normals and the curvature along the outline.", element_of(VertexId{*first_concave})));
}

/// Point of the outline whose normal is nearest to that of the farthest inner point; nothing where all are
/// near.
std::optional<OutlinePoint> runs_away(const Outline& outline, const ControlPoints& result) {
  Vector3 middle = Vector3::Zero();
  for (Index i = 0; i < result.boundary_count; ++i)
    middle += result.points[i] / double(result.boundary_count);
  double furthest = 10 * outline.size();
  std::optional<Index> found;
  for (Index i = 0; i < result.points.size(); ++i) {
    const double distance = (result.points[i] - middle).norm();
    if (distance <= furthest) continue;
    found = i;
    furthest = std::isfinite(distance) ? distance : HUGE_VAL;
  }
  if (!found) return {};
  return outline_point(outline, nearest_boundary(result.normals, result.boundary_count, *found));
}

/// Final steps of all modes. `sign`: nothing where the curvature may have any sign.
Result<ControlPoints> finished(const Outline& outline, ControlPoints result,
                               const std::vector<Message>& messages, std::optional<CurvatureSign> sign) {
  if (const auto at = runs_away(outline, result))
    return make_error(e_diverged,
                      "The boundary data do not determine a bounded surface: it runs away near " +
                          to_string(outline, *at) + ".",
                      "Check the normals, or use the mode round (umbilic) or position.",
                      element_of(VertexId{at->number}));
  add_result_warnings(result, sign);
  result.messages.insert(result.messages.begin(), messages.begin(), messages.end());
  return result;
}

}  // namespace

Result<ControlPoints> control_points(const Outline& outline, const GaussOptions& given,
                                     const CancelToken& cancel) {
  HARIKO_ASSERT(given.radius > 0, "without a smallest radius insertion never ends");
  GaussOptions options = given;
  std::vector<Message> messages = check_outline(outline, options.mode, options.sign);
  const auto slanted = std::find_if(messages.begin(), messages.end(),
                                    [](const Message& message) { return message.code == w_normal_tangent; });
  for (const Message& message : messages)
    if (message.severity == Severity::error) return message;
  // Mode curvature differentiates normals, so slanted ones make it unreliable (gaussmap.md 7, noise).
  if (options.mode == GaussMode::curvature && slanted != messages.end()) {
    options.mode = GaussMode::umbilic;
    messages.push_back(make_warning(
        w_umbilic_used, "The normals are too rough for the curvature along the outline; it was not used.",
        "Make the normals perpendicular to the outline.", slanted->element));
  }
  if (options.mode_replaced)
    messages.push_back(make_warning(
        w_outline_method,
        "Hariko has no mode Minkowski any more; the surface inside the outline is that of the mode round "
        "(umbilic).",
        "Look at the surface, or choose another mode."));
  const CurvatureSign sign = curvature_sign(outline, options.sign);
  const Problem problem(outline, sign == CurvatureSign::negative);
  Solver solver(problem, options, cancel);
  if (options.mode == GaussMode::position) {
    Result<ControlPoints> made = by_position(outline, options, cancel);
    if (!made) return made;
    return finished(outline, *std::move(made), messages, {});
  }
  double radius = options.radius;
  for (;;) {
    Result<ControlPoints> made = solver.solve(radius);
    if (!made) return made;
    ControlPoints result = std::move(made).value();
    result.gap = largest_gap(result);
    if (const double found = result.gap * problem.size(); options.gap && found > *options.gap) {
      const bool limited = result.points.size() >= result.boundary_count + options.most_points;
      // The gap along the outline depends on its own steps: more sites inside do not reduce it.
      constexpr double least_radius = 0.3;
      if (radius > least_radius && !limited) {
        // The gap is proportional to the square of the spacing.
        radius =
            std::max(least_radius, radius * std::clamp(0.9 * std::sqrt(*options.gap / found), 0.25, 0.8));
        continue;
      }
      result.messages.push_back(
          make_warning(w_gap, "The tangent planes and the control points are further apart than asked for.",
                       "Sample the outline more densely."));
    }
    problem.restore(result, outline);
    return finished(outline, std::move(result), messages, sign);
  }
}

}  // namespace hariko
