#pragma once

// From a selection of one kind of elements to another kind: what changing the selection mode does.

#include "core/modeling/element_set.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// `inside`: an element is taken when all its corners (or all its sides) are selected; what is selected in
/// whole stays selected in whole. `touching`: one selected corner or side is enough.
enum class Reach { inside, touching };

// All give elements of one kind only, and take the given elements of that kind over. Ids that the polyhedron
// does not have are left out. O(corners log set).

/// The given vertices, the ends of the edges, and the corners of the faces.
ElementSet to_vertices(const Polyhedron& polyhedron, const ElementSet& set);
/// The given edges, the sides of the faces, and the edges whose ends are (one of which is) selected.
ElementSet to_edges(const Polyhedron& polyhedron, const ElementSet& set, Reach reach = Reach::inside);
/// The given faces, and those whose corners or sides are (one of which is) selected.
ElementSet to_faces(const Polyhedron& polyhedron, const ElementSet& set, Reach reach = Reach::inside);

}  // namespace hariko
