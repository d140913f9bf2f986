#pragma once

// Operations on selections: grow, shrink, invert, linked, boundary.

#include "core/modeling/selection/element_set.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

// Every kind of element is treated separately: selected faces give faces. Ids that the polyhedron does not
// have are ignored. O(corners log set).

enum class ElementKind { vertex, edge, face };

/// Returns all elements of a kind.
ElementSet select_all(const Polyhedron& polyhedron, ElementKind kind);
/// Returns the elements of a kind that are not in the set.
ElementSet invert(const Polyhedron& polyhedron, const ElementSet& set, ElementKind kind);

/// Adds the neighbours: vertices that share a face, edges and faces that share a vertex.
ElementSet grow(const Polyhedron& polyhedron, const ElementSet& set);
/// Removes elements that have a neighbour (as for `grow`) outside the set. A border of the polyhedron does
/// not count as outside: a whole component stays.
ElementSet shrink(const Polyhedron& polyhedron, const ElementSet& set);
/// Returns all elements of the given kinds in the components that contain an element of the set.
ElementSet linked(const Polyhedron& polyhedron, const ElementSet& set);

/// Returns the edges between a selected face and one that is not selected, or a border.
ElementSet boundary_of_faces(const Polyhedron& polyhedron, const ElementSet& set);

}  // namespace hariko
