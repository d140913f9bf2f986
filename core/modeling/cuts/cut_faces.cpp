#include "core/modeling/cuts/cut_faces.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/geometry/polygon.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/selection/selected.hpp"
#include "core/polyhedron/face_decomposition.hpp"

namespace hariko {
namespace {

/// Replaces the face by the pieces (given by corner numbers of the face).
void replace_face(MeshEditor& draft, FaceId face, const std::vector<std::vector<Index>>& pieces,
                  ElementSet& selection) {
  const auto old = draft.face(face);
  const std::vector<VertexId> corners(old.begin(), old.end());
  bool first = true;
  for (const std::vector<Index>& piece : pieces) {
    std::vector<VertexId> own;
    for (const Index i : piece) own.push_back(corners[i]);
    if (first)
      draft.set_face(face, std::move(own));
    else
      selection.faces.insert(draft.add_face(std::move(own)));
    first = false;
  }
  selection.faces.insert(face);
}

Message cannot_cut(FaceId face, std::size_t sides) {
  if (sides > largest_cut_polygon)
    return make_error(e_too_many_elements, "The face has too many sides to be cut.",
                      "Split the face by hand first.", element_of(face));
  return make_error(e_would_be_nonmanifold, "The corners of the face are joined by edges of other faces.",
                    "Choose other faces.", element_of(face));
}

/// Calls cut(corners, may_join) for each face; if it returns several pieces, they replace the face.
template <class Cut>
Result<EditResult> cut_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                             const char* nothing, Cut&& cut) {
  const auto chosen = selected(source.polyhedron, faces, "Select faces.");
  if (!chosen) return chosen.error();
  MeshEditor draft(source);
  ElementSet selection;
  for (const Index f : *chosen) {
    const FaceId face = source.polyhedron.face_id(f);
    const auto ids = source.polyhedron.topology().face_vertices(f);
    const MayJoin may_join = [&](Index a, Index b) {
      return !draft.contains(
          EdgeId::of(source.polyhedron.vertex_id(ids[a]), source.polyhedron.vertex_id(ids[b])));
    };
    const auto pieces = cut(draft.corners(face), may_join);
    if (!pieces) return cannot_cut(face, ids.size());
    if (pieces->size() > 1) replace_face(draft, face, *pieces, selection);
  }
  if (selection.empty()) return make_error(e_wrong_selection, nothing, "Select other faces.");
  return std::move(draft).finish(std::move(selection));
}

}  // namespace

Result<EditResult> triangulate_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  using Pieces = std::optional<std::vector<std::vector<Index>>>;
  return cut_faces(source, faces, "The faces are triangles already.",
                   [](const std::vector<Vector3>& corners, const MayJoin& may_join) -> Pieces {
                     const auto triangles = triangles_of(corners, may_join);
                     if (!triangles) return std::nullopt;
                     std::vector<std::vector<Index>> pieces;
                     for (const auto& triangle : *triangles)
                       pieces.emplace_back(triangle.begin(), triangle.end());
                     return pieces;
                   });
}

Result<EditResult> decompose_concave_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  using Pieces = std::optional<std::vector<std::vector<Index>>>;
  return cut_faces(source, faces, "None of the faces is concave.",
                   [](const std::vector<Vector3>& corners, const MayJoin& may_join) -> Pieces {
                     if (classify_face(corners) != FaceShape::concave)
                       return std::vector<std::vector<Index>>(1);  // a single piece: the face stays
                     return convex_pieces(corners, may_join);
                   });
}

}  // namespace hariko
