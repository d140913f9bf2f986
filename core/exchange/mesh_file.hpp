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

/// Writes meshes in the format of the extension: OBJ, PLY (binary) or STL (binary), atomically. Errors:
/// E_FORMAT_UNKNOWN, E_FILE_WRITE, E_CANCELLED (nothing is written then), and those of `write_stl`.
Result<Done> write_mesh_file(const std::filesystem::path& path, std::span<const NamedTriangles> meshes,
                             const CancelToken& cancel = {});
Result<Done> write_mesh_file(const std::filesystem::path& path, std::span<const NamedPolygons> meshes,
                             const CancelToken& cancel = {});

}  // namespace hariko
