#pragma once

// MeshEditor: a polyhedron being edited.

#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/document/source.hpp"
#include "core/modeling/cuts/refined_points.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Polygons by stable ids that need not be manifold between edits. Ids given to the functions must be those
/// of vertices and faces in the draft; only `finish` checks whether the polygons make a polyhedron. Stores
/// the unchanged source and the changes: k changes among n elements take O(k log n), making the draft and
/// finishing it O(n).
class MeshEditor {
 public:
  explicit MeshEditor(const PolyhedronSource& source);

  bool contains(VertexId id) const {
    return changed_vertices_.contains(id) || source_.polyhedron.find(id) != no_index;
  }
  bool contains(FaceId id) const;
  /// Whether some face has this edge as a side. O(valence).
  bool contains(EdgeId id) const { return !faces_at(id).empty(); }

  /// Position relative to the source's origin.
  const Vector3& position(VertexId id) const;
  /// Corners, counter-clockwise seen from outside; valid until the face changes.
  std::span<const VertexId> face(FaceId id) const;
  /// Positions of the face's corners, in the same order.
  std::vector<Vector3> corners(FaceId id) const;
  /// All vertices, ascending, including those without a face, which `finish` drops.
  std::vector<VertexId> vertices() const;
  /// All faces, ascending.
  std::vector<FaceId> faces() const;
  /// Faces that have this corner or side, ascending.
  std::vector<FaceId> faces_at(VertexId id) const;
  std::vector<FaceId> faces_at(EdgeId id) const;

  /// Adds a vertex; its id is the greatest id so far plus one, so that none is used twice in a draft.
  VertexId add_vertex(const Vector3& position);
  /// Adds a vertex at a point of the source's edges or faces, and records the place.
  VertexId add_vertex(const Vector3& position, const RefinedPoint& place);
  const RefinedPoints& places() const { return places_; }
  void move_vertex(VertexId id, const Vector3& position) { edit(id).position = position; }
  /// Adds a face with these corners, counter-clockwise seen from outside, and returns its new id.
  FaceId add_face(std::vector<VertexId> corners);
  /// Gives the face other corners; it keeps its id.
  void set_face(FaceId id, std::vector<VertexId> corners);
  void remove_face(FaceId id);
  /// Inserts `middle` between the ends of the edge in every face that has it. The halves inherit tension and
  /// crease. In an open edge the new vertex stays smooth although it has only two edges. O(valence).
  void split_edge(EdgeId edge, VertexId middle);

  /// Tensions, creases, tags and pins. Entries of removed elements are allowed; `finish` drops them.
  Shaping& shaping() { return shaping_; }
  const Shaping& shaping() const { return shaping_; }
  /// Gives `to` the tension and crease of `from` (default values too).
  void inherit(EdgeId from, EdgeId to);
  /// Gives `to` the tension and tag of `from`, but not its pin, which fixes the tangents of one point.
  void inherit(VertexId from, VertexId to);

  /// Allows the border to run smoothly through this vertex. By default a border vertex that is a corner
  /// because it has only two edges keeps the corner (by a tag) when it gets more edges.
  void release_corner(VertexId id) { released_corners_.insert(id); }

  /// Builds the polyhedron: vertices without a face are dropped and the shaping of removed elements is
  /// forgotten, as are `corner` tags that lost the border or creases they need. Pinned tangents stay where
  /// the edges round the vertex are the same as before; elsewhere it is no longer known which edge each
  /// belongs to, and they become a pinned tangent plane; kept forms are forgotten there. Errors:
  /// E_WOULD_BE_NONMANIFOLD, E_NO_FACES, E_NONFINITE, E_TOO_MANY_ELEMENTS.
  Result<PolyhedronSource> finish() &&;
  /// Builds the polyhedron and returns it with the elements to be selected. Errors: as above.
  Result<EditResult> finish(ElementSet selection) &&;

 private:
  struct Vertex {
    Vector3 position;
    std::vector<FaceId> faces;  ///< ascending
  };
  /// Changed copy of the vertex, made from the source's if there is none yet.
  Vertex& edit(VertexId id);
  void link(FaceId face, std::span<const VertexId> corners);
  void unlink(FaceId face, std::span<const VertexId> corners);
  void keep_outline(const Polyhedron& after);
  Result<Polyhedron> build() const;

  PolyhedronSource source_;
  std::vector<VertexId> source_corners_;                   ///< the vertex of every half-edge of the source
  std::map<VertexId, Vertex> changed_vertices_;            ///< including new ones
  std::map<FaceId, std::vector<VertexId>> changed_faces_;  ///< including new ones
  std::set<FaceId> removed_faces_;                         ///< removed faces of the source
  VertexId next_vertex_;
  FaceId next_face_;
  Shaping shaping_;
  std::set<VertexId> outline_points_;  ///< vertices inserted into open edges
  std::set<VertexId> released_corners_;
  RefinedPoints places_;
};

}  // namespace hariko
