#pragma once

// ConvexHull: the convex hull of points in space, grown point by point with exact decisions.

#include <array>
#include <optional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Of points on a sphere the hull is their Delaunay triangulation. Coplanar points are triangulated in some
/// way that depends on their order only. Points inside or on the hull of the earlier ones are passed over.
class ConvexHull {
 public:
  /// Counter-clockwise from outside; neighbour k lies beyond the edge from corner k to corner k + 1. Faces
  /// that were removed stay in the list with `alive` false, so numbers of faces hold.
  struct Face {
    std::array<Index, 3> corner;
    std::array<Index, 3> neighbour;
    bool alive = true;
  };
  /// What a new point sees: the faces that it removes and the edges around them, in order.
  struct Horizon {
    struct Edge {
      Index from, to;
      Index beyond;  ///< the face that stays
    };
    std::vector<Index> faces;
    std::vector<Edge> edges;
  };

  /// Expected O(n log n) to O(n^1.5). None when all points lie in one plane.
  static std::optional<ConvexHull> build(std::vector<Vector3> points);

  const std::vector<Vector3>& points() const { return points_; }
  const std::vector<Face>& faces() const { return faces_; }
  bool sees(const Vector3& point, Index face) const;
  /// A face that the point sees, no_index when it lies inside or on the hull.
  Index visible_face(const Vector3& point) const;
  /// `seed`: a living face that the point sees.
  Horizon horizon(const Vector3& point, Index seed) const;
  /// Adds the point over its horizon and gives its number. The new faces are the last `horizon.edges.size()`
  /// ones, one an edge, with the edge as their side 0.
  Index insert(const Vector3& point, const Horizon& horizon);

 private:
  bool begin(const std::array<Index, 4>& corners);
  Index walk(const Vector3& point) const;
  void connect(Index point, const Horizon& horizon);

  std::vector<Vector3> points_;
  std::vector<Face> faces_;
  Vector3 inner_ = Vector3::Zero();  ///< strictly inside
};

}  // namespace hariko
