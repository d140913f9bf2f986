#pragma once

// ElementNames: the names of elements in messages, from dense indices.

#include <span>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Names of elements by given stable ids, or by the dense indices themselves where none are given.
struct ElementNames {
  std::span<const VertexId> vertex_ids;
  std::span<const FaceId> face_ids;

  VertexId vertex_id(Index v) const { return vertex_ids.empty() ? VertexId{v} : vertex_ids[v]; }
  FaceId face_id(Index f) const { return face_ids.empty() ? FaceId{f} : face_ids[f]; }
  Element vertex(Index v) const { return element_of(vertex_id(v)); }
  Element face(Index f) const { return element_of(face_id(f)); }
  Element edge(Index a, Index b) const { return element_of(EdgeId::of(vertex_id(a), vertex_id(b))); }

  /// Name of an element that is given by dense indices.
  Element of_dense(const Element& dense) const {
    switch (dense.kind) {
      case Element::Kind::vertex:
        return vertex(static_cast<Index>(dense.id));
      case Element::Kind::face:
        return face(static_cast<Index>(dense.id));
      case Element::Kind::edge: {
        const EdgeId pair = EdgeId::from_packed(dense.id);
        return edge(pair.low.value, pair.high.value);
      }
      default:
        return dense;
    }
  }
};

}  // namespace hariko
