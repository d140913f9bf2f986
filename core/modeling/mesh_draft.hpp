#pragma once

// MeshDraft: a polyhedron being edited.

#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/document/source.hpp"
#include "core/modeling/modeled.hpp"
#include "core/modeling/refined_points.hpp"

namespace hariko {

/// Polygons by stable ids that need not be manifold in between. Ids given to the functions must be those of
/// vertices and faces in the draft; whether the polygons make a polyhedron is asked by `finish` alone. Keeps
/// the source as it is and beside it what changed: k changes in n elements take O(k log n), making the draft
/// and finishing it O(n).
class MeshDraft {
 public:
  explicit MeshDraft(const PolyhedronSource& source);

  bool contains(VertexId id) const {
    return changed_vertices_.contains(id) || source_.polyhedron.find(id) != no_index;
  }
  bool contains(FaceId id) const;
  /// Whether some face has this side. O(valence).
  bool contains(EdgeId id) const { return !faces_at(id).empty(); }

  /// Relative to the source's origin.
  const Vector3& position(VertexId id) const;
  /// Corners counter-clockwise seen from outside; valid until the face changes.
  std::span<const VertexId> face(FaceId id) const;
  std::vector<Vector3> corners(FaceId id) const;
  /// Ascending. Vertices without a face are among them until `finish`.
  std::vector<VertexId> vertices() const;
  std::vector<FaceId> faces() const;
  /// The faces that have this corner or side, ascending.
  std::vector<FaceId> faces_at(VertexId id) const;
  std::vector<FaceId> faces_at(EdgeId id) const;

  /// The new id is the greatest so far plus one: none is used twice in a draft.
  VertexId add_vertex(const Vector3& position);
  /// The same for a point of the source's edges or faces, which is remembered.
  VertexId add_vertex(const Vector3& position, const RefinedPoint& place);
  const RefinedPoints& places() const { return places_; }
  void move_vertex(VertexId id, const Vector3& position) { edit(id).position = position; }
  FaceId add_face(std::vector<VertexId> corners);
  /// Gives the face other corners; it keeps its id.
  void set_face(FaceId id, std::vector<VertexId> corners);
  void remove_face(FaceId id);
  /// Puts `middle` between the ends of the edge in every face that has it. The halves inherit tension and
  /// crease. In an open edge the new point stays smooth although it has two edges only. O(valence).
  void split_edge(EdgeId edge, VertexId middle);

  /// Tensions, creases, tags and pins, carried along. Entries of elements that are gone do no harm.
  Shaping& shaping() { return shaping_; }
  const Shaping& shaping() const { return shaping_; }
  /// Gives `to` the tension and crease of `from` (also where these are the default).
  void inherit(EdgeId from, EdgeId to);
  /// Gives `to` the tension and tag of `from`. Pins stay where they are: each fixes one point's tangents.
  void inherit(VertexId from, VertexId to);

  /// Where the border turns a corner because a vertex has two edges only, it keeps that corner (by a tag)
  /// when it gets more edges; not so where the border is to go on straight from here.
  void release_corner(VertexId id) { released_corners_.insert(id); }

  /// The polyhedron: vertices without a face are dropped and the shaping of elements that are gone is
  /// forgotten, as are `corner` tags that lost the border or creases they need. Pinned tangents stay where
  /// the edges round the vertex are the same as before; elsewhere they no longer say which edge they are for,
  /// and become a pinned tangent plane; kept forms are forgotten there. Errors: E_WOULD_BE_NONMANIFOLD,
  /// E_NO_FACES, E_NONFINITE, E_TOO_MANY_ELEMENTS.
  Result<PolyhedronSource> finish() &&;
  /// The same with the elements that the designer goes on with.
  Result<Modeled> finish(ElementSet selection) &&;

 private:
  struct Vertex {
    Vector3 position;
    std::vector<FaceId> faces;  ///< ascending
  };
  /// The vertex among those that changed, where it is put if it was not there.
  Vertex& edit(VertexId id);
  void link(FaceId face, std::span<const VertexId> corners);
  void unlink(FaceId face, std::span<const VertexId> corners);
  void keep_outline(const Polyhedron& after);
  Result<Polyhedron> build() const;

  PolyhedronSource source_;
  std::vector<VertexId> source_corners_;                   ///< the vertex of every half-edge of the source
  std::map<VertexId, Vertex> changed_vertices_;            ///< and new ones
  std::map<FaceId, std::vector<VertexId>> changed_faces_;  ///< and new ones
  std::set<FaceId> removed_faces_;                         ///< of the source
  VertexId next_vertex_;
  FaceId next_face_;
  Shaping shaping_;
  std::set<VertexId> outline_points_;  ///< put into open edges
  std::set<VertexId> released_corners_;
  RefinedPoints places_;
};

}  // namespace hariko
