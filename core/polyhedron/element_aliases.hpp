#pragma once

// ElementAliases: from the elements of a polyhedron that was derived from another one (the whole of a
// mirrored half) to the elements that they are copies of.

#include <vector>

#include "core/base/ids.hpp"

namespace hariko {

/// Copies have ids from `first_vertex` and `first_face` on; all lower ids are those of the original.
struct ElementAliases {
  VertexId first_vertex;
  std::vector<VertexId> vertices;  ///< the original of each copy
  FaceId first_face;
  std::vector<FaceId> faces;

  bool is_copy(VertexId id) const { return !(id < first_vertex); }
  bool is_copy(FaceId id) const { return !(id < first_face); }
  VertexId original(VertexId id) const { return is_copy(id) ? vertices[id.value - first_vertex.value] : id; }
  FaceId original(FaceId id) const { return is_copy(id) ? faces[id.value - first_face.value] : id; }
  EdgeId original(EdgeId id) const { return EdgeId::of(original(id.low), original(id.high)); }

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
        return element_of(original(EdgeId::from_packed(element.id)));
      case Element::Kind::face:
        return element_of(original(FaceId{static_cast<std::uint32_t>(element.id)}));
      default:
        return element;
    }
  }

  friend bool operator==(const ElementAliases&, const ElementAliases&) = default;
};

}  // namespace hariko
