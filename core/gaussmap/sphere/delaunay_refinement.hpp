#pragma once

// SiteInsertion: sites on the Gauss sphere, inserted one by one into the Delaunay triangulation inside the
// loops.

#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/gaussmap/sphere/spherical_delaunay.hpp"
#include "core/geometry/convex_hull.hpp"

namespace hariko {

inline constexpr Code e_boundary_edge{"E_BOUNDARY_EDGE"};
inline constexpr Code e_image_leak{"E_LEAK"};

/// Incremental Bowyer-Watson algorithm with exact predicates; the next site is the centre of the largest
/// empty circle whose centre is inside (gaussmap.md 3). The loops stay edges of the triangulation: a centre
/// inside the circle over an arc of a loop is skipped. Expected O(log n) per site, and O(arcs).
class SiteInsertion {
 public:
  /// Makes the triangulation of the loops. `loops`: unit vectors, at least three per loop; the image lies on
  /// the left of each. Errors: E_BOUNDARY_EDGE (an arc is no edge of the Delaunay triangulation), E_LEAK (the
  /// image is not bounded by the loops); the element is the vertex, counted through all loops, where the arc
  /// begins. `reversed`: the loops are those of a reversed outline, and errors name the points of the
  /// original.
  static Result<SiteInsertion> begin(const std::vector<std::vector<Vector3>>& loops, bool reversed = false);

  /// Median angle between a site and its neighbour on the loop over all arcs, radians.
  double boundary_spacing() const { return boundary_spacing_; }
  /// Inserts the next site; nothing when no empty circle is as large as `smallest_radius` (radians) any more.
  std::optional<Index> insert_next(double smallest_radius);
  /// Radius of the largest empty circle with an admissible centre, 0 when there is none. May search, like
  /// `insert_next`.
  double largest_radius();

  Index site_count() const { return static_cast<Index>(hull_.points().size()) - guard_count_; }
  SphereMesh mesh() const;

 private:
  struct Candidate {
    double radius;
    Index face;
    bool operator<(const Candidate& other) const {
      return radius != other.radius ? radius < other.radius : face > other.face;
    }
  };
  struct Arc {
    Vector3 middle;
    double cosine;  ///< cosine of half the arc's angle
  };
  SiteInsertion(ConvexHull hull, std::vector<Index> next, Index guard_count);
  Result<Done> fill_inside(const std::vector<std::vector<Vector3>>& loops, bool reversed);
  bool is_loop_edge(Index a, Index b) const;
  void offer(Index face);
  /// Horizon of the face's circumcentre; empty when that is not admissible as a site.
  ConvexHull::Horizon admissible_horizon(Index face, const Vector3& centre) const;
  bool near_loop(const Vector3& centre) const;
  /// Drops candidates whose face no longer exists, until the best remaining one is on top.
  bool find_top();

  ConvexHull hull_;
  std::vector<Index> next_;
  std::vector<Arc> arcs_;
  Index guard_count_ = 0;  ///< 1 when the first point after the loops is not a site
  double boundary_spacing_ = 0;
  std::vector<char> inside_;  ///< one per face of the hull
  std::priority_queue<Candidate> candidates_;
};

}  // namespace hariko
