#pragma once

// Meshes as the bytes of OBJ, OFF, PLY, STL, glTF and 3MF files.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

using MeshColour = std::array<std::uint8_t, 3>;  ///< sRGB
inline constexpr MeshColour usual_mesh_colour{0xb9, 0xb4, 0xac};

/// A mesh and what to call it; borrows the mesh. Positions must be finite and indices in range. Formats
/// without colours leave them out.
struct NamedTriangles {
  std::string name;
  const TriangleMesh* mesh = nullptr;
  MeshColour colour = usual_mesh_colour;
  /// Farthest that the file's digits may move a vertex, in the unit of the mesh; nothing: 1e-4 of its size.
  std::optional<double> most_rounding = {};
  /// Largest angle that they may turn a facet by, radians; nothing: any.
  std::optional<double> most_turn = {};
};
struct NamedPolygons {
  std::string name;
  const PolygonMesh* mesh = nullptr;
  MeshColour colour = usual_mesh_colour;
  std::optional<double> most_rounding = {}, most_turn = {};
};

enum class MeshEncoding { ascii, binary };  ///< of PLY and STL; binary is little-endian

/// OBJ with one `o` for each mesh. Positions are absolute (origin added) and exact: the shortest text that
/// reads back as the same double. Normals, where there are any, have the precision of a float. O(size).
std::string write_obj(std::span<const NamedTriangles> meshes);
std::string write_obj(std::span<const NamedPolygons> meshes);

/// PLY with all meshes as one; names are kept as comments. Positions are absolute doubles; normals are
/// floats, present when every mesh has them, and a position with several normals becomes several vertices.
/// O(size).
std::string write_ply(std::span<const NamedTriangles> meshes, MeshEncoding encoding);
std::string write_ply(std::span<const NamedPolygons> meshes, MeshEncoding encoding);

/// STL: binary with all meshes as one, text with a solid for each. Equal positions stay equal when rounded to
/// float, so closed meshes stay closed; polygons are triangulated. Text has the floats that binary has, as
/// the shortest text that reads back as the same. Fails with E_LIMIT beyond the range of floats, binary also
/// above 2^32 - 1 triangles. O(size).
Result<std::string> write_stl(std::span<const NamedTriangles> meshes,
                              MeshEncoding encoding = MeshEncoding::binary);
Result<std::string> write_stl(std::span<const NamedPolygons> meshes,
                              MeshEncoding encoding = MeshEncoding::binary);

/// OFF with all meshes as one, positions as in OBJ. O(size).
std::string write_off(std::span<const NamedTriangles> meshes);
std::string write_off(std::span<const NamedPolygons> meshes);

enum class GltfForm { binary, text };  ///< .glb; .gltf with the buffer inside

/// glTF 2.0 as one file: a node, a mesh and a material for each, y up, in metres, normals where
/// there are any; polygons are triangulated. Positions are floats about the object's own origin. Fails with
/// E_LIMIT above 4 GB or beyond the range of floats. O(size).
Result<std::string> write_gltf(std::span<const NamedTriangles> meshes, double metres_per_unit,
                               GltfForm form = GltfForm::binary);
Result<std::string> write_gltf(std::span<const NamedPolygons> meshes, double metres_per_unit,
                               GltfForm form = GltfForm::binary);

/// 3MF (core specification 1.3): an object with a colour for each, z up, in the unit of that length if the
/// format has it (micron, mm, cm, inch, foot, m) and in millimetres otherwise; polygons are triangulated,
/// triangles without area are left out, and meshes with borders are marked as surfaces, which printers refuse
/// to fill. Positions are exact. The same meshes give the same bytes. O(size).
Result<std::string> write_3mf(std::span<const NamedTriangles> meshes, double metres_per_unit);
Result<std::string> write_3mf(std::span<const NamedPolygons> meshes, double metres_per_unit);

}  // namespace hariko
