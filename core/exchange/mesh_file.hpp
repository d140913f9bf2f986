#pragma once

// Mesh files of any supported format: which format it is, reading one, writing one.

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {

enum class MeshFormat { obj, off, ply, stl };

/// Format that a file name's extension stands for, whatever its case.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path);
/// Format that the first bytes speak for.
std::optional<MeshFormat> format_of_content(std::string_view bytes);

Result<ImportedMesh> read_mesh(std::string_view bytes, MeshFormat format, const ReadLimits& limits = {});

/// Reads a mesh file; its extension tells the format, and its content does where the extension is not known.
/// The name of the mesh falls back to the file's. Errors begin with the file: those of `read_file` and of the
/// readers, and E_FORMAT_UNKNOWN.
Result<ImportedMesh> read_mesh_file(const std::filesystem::path& path, const ReadLimits& limits = {},
                                    std::uint64_t size_limit = default_file_size_limit);

struct WriteOptions {
  CancelToken cancel = {};
  double metres_per_unit = 0.001;  ///< for formats whose unit is fixed
};

/// True for the endings that `write_mesh_file` takes, whatever their case.
bool can_write_mesh(const std::filesystem::path& path);
/// The endings, as they stand in sentences: ".obj, .off, .ply, .stl or .glb".
inline constexpr std::string_view written_mesh_endings = ".obj, .off, .ply, .stl or .glb";

/// Writes meshes in the format of the extension: OBJ, OFF, PLY (binary), STL (binary) or glTF (.glb),
/// atomically. Errors: E_FORMAT_UNKNOWN, E_FILE_WRITE, E_CANCELLED (nothing is written then), and those of
/// `write_stl` and `write_gltf`.
Result<Done> write_mesh_file(const std::filesystem::path& path, std::span<const NamedTriangles> meshes,
                             const WriteOptions& options = {});
Result<Done> write_mesh_file(const std::filesystem::path& path, std::span<const NamedPolygons> meshes,
                             const WriteOptions& options = {});

}  // namespace hariko
