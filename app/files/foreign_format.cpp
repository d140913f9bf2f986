#include "app/files/foreign_format.hpp"

#include <array>
#include <string>
#include <string_view>

#include "core/base/files/file_ending.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/imported_mesh.hpp"

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

}  // namespace hariko
