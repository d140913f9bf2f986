#pragma once

// Selection: chosen elements by their stable ids, so that it survives edits, undo and redo.

#include <map>
#include <set>
#include <vector>

#include "core/base/ids.hpp"
#include "core/document/document.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

/// Which elements a click takes.
enum class ElementMode { vertex, edge, face, object };

/// Elements of one object.
struct ElementSelection {
  std::set<VertexId> vertices;
  std::set<EdgeId> edges;
  std::set<FaceId> faces;

  bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
  std::size_t size() const { return vertices.size() + edges.size() + faces.size(); }
  friend bool operator==(const ElementSelection&, const ElementSelection&) = default;
};

/// One element of one object.
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

  const ElementSelection& of(ObjectId object) const;
  const ElementSelection& of_active() const { return of(active); }
  bool contains(const ElementRef& ref) const;
  bool no_elements() const { return elements_.empty(); }

  void select(const ElementRef& ref, How how);
  void select_all(const Object& object, ElementMode mode);
  void clear_elements() { elements_.clear(); }
  /// Drops what the document does not have any more, and finds another active object when that one is gone.
  void prune(const Document& document);

  friend bool operator==(const Selection&, const Selection&) = default;

 private:
  std::map<ObjectId, ElementSelection> elements_;  ///< entries are never empty
};

/// Dense indices of what is selected, for drawing.
Highlights highlights_of(const ElementSelection& selection, const Polyhedron& polyhedron);
/// Ids of all vertices that the selected elements touch, ascending.
std::vector<VertexId> touched_vertices(const ElementSelection& selection, const Polyhedron& polyhedron);
/// "3 vertices", "1 edge, 2 faces"; "nothing selected".
std::string describe(const ElementSelection& selection);

}  // namespace hariko
