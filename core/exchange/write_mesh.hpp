#pragma once

// Meshes as the bytes of OBJ, PLY and STL files.

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// A mesh and what to call it; borrows the mesh. Positions must be finite and indices in range.
struct NamedTriangles {
  std::string name;
  const TriangleMesh* mesh = nullptr;
};
struct NamedPolygons {
  std::string name;
  const PolygonMesh* mesh = nullptr;
};

/// OBJ with one `o` for each mesh. Positions are absolute (origin added) and exact: the shortest text that
/// reads back as the same double. Normals, where there are any, have the precision of a float. O(size).
std::string write_obj(std::span<const NamedTriangles> meshes);
std::string write_obj(std::span<const NamedPolygons> meshes);

enum class PlyEncoding { ascii, binary };  ///< binary is little-endian

/// PLY with all meshes as one; names are kept as comments. Positions are absolute doubles; normals are
/// floats, present when every mesh has them, and a position with several normals becomes several vertices.
/// O(size).
std::string write_ply(std::span<const NamedTriangles> meshes, PlyEncoding encoding);
std::string write_ply(std::span<const NamedPolygons> meshes, PlyEncoding encoding);

/// Binary STL with all meshes as one. Equal positions stay equal when rounded to float, so closed meshes stay
/// closed; polygons are triangulated. Fails with E_LIMIT above 2^32 - 1 triangles or beyond the range of
/// floats. O(size).
Result<std::string> write_stl(std::span<const NamedTriangles> meshes);
Result<std::string> write_stl(std::span<const NamedPolygons> meshes);

}  // namespace hariko
