#include "core/gaussmap/sphere/paper_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/gaussmap/halfspace_intersection.hpp"

namespace hariko {
namespace {

struct PlaneHeight {
  double height;
  bool clamped;
};

/// One insertion: the existing planes, and the new plane's direction.
class PlanePlacement {
 public:
  /// The new site is the last one of `mesh`; `curvature` is that at it.
  PlanePlacement(const SphereMesh& mesh, const TangentPolytope& polytope, double curvature, double low,
                 double high)
      : mesh_(mesh),
        polytope_(polytope),
        site_(mesh.site_count() - 1),
        direction_(mesh.site(site_)),
        area_(mesh.solid_angle(site_) / curvature),
        low_(low),
        high_(high) {}

  /// Searches downwards from the top for the first height whose section has the wanted area.
  PlaneHeight place() const {
    std::vector<double> heights{low_};
    for (Index i = 0; i < site_; ++i)
      for (const Vector3& corner : polytope_.facets()[i])
        if (const double height = direction_.dot(corner); height > low_ && height < high_)
          heights.push_back(height);
    std::sort(heights.begin(), heights.end(), std::greater<>());
    double above = high_;
    // The square root of the area is concave: its maximum may lie between two corners.
    constexpr int parts = 8;
    for (const double below : heights) {
      if (above - below < 1e-14 * (high_ - low_)) continue;
      for (int part = 1; part <= parts; ++part) {
        const double at = part == parts ? below : above + (below - above) * part / parts;
        if (section_area(at) < area_) continue;
        double high = above + (below - above) * (part - 1) / parts, low = at;
        for (int step = 0; step < 80; ++step) {
          const double middle = (low + high) / 2;
          (section_area(middle) < area_ ? high : low) = middle;
        }
        return {kept_inside((low + high) / 2), false};
      }
      above = below;
    }
    return {kept_inside(low_), true};
  }

 private:
  /// Area of the section at a height: each facet adds a triangle with a point of the plane.
  double section_area(double height) const {
    const Vector3 centre = direction_ * height;
    double sum = 0;
    for (Index i = 0; i < site_; ++i) {
      const std::vector<Vector3>& corners = polytope_.facets()[i];
      std::vector<Vector3> ends;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
        const double da = direction_.dot(a) - height, db = direction_.dot(b) - height;
        if ((da < 0) != (db < 0)) ends.push_back(a + (b - a) * (da / (da - db)));
      }
      if (ends.size() != 2) continue;
      const Vector3 outward = (mesh_.site(i) - mesh_.site(i).dot(direction_) * direction_).normalized();
      sum += (ends[1] - ends[0]).norm() * outward.dot(ends[0] - centre) / 2;
    }
    return sum;
  }

  double kept_inside(double height) const {
    const double margin = 1e-6 * (high_ - low_);
    return std::clamp(height, low_ + margin, high_ - margin);
  }

  const SphereMesh& mesh_;
  const TangentPolytope& polytope_;
  Index site_;
  Vector3 direction_;
  double area_;  ///< wanted area of the new facet
  double low_, high_;
};

}  // namespace

Result<PaperResult> insert_by_paper(SiteInsertion& insertion, const BoundaryData& boundary,
                                    double smallest_radius, Index most_points, const CancelToken& cancel) {
  PaperResult out;
  out.points = boundary.points;
  out.curvature = boundary.curvature;
  std::vector<Vector3> normals = insertion.mesh().sites();
  for (std::size_t i = 0; i < normals.size(); ++i) out.support.push_back(normals[i].dot(boundary.points[i]));
  Index count = 0;
  for (; count < most_points; ++count) {
    if (cancel.cancelled()) return make_error(e_cancelled, "The computation was cancelled.");
    const auto inserted = insertion.insert_next(smallest_radius);
    if (!inserted) break;
    const SphereMesh mesh = insertion.mesh();
    const Vector3 direction = mesh.site(*inserted);
    const auto inner = inner_point(normals, out.support, out.points, 1);
    const auto polytope = inner ? TangentPolytope::build(normals, out.support, *inner, 1) : std::nullopt;
    if (!polytope)
      return make_error(e_curvature_unreachable, "The tangent planes leave no room for a surface.",
                        "Use the mode curvature.");
    const auto& neighbours = mesh.ring(*inserted).neighbours;
    double curvature = 0;
    for (const Index k : neighbours) curvature += out.curvature[k] / double(neighbours.size());
    out.curvature.push_back(curvature);
    const Vector3 corner = polytope->farthest(direction);
    const double high = direction.dot(corner);
    double low = -HUGE_VAL;
    for (const Vector3& point : out.points) low = std::max(low, direction.dot(point));
    const PlaneHeight placed = PlanePlacement(mesh, *polytope, curvature, low, high).place();
    out.clamped_count += placed.clamped ? 1 : 0;
    normals.push_back(direction);
    out.support.push_back(placed.height);
    out.points.push_back(corner - (high - placed.height) * direction);
  }
  out.limited = count == most_points && insertion.largest_radius() >= smallest_radius;
  return out;
}

}  // namespace hariko
