#pragma once

// Larger, smaller and other selections: grow, shrink, invert, linked, boundary.

#include "core/modeling/element_set.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

// Every kind of element grows, shrinks, ... for itself: selected faces give faces. Ids that the polyhedron
// does not have are left out. O(corners log set).

enum class ElementKind { vertex, edge, face };

/// All elements of a kind.
ElementSet select_all(const Polyhedron& polyhedron, ElementKind kind);
/// The elements of a kind that are not in the set.
ElementSet invert(const Polyhedron& polyhedron, const ElementSet& set, ElementKind kind);

/// With their neighbours: vertices that share a face, edges and faces that share a vertex.
ElementSet grow(const Polyhedron& polyhedron, const ElementSet& set);
/// Without those that have a neighbour (as for `grow`) outside the set. A border of the polyhedron is no
/// outside: a whole component stays.
ElementSet shrink(const Polyhedron& polyhedron, const ElementSet& set);
/// All elements of the given kinds in the components that the set touches.
ElementSet linked(const Polyhedron& polyhedron, const ElementSet& set);

/// The edges between a selected face and one that is not, or none.
ElementSet boundary_of_faces(const Polyhedron& polyhedron, const ElementSet& set);

}  // namespace hariko
