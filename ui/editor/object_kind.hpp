#pragma once

// ObjectKind: how the interface selects, names, draws and finds the elements of an object, by the kind of its
// source. Whatever treats all objects alike asks the kind instead of looking at the source; a new kind
// answers here.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "render/scene.hpp"
#include "ui/editor/selection.hpp"

namespace hariko {

struct ViewSettings;

/// Lines of an object, drawn and picked over its surface.
struct ObjectLines {
  std::shared_ptr<const DisplayPolyhedron> polyhedron;  ///< null: nothing
  std::optional<Polyhedron> attached;  ///< polyhedron shown where vertices are attached to other objects
};

/// Display of an object's elements, by which they are picked.
enum class ElementsShown {
  none,    ///< it has none that can be selected
  lines,   ///< points, edges and faces of its lines
  bodies,  ///< bodies inside of its surface, which does not hide them
  layer    ///< points and curves that a layer draws over the picture; the scene does not hold them
};

/// Whether an object can have another size along one axis alone.
enum class Stretching {
  none,     ///< no: it is scaled as a whole
  affine,   ///< its surface is stretched as what it is made from
  indirect  ///< its surface follows in a way of its own
};

/// One of the bodies of an object, for picking: its element, and its lines and faces.
struct ObjectBody {
  Element element;
  std::shared_ptr<const DisplayPolyhedron> polyhedron;
};

class ObjectKind {
 public:
  virtual ~ObjectKind() = default;

  /// All elements of a mode, as "select all" takes them; none where the kind has none.
  virtual ElementSelection all(const Object& object, ElementMode mode) const;
  /// Whether there are elements to select in a mode, which is not that of objects.
  virtual bool has_elements(ElementMode /*mode*/) const { return elements_shown() != ElementsShown::none; }
  /// The elements of a selection that the object has: the vertices that have a place.
  virtual ElementSelection existing(const Object& object, ElementSelection selection) const;
  /// A selection as elements of another mode; neither is the mode of objects.
  virtual ElementSelection converted(const Object& object, const ElementSelection& selection,
                                     ElementMode from, ElementMode to) const;
  /// "3 vertices", "1 solid"; "nothing selected".
  virtual std::string describe(const ElementSelection& selection, const Language& tr) const;
  /// The name of one element as a title: "Vertex 12", "Solid 3".
  virtual std::string title(const Element& element, const Language& tr) const;
  /// The elements that continue one of them: the loop of an edge, with `ring` its ring, all that hangs
  /// together with a vertex or face. Empty where the kind knows none.
  virtual ElementSelection continued(const Object& object, const Element& element, bool ring) const;
  /// The selected elements, and all that hang together with them.
  virtual ElementSelection linked(const Object& object, const ElementSelection& selection) const;
  /// Reason why each of its elements stands for itself, in English; null where `linked` finds others.
  virtual const char* why_not_linked() const { return nullptr; }
  /// The element of which a hit on the lines or the surface gave the dense index; of kind none where the
  /// object does not have it (any more).
  virtual Element element_at(const Object& object, Element::Kind kind, Index index) const;
  /// Place of a vertex or solid, middle of an edge or face, in the object's own space.
  virtual std::optional<Vector3> place(const Object& object, const Element& element) const;
  /// Points, in the object's own space, whose box holds the selected elements.
  virtual std::vector<Vector3> extent(const Object& object, const ElementSelection& selection) const;

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
  virtual ElementsShown elements_shown() const { return ElementsShown::none; }
  /// Bodies that are picked one by one; none but for `ElementsShown::bodies`.
  virtual std::vector<ObjectBody> bodies(const Object& object) const;
  /// Whether its surface has a curve over each edge of its cage.
  virtual bool curves_over_edges() const { return false; }
  /// Changes how an object is shown where its kind differs from the others.
  virtual void adjust(const Object& object, const ViewSettings& view, SceneObject& shown) const;
  /// The same for the picture of a file, which shows the network where nothing else is said: networks that
  /// nobody drew are dense and would hide the rest. `lines`, in world coordinates, takes what no scene holds.
  virtual void adjust_in_file(const Object& object, SceneObject& shown,
                              std::vector<OverlayLine>& lines) const;
  /// Lines, in world coordinates, of settings of an object that have a place, while it is active.
  virtual std::vector<OverlayLine> guides(const Object& object) const;

  /// Icon in lists of objects (icons.hpp).
  virtual const char* list_icon() const;
  /// Size of what the object is made from, as the status line has it: "8 vertices  12 edges  6 faces".
  virtual std::string size_text(const Object& object, const Language& tr) const;
  virtual Stretching stretching() const { return Stretching::none; }
  /// Whether it is something to draw over, which has no surface and does not follow a press before it is
  /// chosen.
  virtual bool is_backdrop() const { return false; }
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
const ObjectKind& picture_kind();

/// Place of an element in the world: that of a vertex or solid, the middle of an edge or face, the box centre
/// of an object.
std::optional<Vector3> place_of(const Document& document, const ElementRef& ref);

}  // namespace hariko
