#include "app/files/content_ending.hpp"

#include "core/exchange/mesh_file.hpp"

namespace hariko {

namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF", step_start = "ISO-10303-21";
constexpr std::size_t step_start_within = 4096;  ///< comments may stand before it
constexpr std::size_t iges_section_column = 72;  ///< the column of the letter S in the first line

std::string ending_of_mesh(MeshFormat format, bool is_text) {
  switch (format) {
    case MeshFormat::obj:
      return "obj";
    case MeshFormat::off:
      return "off";
    case MeshFormat::ply:
      return "ply";
    case MeshFormat::stl:
      return "stl";
    case MeshFormat::gltf:
      return is_text ? "gltf" : "glb";
    case MeshFormat::three_mf:
      return "3mf";
  }
  HARIKO_ASSERT(false, "unknown mesh format");
  return {};
}

}  // namespace

std::optional<std::string> ending_of_content(std::string_view bytes) {
  if (bytes.starts_with(utf8_mark)) bytes.remove_prefix(utf8_mark.size());
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  const bool json = begin != std::string_view::npos && bytes[begin] == '{';
  if (const auto mesh = format_of_content(bytes)) return ending_of_mesh(*mesh, json);
  if (json) return bytes.find("\"hariko\"") != std::string_view::npos ? "hariko" : "json";
  if (bytes.substr(0, step_start_within).find(step_start) != std::string_view::npos) return "step";
  if (bytes.size() > iges_section_column + 1 && bytes[iges_section_column] == 'S') return "iges";
  return {};
}

}  // namespace hariko
