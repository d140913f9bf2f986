#include "core/exchange/mesh_file.hpp"

#include <algorithm>
#include <deque>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/printable.hpp"
#include "core/exchange/read_obj.hpp"
#include "core/exchange/read_off.hpp"
#include "core/exchange/read_ply.hpp"
#include "core/exchange/read_stl.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {
namespace {

/// True when one of the first statements is a vertex of an OBJ file.
bool looks_like_obj(std::string_view bytes) {
  TextScanner scanner(bytes.substr(0, 65536), {.comments = true, .continuation = true});
  while (scanner.find_content()) {
    double ignored = 0;
    if (scanner.token() == "v" && !scanner.read_real("coordinate", ignored)) return true;
    scanner.next_line();
  }
  return false;
}

Message in_file(const std::filesystem::path& path, Message message) {
  message.text = "\"" + printable(path.native()) + "\": " + message.text;
  return message;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().native();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

template <class Mesh>
Result<std::string> bytes_of(const std::string& extension, std::span<const Mesh> meshes,
                             double metres_per_unit) {
  if (extension == ".obj") return write_obj(meshes);
  if (extension == ".off") return write_off(meshes);
  if (extension == ".ply") return write_ply(meshes, PlyEncoding::binary);
  if (extension == ".stl") return write_stl(meshes);
  if (extension == ".3mf") return write_3mf(meshes, metres_per_unit);
  return write_gltf(meshes, metres_per_unit, extension == ".glb" ? GltfForm::binary : GltfForm::text);
}

template <class Mesh>
Result<Done> write_meshes(const std::filesystem::path& path, std::span<const Mesh> meshes,
                          const WriteOptions& options) {
  const auto choices = written_format(path);
  if (!choices)
    return in_file(
        path, make_error(e_format_unknown, "The extension stands for no mesh format that can be written.",
                         "Use " + std::string(written_mesh_endings) + "."));
  const double metres_per_file_unit = choices->unit
                                          ? options.metres_per_file_unit.value_or(options.metres_per_unit)
                                          : options.metres_per_unit;
  const FileSpace space{// 1 exactly where both units are the same
                        options.factor * (options.metres_per_unit / metres_per_file_unit),
                        choices->up ? options.up : UpAxis::z};
  std::vector<Mesh> named(meshes.begin(), meshes.end());
  std::deque<std::remove_const_t<std::remove_pointer_t<decltype(Mesh::mesh)>>> moved;
  if (!space.is_same())
    for (Mesh& mesh : named) mesh.mesh = &moved.emplace_back(in_space(space, *mesh.mesh));
  const auto bytes = bytes_of(lower_extension(path), std::span<const Mesh>(named), metres_per_file_unit);
  if (!bytes) return in_file(path, bytes.error());
  if (options.cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  return write_file_atomic(path, *bytes);
}

}  // namespace

std::optional<FormatChoices> written_format(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".glb" || extension == ".gltf") return FormatChoices{false, false};
  if (extension == ".3mf") return FormatChoices{true, false};
  if (format_of_extension(path)) return FormatChoices{};
  return {};
}

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  return {};
}

std::optional<MeshFormat> format_of_content(std::string_view bytes) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return MeshFormat::ply;
  if (looks_like_stl(bytes)) return MeshFormat::stl;
  if (looks_like_off(bytes)) return MeshFormat::off;
  if (looks_like_obj(bytes)) return MeshFormat::obj;
  return {};
}

Result<ImportedMesh> read_mesh(std::string_view bytes, MeshFormat format, const ReadLimits& limits) {
  switch (format) {
    case MeshFormat::obj:
      return read_obj(bytes, limits);
    case MeshFormat::off:
      return read_off(bytes, limits);
    case MeshFormat::ply:
      return read_ply(bytes, limits);
    case MeshFormat::stl:
      return read_stl(bytes, limits);
  }
  HARIKO_ASSERT(false, "unknown mesh format");
  return make_error(e_format_unknown, {});
}

Result<ImportedMesh> read_mesh_file(const std::filesystem::path& path, const ReadLimits& limits,
                                    std::uint64_t size_limit) {
  const Result<std::string> bytes = read_file(path, size_limit);
  if (!bytes) return bytes.error();
  std::optional<MeshFormat> format = format_of_extension(path);
  if (!format) format = format_of_content(*bytes);
  if (!format)
    return in_file(path, make_error(e_format_unknown, "This is not a mesh file that can be read.",
                                    "Export the model as OBJ, OFF, PLY or STL."));
  try {
    Result<ImportedMesh> result = read_mesh(*bytes, *format, limits);
    if (!result) return in_file(path, result.error());
    ImportedMesh mesh = std::move(result).value();
    for (Message& warning : mesh.warnings) warning = in_file(path, std::move(warning));
    if (mesh.name.empty()) mesh.name = printable(path.stem().native(), 200);
    return mesh;
  } catch (const std::bad_alloc&) {
    return in_file(path, make_error(e_limit, "There is not enough memory for this mesh.",
                                    "Reduce the model before importing it."));
  }
}

Result<Done> write_mesh_file(const std::filesystem::path& path, std::span<const NamedTriangles> meshes,
                             const WriteOptions& options) {
  return write_meshes(path, meshes, options);
}

Result<Done> write_mesh_file(const std::filesystem::path& path, std::span<const NamedPolygons> meshes,
                             const WriteOptions& options) {
  return write_meshes(path, meshes, options);
}

}  // namespace hariko
