#pragma once

// ElementAliases: from the elements of a polyhedron that was derived from another one (concave faces cut, a
// half mirrored) to the elements that the designer knows.

#include <utility>
#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"

namespace hariko {

/// Copies have ids from `first_vertex` and `first_face` on; all lower ids are those of what was copied. Of
/// that, faces may be pieces of a face, between inner edges that the designer does not have.
struct ElementAliases {
  VertexId first_vertex{no_index};
  std::vector<VertexId> vertices;  ///< what each copy is of
  FaceId first_face{no_index};
  std::vector<FaceId> faces;
  FlatMap<FaceId, FaceId> pieces;       ///< the face that each piece with an id of its own is part of
  FlatMap<EdgeId, FaceId> inner_edges;  ///< the face that each inner edge lies in
  /// Faces that were merged into another one, and which that is; and where the sides (origin, target) of such
  /// faces come from.
  FlatMap<FaceId, FaceId> merged;
  FlatMap<std::pair<VertexId, VertexId>, FaceId> sides;

  bool is_copy(VertexId id) const { return !(id < first_vertex); }
  bool is_copy(FaceId id) const { return !(id < first_face); }
  VertexId original(VertexId id) const { return is_copy(id) ? vertices[id.value - first_vertex.value] : id; }
  FaceId original(FaceId id) const {
    const FaceId copied = is_copy(id) ? faces[id.value - first_face.value] : id;
    return pieces.get_or(copied, copied);
  }
  /// The face that a patch over a side belongs to.
  FaceId original(FaceId face, VertexId origin, VertexId target) const {
    const FaceId* own = nullptr;
    if (!sides.empty())
      own = is_copy(face) ? sides.find({original(target), original(origin)}) : sides.find({origin, target});
    return own ? *own : original(face);
  }
  /// An edge, or the face where it is an inner edge.
  Element original(EdgeId id) const {
    const EdgeId copied = EdgeId::of(original(id.low), original(id.high));
    const FaceId* face = inner_edges.find(copied);
    return face ? element_of(*face) : element_of(copied);
  }

  bool is_copy(const Element& element) const {
    switch (element.kind) {
      case Element::Kind::vertex:
        return is_copy(VertexId{static_cast<std::uint32_t>(element.id)});
      case Element::Kind::edge:
        return is_copy(EdgeId::from_packed(element.id).high);  // copies have the higher ids
      case Element::Kind::face:
        return is_copy(FaceId{static_cast<std::uint32_t>(element.id)});
      default:
        return false;
    }
  }
  Element original(const Element& element) const {
    switch (element.kind) {
      case Element::Kind::vertex:
        return element_of(original(VertexId{static_cast<std::uint32_t>(element.id)}));
      case Element::Kind::edge:
        return original(EdgeId::from_packed(element.id));
      case Element::Kind::face:
        return element_of(original(FaceId{static_cast<std::uint32_t>(element.id)}));
      default:
        return element;
    }
  }

  friend bool operator==(const ElementAliases&, const ElementAliases&) = default;
};

}  // namespace hariko
