#include "core/exchange/mesh_file.hpp"

#include <array>
#include <deque>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/files/file_ending.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/archive_3mf/read_3mf.hpp"
#include "core/exchange/gltf/gltf_container.hpp"
#include "core/exchange/obj/read_obj.hpp"
#include "core/exchange/text_encoding.hpp"
#include "core/exchange/text_scanner.hpp"
#include "core/exchange/triangles/read_off.hpp"
#include "core/exchange/triangles/read_ply.hpp"
#include "core/exchange/triangles/read_stl.hpp"

namespace hariko {
namespace {

/// Whether one of the first statements is a vertex of an OBJ file.
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
  message.text = "\"" + sanitized_utf8(path.native()) + "\": " + message.text;
  return message;
}

/// Scene of a format that has one mesh.
Result<ImportedScene> as_scene(Result<ImportedMesh> result) {
  if (!result) return result.error();
  ImportedMesh mesh = std::move(result).value();
  ImportedScene scene;
  scene.parts.push_back({std::move(mesh.mesh), std::move(mesh.name)});
  scene.warnings = std::move(mesh.warnings);
  return scene;
}

/// Name of a format in messages.
const char* mesh_format_name(MeshFormat format) {
  constexpr std::array names{"OBJ", "OFF", "PLY", "STL", "glTF", "3MF"};
  return names.at(static_cast<std::size_t>(format));
}

/// Reason why a file could not be read: where its content is clearly of another format, that.
Message why_unread(const Message& error, MeshFormat format, std::string_view bytes) {
  const auto holds = error.code == e_cancelled ? std::nullopt : format_of_content(bytes);
  if (!holds || *holds == format) return error;
  return make_error(e_format_unknown,
                    std::string("The file holds ") + mesh_format_name(*holds) + ", though it is called " +
                        mesh_format_name(format) + ".",
                    "Rename it to the ending of what it holds.");
}

template <class Mesh>
Result<std::string> bytes_of(const std::string& extension, std::span<const Mesh> meshes,
                             double metres_per_unit, MeshEncoding encoding) {
  if (extension == ".obj") return write_obj(meshes);
  if (extension == ".off") return write_off(meshes);
  if (extension == ".ply") return write_ply(meshes, encoding);
  if (extension == ".stl") return write_stl(meshes, encoding);
  if (extension == ".3mf") return write_3mf(meshes, metres_per_unit);
  return write_gltf(meshes, metres_per_unit, extension == ".glb" ? GltfForm::binary : GltfForm::text);
}

/// Space of a file, and the length of its unit.
struct FilePlan {
  FileSpace space;
  double metres_per_file_unit = 0.001;
};

FilePlan plan_of(const FormatChoices& choices, const WriteOptions& options) {
  FilePlan out;
  out.metres_per_file_unit =
      choices.unit ? options.metres_per_file_unit.value_or(options.metres_per_unit) : options.metres_per_unit;
  out.space = {// exactly 1 where both units are equal
               options.factor * (options.metres_per_unit / out.metres_per_file_unit),
               choices.up ? options.up : UpAxis::z};
  return out;
}

Eigen::AlignedBox3d box_of(std::span<const NamedTriangles> meshes) {
  Eigen::AlignedBox3d box;
  for (const NamedTriangles& named : meshes)
    for (const Vector3& position : named.mesh->positions) box.extend(named.mesh->origin + position);
  return box;
}

Eigen::AlignedBox3d box_of(std::span<const NamedPolygons> meshes) {
  Eigen::AlignedBox3d box;
  for (const NamedPolygons& named : meshes)
    for (const Vector3& position : named.mesh->positions) box.extend(position);
  return box;
}

/// Meshes in the file's space, with the effect of the format's rounding.
template <class Mesh>
struct Prepared {
  std::vector<Mesh> named;
  std::deque<std::remove_const_t<std::remove_pointer_t<decltype(Mesh::mesh)>>> moved;
  WrittenMeshes report;
  double metres_per_file_unit = 0.001;
};

template <class Mesh>
Result<Prepared<Mesh>> prepare(const std::filesystem::path& path, std::span<const Mesh> meshes,
                               const WriteOptions& options) {
  const auto choices = written_format(path);
  if (!choices)
    return in_file(
        path, make_error(e_format_unknown, "The extension stands for no mesh format that can be written.",
                         "Use " + std::string(written_mesh_endings) + "."));
  const FilePlan plan = plan_of(*choices, options);
  Prepared<Mesh> out;
  out.metres_per_file_unit = plan.metres_per_file_unit;
  out.named.assign(meshes.begin(), meshes.end());
  if (const auto box = box_of(meshes); options.to_zero && !box.isEmpty())
    out.report.moved = plan.space.placed(box.center());
  if (!plan.space.is_same() || !out.report.moved.isZero(0)) {
    for (Mesh& mesh : out.named)
      mesh.mesh = &out.moved.emplace_back(in_space(plan.space, *mesh.mesh, out.report.moved));
    if (const auto box = box_of(std::span<const Mesh>(out.named));
        !box.isEmpty() && !(box.min().allFinite() && box.max().allFinite()))
      return in_file(path, make_error(e_limit, "Coordinates would be too large for any number in a file.",
                                      "Choose a smaller scale."));
  }
  FileNumbers numbers = file_numbers(path, options);
  numbers.scale /= plan.space.factor;
  for (Mesh& mesh : out.named) {
    FileRounding rounding = rounding_of(*mesh.mesh, numbers);
    rounding.distance /= plan.space.factor;
    rounding.size /= plan.space.factor;
    const double* allowed = mesh.most_rounding ? &*mesh.most_rounding : nullptr;
    if (ruins(rounding, allowed)) return digits_error(rounding, mesh.name);
    if (mesh.most_turn && rounding.turn > *mesh.most_turn) return turn_error(rounding, mesh.name);
    if (coarse(rounding, allowed)) out.report.warnings.push_back(digits_warning(rounding, mesh.name));
    if constexpr (std::is_same_v<Mesh, NamedTriangles>)
      if (rounding.left_out > 0) mesh.mesh = &out.moved.emplace_back(without_collapsed(*mesh.mesh, numbers));
    out.report.rounding.push_back(rounding);
  }
  return out;
}

template <class Mesh>
Result<WrittenMeshes> write_meshes(const std::filesystem::path& path, std::span<const Mesh> meshes,
                                   const WriteOptions& options) {
  auto prepared = prepare(path, meshes, options);
  if (!prepared) return prepared.error();
  const auto bytes = bytes_of(lower_ending(path), std::span<const Mesh>(prepared->named),
                              prepared->metres_per_file_unit, options.encoding);
  if (!bytes) return in_file(path, bytes.error());
  if (options.cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  if (auto written = write_file_atomic(path, *bytes); !written) return written.error();
  return std::move(prepared.value().report);
}

}  // namespace

std::optional<FormatChoices> written_format(const std::filesystem::path& path) {
  const std::string extension = lower_ending(path);
  if (extension == ".glb" || extension == ".gltf") return FormatChoices{false, false, false};
  if (extension == ".3mf") return FormatChoices{true, false, false};
  if (extension == ".ply" || extension == ".stl") return FormatChoices{true, true, true};
  if (format_of_extension(path)) return FormatChoices{};
  return {};
}

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& path) {
  const std::string extension = lower_ending(path);
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  if (extension == ".glb" || extension == ".gltf") return MeshFormat::gltf;
  if (extension == ".3mf") return MeshFormat::three_mf;
  return {};
}

std::optional<MeshFormat> format_of_content(std::string_view given) {
  const std::optional<std::string> text = from_utf16(given);
  const std::string_view bytes = text ? *text : given;
  if (looks_like_glb(bytes) || looks_like_gltf_text(bytes)) return MeshFormat::gltf;
  if (looks_like_zip(bytes)) return MeshFormat::three_mf;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return MeshFormat::ply;
  if (looks_like_stl(bytes)) return MeshFormat::stl;
  if (looks_like_off(bytes)) return MeshFormat::off;
  if (looks_like_obj(bytes)) return MeshFormat::obj;
  return {};
}

Result<ImportedScene> read_parts(std::string_view bytes, MeshFormat format, const ReadLimits& limits,
                                 const SidecarReader& beside) {
  std::optional<std::string> text;
  const bool binary = format == MeshFormat::gltf || format == MeshFormat::three_mf ||
                      (format == MeshFormat::stl && looks_like_stl(bytes));
  if (!binary) text = from_utf16(bytes);
  if (text) bytes = *text;
  switch (format) {
    case MeshFormat::obj:
      return read_obj_scene(bytes, limits);
    case MeshFormat::off:
      return as_scene(read_off(bytes, limits));
    case MeshFormat::ply:
      return as_scene(read_ply(bytes, limits));
    case MeshFormat::stl:
      return read_stl_scene(bytes, limits);
    case MeshFormat::gltf:
      return read_gltf(bytes, limits, beside);
    case MeshFormat::three_mf:
      return read_3mf(bytes, limits);
  }
  HARIKO_ASSERT(false, "unknown mesh format");
  return make_error(e_format_unknown, {});
}

Result<ImportedMesh> read_mesh(std::string_view bytes, MeshFormat format, const ReadLimits& limits) {
  if (format == MeshFormat::obj) return read_obj(bytes, limits);
  auto scene = read_parts(bytes, format, limits);
  return scene ? Result<ImportedMesh>(merged(std::move(scene).value())) : scene.error();
}

Result<ImportedScene> read_scene_file(const std::filesystem::path& path, const ReadLimits& limits,
                                      std::uint64_t size_limit) {
  const Result<std::string> bytes = read_file(path, size_limit);
  if (!bytes) return bytes.error();
  std::optional<MeshFormat> format = format_of_extension(path);
  if (!format) format = format_of_content(*bytes);
  if (!format)
    return in_file(path, make_error(e_format_unknown, "This is not a mesh file that can be read.",
                                    "Export the model as OBJ, OFF, PLY, STL, glTF or 3MF."));
  std::uint64_t left = size_limit - bytes->size();
  const auto beside = [&](const std::string& name) {
    auto content = read_file(path.parent_path() / name, left);
    if (content) left -= content->size();
    return content;
  };
  try {
    Result<ImportedScene> result = read_parts(*bytes, *format, limits, beside);
    if (!result) return in_file(path, why_unread(result.error(), *format, *bytes));
    ImportedScene scene = std::move(result).value();
    for (Message& warning : scene.warnings) warning = in_file(path, std::move(warning));
    const std::string own = sanitized_utf8(path.stem().native(), 200);
    for (NamedPatches& patches : scene.patches)
      if (patches.name.empty()) patches.name = own;
    for (std::size_t k = 0; k < scene.parts.size(); ++k)
      if (scene.parts[k].name.empty())
        scene.parts[k].name = scene.parts.size() == 1 ? own : own + " " + std::to_string(k + 1);
    return scene;
  } catch (const std::bad_alloc&) {
    return in_file(path, make_error(e_limit, "There is not enough memory for this mesh.",
                                    "Reduce the model before importing it."));
  }
}

Result<ImportedMesh> read_mesh_file(const std::filesystem::path& path, const ReadLimits& limits,
                                    std::uint64_t size_limit) {
  auto scene = read_scene_file(path, limits, size_limit);
  if (!scene) return scene.error();
  if (scene->parts.empty())
    return in_file(path, make_error(e_empty, "The file has surfaces only, and no polygons.",
                                    "Open it and export its surfaces as triangles."));
  const double factor = scene->metres_per_unit.value_or(0.001) / 0.001;
  ImportedMesh mesh = merged(std::move(scene).value());
  if (factor != 1)
    for (Vector3& position : mesh.mesh.positions) position *= factor;
  return mesh;
}

FileNumbers file_numbers(const std::filesystem::path& path, const WriteOptions& options) {
  const std::string extension = lower_ending(path);
  const auto choices = written_format(path);
  if (!choices) return {};
  const FilePlan plan = plan_of(*choices, options);
  if (extension == ".stl") return {FileNumbers::Kind::floats, plan.space.factor};
  if (extension == ".glb" || extension == ".gltf")
    return {FileNumbers::Kind::local_floats, plan.space.factor * plan.metres_per_file_unit};
  return {};
}

Result<WrittenMeshes> check_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedTriangles> meshes, const WriteOptions& options) {
  auto prepared = prepare(path, meshes, options);
  if (!prepared) return prepared.error();
  return std::move(prepared.value().report);
}

Result<WrittenMeshes> write_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedTriangles> meshes, const WriteOptions& options) {
  return write_meshes(path, meshes, options);
}

Result<WrittenMeshes> write_mesh_file(const std::filesystem::path& path,
                                      std::span<const NamedPolygons> meshes, const WriteOptions& options) {
  return write_meshes(path, meshes, options);
}

}  // namespace hariko
