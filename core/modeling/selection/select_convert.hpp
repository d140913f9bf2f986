#pragma once

// Conversion of a selection from one kind of elements to another, as in a change of the selection mode.

#include "core/modeling/selection/element_set.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// `inside`: an element is selected when all its corners (or all its sides) are. `touching`: one selected
/// corner or side is enough.
enum class Reach { inside, touching };

// All functions return elements of one kind only, and include the given elements of that kind. Ids that the
// polyhedron does not have are ignored. O(corners log set).

/// Returns the given vertices, the ends of the edges, and the corners of the faces.
ElementSet to_vertices(const Polyhedron& polyhedron, const ElementSet& set);
/// Returns the given edges, the sides of the faces, and the edges with both ends (`touching`: one end)
/// selected.
ElementSet to_edges(const Polyhedron& polyhedron, const ElementSet& set, Reach reach = Reach::inside);
/// Returns the given faces, and those with all (`touching`: any) of their corners or sides selected.
ElementSet to_faces(const Polyhedron& polyhedron, const ElementSet& set, Reach reach = Reach::inside);

}  // namespace hariko
