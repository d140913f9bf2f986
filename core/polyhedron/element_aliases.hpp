#pragma once

// ElementAliases: a map from the elements of a derived polyhedron (concave faces cut, a half mirrored) to the
// elements that the designer knows.

#include <utility>
#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"

namespace hariko {

/// Map from derived elements to original ones. Mirrored copies have ids from `first_vertex` and `first_face`
/// on; lower ids belong to the half that was copied. There, faces may be pieces of an original face,
/// separated by inner edges that the original does not have.
struct ElementAliases {
  VertexId first_vertex{no_index};
  std::vector<VertexId> vertices;  ///< original of each copied vertex
  FaceId first_face{no_index};
  /// Original of each copied face, before `pieces` is applied.
  std::vector<FaceId> faces;
  FlatMap<FaceId, FaceId> pieces;       ///< original face of each piece that has an id of its own
  FlatMap<EdgeId, FaceId> inner_edges;  ///< original face that each inner edge lies in
  /// Original faces that were merged into another one, with the face they went into; `sides` gives the
  /// original face of a side (origin, target) of a merged face.
  FlatMap<FaceId, FaceId> merged;
  FlatMap<std::pair<VertexId, VertexId>, FaceId> sides;

  bool is_copy(VertexId id) const { return !(id < first_vertex); }
  bool is_copy(FaceId id) const { return !(id < first_face); }
  VertexId original(VertexId id) const { return is_copy(id) ? vertices[id.value - first_vertex.value] : id; }
  FaceId original(FaceId id) const {
    const FaceId copied = is_copy(id) ? faces[id.value - first_face.value] : id;
    return pieces.get_or(copied, copied);
  }
  /// Original face of the patch over a side.
  FaceId original(FaceId face, VertexId origin, VertexId target) const {
    const FaceId* own = nullptr;
    if (!sides.empty())
      own = is_copy(face) ? sides.find({original(target), original(origin)}) : sides.find({origin, target});
    return own ? *own : original(face);
  }
  /// Original edge, or the original face of an inner edge.
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
  /// Original of an element of any kind; other kinds are their own.
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
