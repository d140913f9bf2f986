#pragma once

// Mesh files of any supported format: which format it is, reading one, writing one.

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "core/exchange/file_rounding.hpp"
#include "core/exchange/file_space.hpp"
#include "core/exchange/imported_scene.hpp"
#include "core/exchange/read_gltf.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {

enum class MeshFormat { obj, off, ply, stl, gltf, three_mf };

/// Format that a file name's extension stands for, whatever its case.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path);
/// Format that the first bytes speak for.
std::optional<MeshFormat> format_of_content(std::string_view bytes);

/// The objects of a file; OFF, PLY and STL have one. Text may be UTF-8 or UTF-16. `beside` gives the buffers
/// of glTF that lie in files of their own. Errors: those of the reader.
Result<ImportedScene> read_parts(std::string_view bytes, MeshFormat format, const ReadLimits& limits = {},
                                 const FileBeside& beside = {});
/// The same with all objects in one mesh.
Result<ImportedMesh> read_mesh(std::string_view bytes, MeshFormat format, const ReadLimits& limits = {});

/// Reads a mesh file; its extension tells the format, and its content does where the extension is not known.
/// Names fall back to the file's, and are numbered then where there are several. Errors begin with the file:
/// those of `read_file` and of the readers, and E_FORMAT_UNKNOWN. All files that are read are together at
/// most `size_limit` bytes.
Result<ImportedScene> read_scene_file(const std::filesystem::path& path, const ReadLimits& limits = {},
                                      std::uint64_t size_limit = default_file_size_limit);
/// The same with all objects in one mesh, in millimetres where the file says its unit.
Result<ImportedMesh> read_mesh_file(const std::filesystem::path& path, const ReadLimits& limits = {},
                                    std::uint64_t size_limit = default_file_size_limit);

struct WriteOptions {
  CancelToken cancel = {};
  double metres_per_unit = 0.001;                   ///< of the meshes' numbers
  std::optional<double> metres_per_file_unit = {};  ///< of the file's; nothing: as the meshes'
  double factor = 1;                                ///< all lengths are multiplied by it; above 0
  UpAxis up = UpAxis::z;
  MeshEncoding encoding = MeshEncoding::binary;  ///< where the format has both
  bool to_zero = false;                          ///< the middle of the box of all meshes comes to lie at zero
};

/// What a format leaves to choose.
struct FormatChoices {
  bool unit = true;       ///< glTF is in metres
  bool up = true;         ///< glTF has y up, 3MF z
  bool encoding = false;  ///< PLY and STL are binary or text
};

/// Of the endings that `write_mesh_file` takes, whatever their case; nothing for others.
std::optional<FormatChoices> written_format(const std::filesystem::path& path);
/// The endings, as they stand in sentences.
inline constexpr std::string_view written_mesh_endings = ".obj, .off, .ply, .stl, .3mf, .glb or .gltf";

/// How a file of this name holds coordinates that are in the meshes' unit; exact for endings that are none of
/// `written_format`.
FileNumbers file_numbers(const std::filesystem::path& path, const WriteOptions& options);

/// Meshes as they are in a file that was written.
struct WrittenMeshes {
  std::vector<FileRounding> rounding;  ///< of each mesh, in the unit of the meshes
  Vector3 moved = Vector3::Zero();     ///< the point of the file's space that `to_zero` brought to zero
  std::vector<Message> warnings;       ///< W_FILE_DIGITS
};

/// Gives what `write_mesh_file` would, without writing. Errors: E_FORMAT_UNKNOWN, E_FILE_DIGITS.
Result<WrittenMeshes> check_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedTriangles> meshes, const WriteOptions& options);

/// Writes meshes in the format of the extension: OBJ, OFF, PLY, STL, 3MF or glTF (.glb, .gltf),
/// atomically. Formats that fix the unit, the up axis or the encoding keep to theirs whatever the options
/// say. Errors: E_FORMAT_UNKNOWN, E_FILE_DIGITS, E_FILE_WRITE, E_CANCELLED (nothing is written then), and
/// those of `write_stl`, `write_gltf` and `write_3mf`.
Result<WrittenMeshes> write_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedTriangles> meshes,
                                      const WriteOptions& options = {});
Result<WrittenMeshes> write_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedPolygons> meshes,
                                      const WriteOptions& options = {});

}  // namespace hariko
