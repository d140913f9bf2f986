#pragma once

// Mesh files of all supported formats: recognition, reading and writing.

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "core/exchange/coordinate_system.hpp"
#include "core/exchange/file_rounding.hpp"
#include "core/exchange/gltf/read_gltf.hpp"
#include "core/exchange/imported_scene.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {

/// Supported mesh formats.
enum class MeshFormat { obj, off, ply, stl, gltf, three_mf };

/// Format of a file name's extension in any case; nothing for others.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path);
/// Format recognised by the first bytes, of the text form of glTF by a member; nothing where none matches.
/// O(size).
std::optional<MeshFormat> format_of_content(std::string_view bytes);

/// Reads the objects of a file; OFF, PLY and STL have one. Text may be UTF-8 or UTF-16. `beside` supplies
/// buffers of glTF that are separate files. Errors: those of the reader.
Result<ImportedScene> read_parts(std::string_view bytes, MeshFormat format, const ReadLimits& limits = {},
                                 const SidecarReader& beside = {});
/// Same as `read_parts`, with all objects joined to one mesh.
Result<ImportedMesh> read_mesh(std::string_view bytes, MeshFormat format, const ReadLimits& limits = {});

/// Reads a mesh file. The format follows from its extension, or from the content where the extension is
/// unknown. Nameless objects get the file's name, numbered where there are several. Error texts begin with
/// the file: errors of `read_file` and of the readers, and E_FORMAT_UNKNOWN. All files that are read have
/// together at most `size_limit` bytes.
Result<ImportedScene> read_scene_file(const std::filesystem::path& path, const ReadLimits& limits = {},
                                      std::uint64_t size_limit = default_file_size_limit);
/// Same as `read_scene_file`, with all objects joined to one mesh, in millimetres where the file gives its
/// unit.
Result<ImportedMesh> read_mesh_file(const std::filesystem::path& path, const ReadLimits& limits = {},
                                    std::uint64_t size_limit = default_file_size_limit);

/// Unit, orientation and encoding of a file to be written.
struct WriteOptions {
  CancelToken cancel = {};
  double metres_per_unit = 0.001;                   ///< unit of the meshes
  std::optional<double> metres_per_file_unit = {};  ///< unit of the file; nothing: the meshes'
  double factor = 1;                                ///< scale of all lengths; above 0
  UpAxis up = UpAxis::z;
  MeshEncoding encoding = MeshEncoding::binary;  ///< used where the format has both
  bool to_zero = false;                          ///< moves the centre of the box of all meshes to the origin
};

/// Options that a format leaves open.
struct FormatChoices {
  bool unit = true;       ///< false: glTF is in metres
  bool up = true;         ///< false: glTF has y up, 3MF z
  bool encoding = false;  ///< PLY and STL are binary or text
};

/// Options of a format that `write_mesh_file` writes, by the ending in any case; nothing for other endings.
std::optional<FormatChoices> written_format(const std::filesystem::path& path);
/// Endings of written formats as they appear in sentences.
inline constexpr std::string_view written_mesh_endings = ".obj, .off, .ply, .stl, .3mf, .glb or .gltf";

/// Precision of coordinates in a file of this name, for meshes in their own unit; exact for endings that
/// `written_format` does not know.
FileNumbers file_numbers(const std::filesystem::path& path, const WriteOptions& options);

/// Report on meshes that were written, or would be.
struct WrittenMeshes {
  std::vector<FileRounding> rounding;  ///< by mesh, in the meshes' unit
  Vector3 moved = Vector3::Zero();     ///< point of the file's space that `to_zero` moved to the origin
  std::vector<Message> warnings;       ///< W_FILE_DIGITS
};

/// Checks of `write_mesh_file` without writing. Errors: E_FORMAT_UNKNOWN, E_FILE_DIGITS.
Result<WrittenMeshes> check_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedTriangles> meshes, const WriteOptions& options);

/// Writes meshes in the format of the extension: OBJ, OFF, PLY, STL, 3MF or glTF (.glb, .gltf), atomically.
/// Formats that fix the unit, the up axis or the encoding ignore those options. Errors: E_FORMAT_UNKNOWN,
/// E_FILE_DIGITS, E_FILE_WRITE, E_CANCELLED (nothing is written then), and those of `write_stl`, `write_gltf`
/// and `write_3mf`. O(size).
Result<WrittenMeshes> write_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedTriangles> meshes,
                                      const WriteOptions& options = {});
Result<WrittenMeshes> write_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedPolygons> meshes,
                                      const WriteOptions& options = {});

}  // namespace hariko
