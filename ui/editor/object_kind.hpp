#pragma once

// ObjectKind: how the interface selects, names, draws and finds the elements of an object, by the kind of its
// source. Whatever treats all objects alike asks the kind instead of looking at the source; a new kind
// answers here.

#include <memory>
#include <optional>
#include <string>

#include "core/document/document.hpp"
#include "render/scene.hpp"
#include "ui/editor/selection.hpp"

namespace hariko {

struct ViewSettings;

/// Lines of an object, drawn and picked over its surface.
struct ObjectLines {
  std::shared_ptr<const DisplayPolyhedron> polyhedron;  ///< null: nothing
  std::optional<Polyhedron> attached;  ///< what it shows, where vertices are attached to other objects
};

class ObjectKind {
 public:
  virtual ~ObjectKind() = default;

  /// All elements of a mode, as "select all" takes them; none where the kind has none.
  virtual ElementSelection all(const Object& object, ElementMode mode) const;
  /// The elements of a selection that the object has.
  virtual ElementSelection existing(const Object& object, ElementSelection selection) const;
  /// A selection as elements of another mode; neither is the mode of objects.
  virtual ElementSelection converted(const Object& object, const ElementSelection& selection,
                                     ElementMode from, ElementMode to) const;
  /// "3 vertices", "1 solid"; "nothing selected".
  virtual std::string describe(const ElementSelection& selection, const Language& tr) const;
  /// The element of which a hit on the lines or the surface gave the dense index; of kind none where the
  /// object does not have it (any more).
  virtual Element element_at(const Object& object, Element::Kind kind, Index index) const;
  /// Place of a vertex or solid, middle of an edge or face, in the object's own space.
  virtual std::optional<Vector3> place(const Object& object, const Element& element) const;

  /// The lines of an object; what did not change since `before` was drawn as `drawn` is shared with it.
  /// `before` may be null.
  virtual ObjectLines lines(const Document& document, const Object& object, const Object* before,
                            const ObjectLines& drawn) const;
  /// The selected elements by their places in the lines, for drawing.
  virtual Highlights highlights(const Object& object, const ElementSelection& selection,
                                const DisplayPolyhedron& lines) const;
  /// The element that an error names, likewise.
  virtual Highlights failed(const Object& object, const Element& element,
                            const DisplayPolyhedron& lines) const;
  /// Changes how an object is shown where its kind differs from the others.
  virtual void adjust(const Object& object, const ViewSettings& view, SceneObject& shown) const;
};

/// The kind of an object. O(1).
const ObjectKind& object_kind(const Object& object);

// Each in a file of its own. They have no state.
const ObjectKind& polyhedron_kind();
const ObjectKind& patches_kind();
const ObjectKind& bezier_kind();
const ObjectKind& mesh_kind();
const ObjectKind& solids_kind();
const ObjectKind& skin_kind();
const ObjectKind& outline_kind();

/// Place of an element in the world: that of a vertex or solid, the middle of an edge or face, the box centre
/// of an object.
std::optional<Vector3> place_of(const Document& document, const ElementRef& ref);

}  // namespace hariko
