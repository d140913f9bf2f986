#pragma once

// TransformTarget: what a transform tool acts on, as it was when the tool began.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/modeling/objects/transformation.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

class TransformTarget {
 public:
  /// The selected elements of all visible objects; in object mode the selected objects.
  static TransformTarget of(const Editor& editor);
  /// Whole objects of a document that need not be the editor's, hidden ones, too.
  static TransformTarget of_objects(const Editor& editor, Document document,
                                    std::span<const ObjectId> objects);

  bool empty() const { return parts_.empty(); }
  /// Names what is transformed: "vertex", "3 vertices", "object".
  std::string describe() const;
  bool of_elements() const { return !parts_.empty() && !parts_.front().whole; }

  /// The point that rotations and scalings leave in place: the middle of all pivots when each part has its
  /// own.
  const Vector3& pivot() const { return pivot_; }
  /// Axes of the active object, as columns; in a local edit of one vertex its tangent, what is square to it
  /// in the tangent plane, and the normal.
  const Matrix3& local_frame() const { return local_frame_; }
  /// The tangent plane of the one vertex of a local edit: its first two tangents, in the document's space.
  const std::optional<std::array<Vector3, 2>>& tangents() const { return tangents_; }
  /// Whether all that is transformed are points of sections: then the first two of the local axes lie in the
  /// plane of the first section, and changes along local axes are made in each section's own plane, about its
  /// own middle.
  bool in_planes() const { return in_planes_; }
  /// World places of what is selected (not of what follows softly).
  const std::vector<Vector3>& selected_points() const { return selected_; }
  /// Whether a vertex stays where it is: those can be snapped to.
  bool stands(ObjectId object, VertexId vertex) const;
  /// Whether anything of an object is transformed.
  bool changes(ObjectId object) const;

  /// Lets vertices within the radius follow, or none (radius 0).
  void follow(double radius, Falloff falloff);
  struct Follower {
    Vector3 place;  ///< in the document's space, before the transformation
    double weight;
  };
  /// Vertices that follow softly.
  std::vector<Follower> followers() const;

  /// `document` must be the one that the target was taken of. `local`: the transformation is along local
  /// axes. Errors: those of the edits.
  Result<Document> apply(const Document& document, const Transformation& transformation,
                         bool local = false) const;

 private:
  struct Part {
    ObjectId object;
    bool whole = false;
    Similarity transform;
    Vector3 origin = Vector3::Zero();
    Vector3 pivot = Vector3::Zero();  ///< pivot of whole objects
    std::vector<Solid> solids;        ///< those of an object with solids, as they were; nothing else then
    // Positions of elements, relative to the origin.
    std::vector<VertexId> vertices;
    std::vector<Vector3> start, pivots;  ///< pivots: relative to the origin too
    std::vector<double> weight;
    std::size_t selected = 0;  ///< vertices of the selection itself; the others follow
    // All vertices of the object, for followers.
    const Polyhedron* polyhedron = nullptr;
    /// Source with the tangents that a local edit keeps; null for control nets, which have vertices alone.
    const PolyhedronSource* tangents = nullptr;
    const Outline* outline = nullptr;  ///< in the place of the polyhedron: its points are the vertices
    const Skin* skin = nullptr;        ///< likewise: points of its sections and of its path
    /// One a vertex, from the plane of the first section to that of its own; empty where there are others
    /// than points of sections.
    std::vector<Matrix3> turns;
    std::vector<double> distance;  ///< from the selection; empty until asked for
    /// In a local edit: the object with the tangents round the vertices fixed, or why they cannot be.
    std::optional<Result<PolyhedronSource>> frozen;
  };

  void add_object(const Object& object);
  /// Adds what is selected of an object, as its kind is moved.
  void add_selected(const Object& object, const ElementSelection& elements);
  void add_elements(const Object& object, const ElementSelection& elements, const PolyhedronSource* tangents);
  void add_solids(const Object& object, const ElementSelection& elements);
  void add_points(const Object& object, const ElementSelection& elements, const Outline* outline,
                  const Skin* skin);
  void choose_planes();
  void choose_pivot(const Editor& editor);
  void choose_own_pivots(const Editor& editor);
  void freeze();
  Result<Document> apply_locally(const Document& document, const Part& part,
                                 const Transformation& local) const;
  static Result<Document> apply_to_solids(const Document& document, const Part& part,
                                          const Transformation& local);
  void follow_along(Part& part, double radius, Falloff kind);
  static Result<Document> apply_to_points(const Document& document, const Part& part,
                                          const Transformation& local);
  static Result<Document> apply_to_skin(const Document& document, const Part& part,
                                        const Transformation& local, bool in_planes);

  Document document_;  ///< keeps the polyhedra alive
  std::vector<Part> parts_;
  std::vector<Vector3> selected_;
  Vector3 pivot_ = Vector3::Zero();
  Matrix3 local_frame_ = Matrix3::Identity();
  std::optional<std::array<Vector3, 2>> tangents_;
  bool in_planes_ = false;
  std::string what_;
};

/// Objects that commands on objects act on: those selected in object mode, else the active one.
std::vector<ObjectId> selected_objects(const Editor& editor);
/// The same, the active one first: the others go into it.
std::vector<ObjectId> active_and_selected(const Editor& editor);

}  // namespace hariko
