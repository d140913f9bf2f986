#pragma once

// Edges whose faces meet at an angle: what is sharp in a mesh from elsewhere.

#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// Inner edges whose faces' normals differ by more than an angle, 0 .. 180 degrees, ascending; a hundredth of
/// a degree is no difference. Faces without an area have no angle. O(edges).
std::vector<EdgeId> folded_edges(const Polyhedron& polyhedron, double degrees);

/// The document with creases at the folded edges of all its polyhedra, beside those that are there.
Result<Document> with_creases(const Document& document, double degrees);

/// The document with reference facets in the place of its polyhedra.
Result<Document> as_reference(const Document& document);

}  // namespace hariko
