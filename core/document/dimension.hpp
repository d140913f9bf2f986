#pragma once

// Dimension: a distance, an angle or a radius that the designer keeps. Its anchors name elements of objects,
// so that it follows them; values are derived (core/modeling/measuring/measured_dimension.hpp).

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Name of a dimension within its document; the default is no dimension.
struct DimensionId {
  std::uint32_t value = 0xffffffffU;
  friend auto operator<=>(const DimensionId&, const DimensionId&) = default;
};

/// Point of the document's space, which follows nothing.
struct SpaceAnchor {
  Vector3 point = Vector3::Zero();  ///< in the document's unit
  friend bool operator==(const SpaceAnchor&, const SpaceAnchor&) = default;
};

/// Point of an object's own space, or of one of its solids: it follows their placement and not their shape.
struct ObjectAnchor {
  ObjectId object;
  Vector3 point = Vector3::Zero();  ///< in the object's space; with `solid` in the solid's, before its scale
  std::optional<std::uint32_t> solid = {};
  friend bool operator==(const ObjectAnchor&, const ObjectAnchor&) = default;
};

/// Vertex of a polyhedron or of a net of patches by its id, point of a section of a skin by its id, centre of
/// a solid by the solid's id; point of an outline and vertex of a reference mesh by its number.
struct VertexAnchor {
  ObjectId object;
  VertexId vertex;
  bool image = false;  ///< with a live mirror of the polyhedron: the image of the vertex
  friend bool operator==(const VertexAnchor&, const VertexAnchor&) = default;
};

/// Point of an edge of a polyhedron or net: on its curve on the surface, or on the straight line.
struct EdgeAnchor {
  ObjectId object;
  EdgeId edge;
  double share =
      0.5;  ///< from the vertex with the smaller id, 0 .. 1: of the curve's parameter or of the length
  bool straight = false;  ///< on the line between the vertices
  friend bool operator==(const EdgeAnchor&, const EdgeAnchor&) = default;
};

/// Point of a surface whose patches keep their names: that of a polyhedron, of patches, facets of a reference
/// mesh.
struct PatchAnchor {
  ObjectId object;
  Element element;  ///< element that the patch comes from (`Provenance`)
  std::uint32_t side =
      0;  ///< as in `PaperVertex`: of the element, plus 65536 for each earlier patch with its names
  Vector2 parameter = Vector2::Zero();  ///< in the patch's domain
  friend bool operator==(const PatchAnchor&, const PatchAnchor&) = default;
};

/// Point of the surface that is nearest to a point of the object's own space: for surfaces whose patches come
/// and go (round solids, over sections, inside of outlines).
struct NearestAnchor {
  ObjectId object;
  Vector3 point = Vector3::Zero();
  friend bool operator==(const NearestAnchor&, const NearestAnchor&) = default;
};

using Anchor = std::variant<SpaceAnchor, ObjectAnchor, VertexAnchor, EdgeAnchor, PatchAnchor, NearestAnchor>;

/// Object that an anchor names; null for points of the document's space.
ObjectId* object_of(Anchor& anchor);
const ObjectId* object_of(const Anchor& anchor);

enum class DimensionKind : std::uint8_t {
  distance,  ///< between two anchors
  angle,     ///< between three anchors, at the second one
  radius     ///< both principal radii of curvature of the surface at one anchor
};
/// Number of anchors of a kind: 2, 3, 1.
std::size_t anchor_count(DimensionKind kind);

/// Invariants (checked by `add_dimension` and by the file reader): as many anchors as the kind has, finite
/// numbers, the anchor of a radius on a surface. What anchors name may be gone: such a dimension has no
/// value.
struct Dimension {
  DimensionId id;
  DimensionKind kind = DimensionKind::distance;
  std::vector<Anchor> anchors;
  /// From where the label stands by itself to where it was moved, in the document's space and unit; zero: not
  /// moved.
  Vector3 label = Vector3::Zero();
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

using Dimensions = std::vector<Dimension>;

/// Largest id of a dimension.
inline constexpr std::uint32_t max_dimension_id = 0x7fffffffU;
/// Id for a new dimension: above all others, or the lowest free one where that would be too large. O(n log
/// n).
DimensionId next_dimension_id(const Dimensions& dimensions);

/// Whether the numbers and the kinds of anchors of a dimension are as they must be; ids are not looked at.
bool is_sound(const Dimension& dimension);

}  // namespace hariko
