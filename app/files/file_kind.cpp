#include "app/files/file_kind.hpp"

#include <array>
#include <string>
#include <string_view>

#include "core/base/files/file_ending.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

namespace {

constexpr const char* export_mesh = "Export it as glTF, OBJ or 3MF where it was made.";
constexpr const char* export_cad = "Export it as STEP where it was made.";

struct ForeignFormat {
  const char* what;
  const char* remedy;
  std::string_view endings;  ///< separated by spaces
};
constexpr std::array foreign_formats{
    ForeignFormat{"a USD scene", export_mesh, ".usd .usda .usdc .usdz"},
    ForeignFormat{"an FBX scene", export_mesh, ".fbx"},
    ForeignFormat{"a COLLADA scene", export_mesh, ".dae"},
    ForeignFormat{"a scene of a modeler", export_mesh,
                  ".blend .max .ma .mb .c4d .lwo .lws .hip .ztl .skp .3ds .abc .zpr"},
    ForeignFormat{"a VRML or X3D scene", export_mesh, ".wrl .vrml .x3d .x3db .x3dv"},
    ForeignFormat{"an AMF file", export_mesh, ".amf"},
    ForeignFormat{
        "a file of a CAD program", export_cad,
        ".3dm .sldprt .sldasm .ipt .iam .prt .asm .catpart .catproduct .f3d .f3z .fcstd .par .psm .jt "
        ".ifc .brep"},
    ForeignFormat{"a file of a CAD kernel", export_cad, ".x_t .x_b .xmt_txt .sat .sab"},
    ForeignFormat{"a drawing", export_cad, ".dwg .dxf"},
};

/// Format with the file's ending; null where there is none.
const ForeignFormat* found(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  if (ending.empty()) return nullptr;
  for (const ForeignFormat& format : foreign_formats)
    if ((" " + std::string(format.endings) + " ").find(" " + ending + " ") != std::string::npos)
      return &format;
  return nullptr;
}

}  // namespace

bool has_foreign_ending(const std::filesystem::path& file) {
  return found(file) != nullptr;
}

Message foreign_format(const std::filesystem::path& file) {
  const std::string name = "\"" + sanitized_utf8(file.filename().string(), 200) + "\"";
  if (const ForeignFormat* known = found(file))
    return make_error(e_format_unknown, name + " is " + known->what + ", which is not read.", known->remedy);
  return make_error(e_format_unknown, name + " is not a file that can be read.",
                    "Export the model as glTF, OBJ, 3MF or STEP where it was made.");
}

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
