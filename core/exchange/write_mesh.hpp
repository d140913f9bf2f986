#pragma once

// Writers of OBJ, OFF, PLY, STL, glTF and 3MF files, as bytes.

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
/// Default colour of meshes.
inline constexpr MeshColour usual_mesh_colour{0xb9, 0xb4, 0xac};

/// Mesh with its name; borrows the mesh. Positions must be finite and indices in range. Formats without
/// colours ignore the colour.
struct NamedTriangles {
  std::string name;
  const TriangleMesh* mesh = nullptr;
  MeshColour colour = usual_mesh_colour;
  /// Largest displacement of a vertex by the file's rounding, in the unit of the mesh; nothing: 1e-4 of its
  /// size.
  std::optional<double> most_rounding = {};
  /// Largest rotation of a facet by the file's rounding, radians; nothing: any.
  std::optional<double> most_turn = {};
};
/// Polygon mesh with its name; otherwise as `NamedTriangles`.
struct NamedPolygons {
  std::string name;
  const PolygonMesh* mesh = nullptr;
  MeshColour colour = usual_mesh_colour;
  std::optional<double> most_rounding = {}, most_turn = {};
};

enum class MeshEncoding { ascii, binary };  ///< encodings of PLY and STL; binary is little-endian

/// OBJ with one `o` for each mesh. Positions are absolute (origin added) and exact: the shortest text that
/// reads back as the same double. Normals, where there are any, have float precision. O(size).
std::string write_obj(std::span<const NamedTriangles> meshes);
std::string write_obj(std::span<const NamedPolygons> meshes);

/// PLY with all meshes as one; names are kept as comments. Positions are absolute doubles; normals are
/// floats, present where every mesh has them, and a position with several normals becomes several vertices.
/// O(size).
std::string write_ply(std::span<const NamedTriangles> meshes, MeshEncoding encoding);
std::string write_ply(std::span<const NamedPolygons> meshes, MeshEncoding encoding);

/// STL: binary with all meshes as one, text with one solid for each. Equal positions stay equal after
/// rounding to float, so closed meshes stay closed; polygons are triangulated. Text has the same floats as
/// binary, as the shortest text that reads back as the same. Errors: E_LIMIT beyond the range of floats, and
/// in binary above 2^32 - 1 triangles. O(size).
Result<std::string> write_stl(std::span<const NamedTriangles> meshes,
                              MeshEncoding encoding = MeshEncoding::binary);
Result<std::string> write_stl(std::span<const NamedPolygons> meshes,
                              MeshEncoding encoding = MeshEncoding::binary);

/// OFF with all meshes as one, positions as in OBJ. O(size).
std::string write_off(std::span<const NamedTriangles> meshes);
std::string write_off(std::span<const NamedPolygons> meshes);

enum class GltfForm { binary, text };  ///< .glb, or .gltf with an embedded buffer

/// glTF 2.0 as one file: a node, a mesh and a material for each mesh, y up, in metres, with normals where
/// there are any; polygons are triangulated. Positions are floats relative to the object's own origin.
/// Errors: E_LIMIT above 4 GB or beyond the range of floats. O(size).
Result<std::string> write_gltf(std::span<const NamedTriangles> meshes, double metres_per_unit,
                               GltfForm form = GltfForm::binary);
Result<std::string> write_gltf(std::span<const NamedPolygons> meshes, double metres_per_unit,
                               GltfForm form = GltfForm::binary);

/// 3MF (core specification 1.3): an object with a colour for each mesh, z up, in the unit of that length
/// where the format has it (micron, mm, cm, inch, foot, m), else in millimetres; polygons are triangulated,
/// degenerate triangles are left out, and meshes with borders are marked as surfaces, which printers refuse
/// to fill. Positions are exact. The same meshes give the same bytes. O(size).
Result<std::string> write_3mf(std::span<const NamedTriangles> meshes, double metres_per_unit);
Result<std::string> write_3mf(std::span<const NamedPolygons> meshes, double metres_per_unit);

}  // namespace hariko
