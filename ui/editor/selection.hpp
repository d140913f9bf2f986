#pragma once

// Selection: chosen elements and objects by their stable ids, so that it survives edits, undo and redo.

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/base/ids.hpp"
#include "core/document/document.hpp"
#include "core/modeling/selection/element_set.hpp"
#include "core/modeling/selection/select_region.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

class Language;

/// Elements that a click takes.
enum class ElementMode { vertex, edge, face, object };
/// For objects: vertices.
ElementKind kind_of(ElementMode mode);

/// Elements of one object.
using ElementSelection = ElementSet;

/// One element of one object, or the object itself (the element is of kind object then).
struct ElementRef {
  ObjectId object;
  Element element;
  friend bool operator==(const ElementRef&, const ElementRef&) = default;
};

class Selection {
 public:
  enum class How { replace, add, remove };

  /// The object that the panels are about; 0xffffffff when there is none.
  ObjectId active;
  /// Element that was selected last: the pivot of transformations, when that is asked for.
  std::optional<ElementRef> last;
  /// Element that the selection began with, as long as it is selected; nothing when many came at once.
  std::optional<ElementRef> first;

  const ElementSelection& of(ObjectId object) const;
  const ElementSelection& of_active() const { return of(active); }
  bool contains(const ElementRef& ref) const;
  bool no_elements() const { return elements_.empty(); }
  const std::map<ObjectId, ElementSelection>& elements() const { return elements_; }
  /// Chosen in object mode.
  const std::set<ObjectId>& objects() const { return objects_; }

  /// `replace` drops other elements when an element is chosen, and other objects when an object is.
  void select(const ElementRef& ref, How how);
  /// The same for elements of one kind of one object: those given are added to, taken from or put in place of
  /// all.
  void select(ObjectId object, const ElementSelection& elements, How how);
  void select_all(const Object& object, ElementMode mode);
  /// Replaces what is selected of an object.
  void set(ObjectId object, ElementSelection elements);
  void clear_elements() {
    elements_.clear();
    first.reset();
  }
  void clear_objects() { objects_.clear(); }
  /// Drops what the document does not have any more, hidden or locked objects and elements of these, and
  /// finds another active object when that one is gone.
  void prune(const Document& document);

  friend bool operator==(const Selection&, const Selection&) = default;

 private:
  std::map<ObjectId, ElementSelection> elements_;  ///< entries are never empty
  std::set<ObjectId> objects_;
};

/// The selection as elements of another kind: edges become their ends, faces with all corners selected ... An
/// object becomes all of its elements, elements become their object.
Selection converted(const Selection& selection, const Document& document, ElementMode from, ElementMode to);

/// Dense indices of what is selected, for drawing.
Highlights highlights_of(const ElementSelection& selection, const Polyhedron& polyhedron);
/// Ids of all vertices of the polyhedron that the selected elements touch, ascending.
std::vector<VertexId> touched_vertices(const ElementSelection& selection, const Polyhedron& polyhedron);
/// "3 vertices", "1 edge, 2 faces"; "nothing selected".
std::string describe(const ElementSelection& selection);
/// The same in a language.
std::string describe(const ElementSelection& selection, const Language& tr);

}  // namespace hariko
