#include "core/gaussmap/sphere/paper_insertion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/gaussmap/halfspace_intersection.hpp"
#include "core/gaussmap/minkowski.hpp"

namespace hariko {
namespace {

/// Part of a convex polygon where axis . x <= limit.
std::vector<Vector3> clipped(const std::vector<Vector3>& polygon, const Vector3& axis, double limit) {
  std::vector<Vector3> out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double da = axis.dot(a) - limit, db = axis.dot(b) - limit;
    if (da <= 0) out.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) out.push_back(a + (b - a) * (da / (da - db)));
  }
  return out;
}

struct Placement {
  double height;
  bool clamped;
};

/// One insertion: the existing planes, and the new plane's direction.
class PlanePlacement {
 public:
  PlanePlacement(const SphereMesh& mesh, const TangentPolytope& polytope, const BoundaryData& boundary,
                 const std::vector<double>& curvature, double low, double high, CellMeasure measure)
      : mesh_(mesh),
        polytope_(polytope),
        boundary_(boundary),
        curvature_(curvature),
        site_(mesh.site_count() - 1),
        direction_(mesh.site(site_)),
        low_(low),
        high_(high),
        measure_(measure) {}

  Placement place(PaperRule rule) const {
    const auto& neighbours = mesh_.ring(site_).neighbours;
    if (rule == PaperRule::own_facet) return by_own_facet();
    if (rule == PaperRule::all_neighbours) {
      Placement mean{0, false};
      for (const Index k : neighbours) {
        const Placement one = by_facet(k);
        mean.height += one.height / double(neighbours.size());
        mean.clamped |= one.clamped;
      }
      return mean;
    }
    const Index worst = *std::max_element(neighbours.begin(), neighbours.end(), [&](Index a, Index b) {
      return facet_area(a, high_) / target(a) < facet_area(b, high_) / target(b);
    });
    return by_facet(worst);
  }

 private:
  double target(Index k) const {
    return (measure_ == CellMeasure::solid_angle ? mesh_.solid_angle(k) : mesh_.gnomonic_area(k)) /
           curvature_[k];
  }

  /// Area of the part of facet k where direction . x <= height, on the surface's side of the outline.
  double facet_area(Index k, double height) const {
    const Vector3& n = mesh_.site(k);
    const std::vector<Vector3> cut = clipped(polytope_.facets()[k].corners, direction_, height);
    const auto area = [&](const std::vector<Vector3>& polygon) {
      return polygon.size() < 3 ? 0 : polygon_area(polygon, n);
    };
    if (!mesh_.is_boundary(k)) return area(cut);
    const Vector3& p = boundary_.points[k];
    const Vector3 to_next = boundary_.points[mesh_.next(k)] - p,
                  from_previous = p - boundary_.points[mesh_.previous(k)];
    const auto left_of = [&](const std::vector<Vector3>& polygon, const Vector3& line) {
      const Vector3 right = line.cross(n);
      return clipped(polygon, right, right.dot(p));
    };
    const std::vector<Vector3> first = left_of(cut, to_next);
    const double both = area(left_of(first, from_previous));
    if (from_previous.cross(to_next).dot(n) >= 0) return both;
    // At a reflex corner the union of both sides counts.
    return area(first) + area(left_of(cut, from_previous)) - both;
  }

  /// Finds the height by bisection; the facet's area does not decrease with the height.
  Placement by_facet(Index k) const {
    const double wanted = target(k);
    if (wanted >= facet_area(k, high_)) return clamp(high_);
    if (wanted <= facet_area(k, low_)) return clamp(low_);
    double low = low_, high = high_;
    for (int step = 0; step < 80; ++step) {
      const double middle = (low + high) / 2;
      (facet_area(k, middle) < wanted ? low : high) = middle;
    }
    return kept_inside((low + high) / 2);
  }

  /// Area of the section at a height: each facet adds a triangle with a point of the plane.
  double section_area(double height) const {
    const Vector3 centre = direction_ * height;
    double sum = 0;
    for (Index i = 0; i < site_; ++i) {
      const auto& corners = polytope_.facets()[i].corners;
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

  /// Searches downwards from the top for the first height whose section has the wanted area.
  Placement by_own_facet() const {
    const double wanted = target(site_);
    std::vector<double> heights{low_};
    for (Index i = 0; i < site_; ++i)
      for (const Vector3& corner : polytope_.facets()[i].corners)
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
        if (section_area(at) < wanted) continue;
        double high = above + (below - above) * (part - 1) / parts, low = at;
        for (int step = 0; step < 80; ++step) {
          const double middle = (low + high) / 2;
          (section_area(middle) < wanted ? high : low) = middle;
        }
        return kept_inside((low + high) / 2);
      }
      above = below;
    }
    return clamp(low_);
  }

  Placement kept_inside(double height) const {
    const double margin = 1e-6 * (high_ - low_);
    return {std::clamp(height, low_ + margin, high_ - margin), false};
  }
  Placement clamp(double height) const { return {kept_inside(height).height, true}; }

  const SphereMesh& mesh_;
  const TangentPolytope& polytope_;
  const BoundaryData& boundary_;
  const std::vector<double>& curvature_;  ///< at all sites, including the new one
  Index site_;
  Vector3 direction_;
  double low_, high_;
  CellMeasure measure_;
};

}  // namespace

Result<PaperResult> insert_by_paper(SiteInsertion& insertion, const BoundaryData& boundary,
                                    double smallest_radius, const GaussOptions& options,
                                    const CancelToken& cancel) {
  PaperResult out;
  out.points = boundary.points;
  out.curvature = boundary.curvature;
  std::vector<Vector3> normals = insertion.mesh().sites();
  for (std::size_t i = 0; i < normals.size(); ++i) out.support.push_back(normals[i].dot(boundary.points[i]));
  Index count = 0;
  for (; count < options.most_points; ++count) {
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
    out.curvature.push_back(options.curvature_inside ? options.curvature_inside(direction) : curvature);
    const Vector3 corner = polytope->farthest(direction);
    const double high = direction.dot(corner);
    double low = -HUGE_VAL;
    for (const Vector3& point : out.points) low = std::max(low, direction.dot(point));
    const Placement placed =
        PlanePlacement(mesh, *polytope, boundary, out.curvature, low, high, options.measure)
            .place(options.rule);
    out.clamped_count += placed.clamped ? 1 : 0;
    normals.push_back(direction);
    out.support.push_back(placed.height);
    out.points.push_back(corner - (high - placed.height) * direction);
  }
  out.limited = count == options.most_points && insertion.largest_radius() >= smallest_radius;
  return out;
}

}  // namespace hariko
