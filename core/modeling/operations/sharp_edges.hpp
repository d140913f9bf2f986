#pragma once

// Detection of sharp edges in imported meshes by the angle between their faces.

#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// Returns the inner edges whose faces' normals differ by more than an angle, 0 .. 180 degrees, ascending;
/// excesses up to 0.01 degree are ignored. Faces without area have no angle. O(edges).
std::vector<EdgeId> folded_edges(const Polyhedron& polyhedron, double degrees);

/// Returns the document with creases at the folded edges of all its polyhedra, in addition to existing ones.
Result<Document> with_creases(const Document& document, double degrees);

/// Returns the document with its polyhedra replaced by reference facets.
Result<Document> as_reference(const Document& document);

}  // namespace hariko
