#pragma once

// ConvexHull: the convex hull of points in space, grown point by point with exact decisions.

#include <array>
#include <optional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Convex hull of points in space. For points on a sphere it is their Delaunay triangulation. Coplanar points
/// are triangulated in a way that depends on their order only. Points inside or on the hull of the earlier
/// ones are skipped.
class ConvexHull {
 public:
  /// Triangle, counter-clockwise from outside; neighbour k lies beyond the edge from corner k to corner k +
  /// 1. Removed faces stay in the list with `alive` false, so face numbers remain valid.
  struct Face {
    std::array<Index, 3> corner;
    std::array<Index, 3> neighbour;
    bool alive = true;
  };
  /// Horizon of a new point: the faces that it sees, which insertion removes, and the edges around them, in
  /// order.
  struct Horizon {
    struct Edge {
      Index from, to;
      Index beyond;  ///< the face across the edge, which stays
    };
    std::vector<Index> faces;
    std::vector<Edge> edges;
  };

  /// Builds the hull, in expected O(n log n) to O(n^1.5). Nothing when all points lie in one plane.
  static std::optional<ConvexHull> build(std::vector<Vector3> points);

  const std::vector<Vector3>& points() const { return points_; }
  const std::vector<Face>& faces() const { return faces_; }
  /// Whether the point lies strictly beyond the plane of a face; exact.
  bool sees(const Vector3& point, Index face) const;
  /// A face that the point sees, no_index when the point lies inside or on the hull.
  Index visible_face(const Vector3& point) const;
  /// Horizon of a point; `seed` is a living face that the point sees.
  Horizon horizon(const Vector3& point, Index seed) const;
  /// Adds the point over its horizon and returns its number. The new faces are the last
  /// `horizon.edges.size()` ones, one per edge, with the edge as their side 0.
  Index insert(const Vector3& point, const Horizon& horizon);

 private:
  bool begin(const std::array<Index, 4>& corners);
  Index walk(const Vector3& point) const;
  void connect(Index point, const Horizon& horizon);

  std::vector<Vector3> points_;
  std::vector<Face> faces_;
  Vector3 inner_ = Vector3::Zero();  ///< a point strictly inside the hull
};

}  // namespace hariko
