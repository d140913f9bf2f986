#pragma once

// Lines that an object is made from, drawn and picked over its surface.

#include <memory>

#include "core/document/document.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

/// Facets of a reference mesh. O(n log n) in its corners.
std::shared_ptr<const DisplayPolyhedron> lines_of(const MeshSource& source);
/// The control nets of Bezier patches, each of its own points. O(points).
std::shared_ptr<const DisplayPolyhedron> lines_of(const BezierSource& source);
/// The loops of an outline, their points numbered through. O(points).
std::shared_ptr<const DisplayPolyhedron> lines_of(const Outline& outline);

/// Lines of any object: its polyhedron with attached vertices where their sides are, bodies of solids,
/// control nets, loops, facets. Null where a surface is made from nothing of the kind, which is a skin.
std::shared_ptr<const DisplayPolyhedron> lines_of(const Document& document, const Object& object);

}  // namespace hariko
