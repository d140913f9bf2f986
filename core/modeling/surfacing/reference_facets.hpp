#pragma once

// ReferenceFacets: the triangles of one or several references, as a scan is, seen from a polyhedron: the
// nearest points on them, and which of these lie on their border.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/document/similarity.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace hariko {

/// Triangles of one reference: positions relative to `origin`, in a space that `transform` places.
struct FacetPart {
  std::span<const Vector3> positions;
  std::span<const std::array<Index, 3>> triangles;  ///< indices in range
  Vector3 origin = Vector3::Zero();
  Similarity transform = {};
};

/// Point of a reference that is nearest to another point.
struct ReferenceFoot {
  Vector3 position = Vector3::Zero();  ///< the point itself where it lies on the facet within rounding
  /// Unit vector from the foot to the point; the facet's normal where the point lies on it, zero if that
  /// facet has no area.
  Vector3 direction = Vector3::Zero();
  double distance = 0;
  /// The foot lies on the border of its reference, and the point beside it: more than 25° off the facet's
  /// normal. The reference says nothing about such a point.
  bool is_beyond = false;
};

/// Facets of all parts, in the space of a polyhedron's positions. Immutable; queries are thread-safe.
class ReferenceFacets {
 public:
  /// Takes the parts, of which at least one has triangles (asserted), to where positions relative to `origin`
  /// are in an object placed by `transform`. O(n log n).
  ReferenceFacets(std::span<const FacetPart> parts, const Vector3& origin, const Similarity& transform);

  /// Nearest point of all parts; of equally near triangles the first. O(log n) near the triangles.
  ReferenceFoot foot(const Vector3& point) const;
  /// Diagonal of the box round all facets.
  double size() const { return tree_.size(); }

 private:
  struct Gathered;
  explicit ReferenceFacets(Gathered gathered);
  bool is_on_border(Index triangle, const Vector3& foot) const;

  std::vector<Vector3> positions_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<std::uint8_t> border_sides_;  ///< per triangle: bit k for the side from its corner k
  std::vector<bool> border_points_;         ///< per position
  TriangleTree tree_;
};

}  // namespace hariko
