#include "ui/base/file_formats.hpp"

#include <array>
#include <utility>

#include "ui/base/language.hpp"

namespace hariko {

const char* format_name(std::string_view ending) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 23> names{{
      {".hariko", translatable("Hariko document")},
      {".obj", "Wavefront OBJ"},
      {".off", "OFF"},
      {".ply", "PLY"},
      {".stl", "STL"},
      {".glb", translatable("glTF, one file")},
      {".gltf", "glTF"},
      {".3mf", "3MF"},
      {".bpt", translatable("Bezier patches")},
      {".json", "JSON"},
      {".step", "STEP"},
      {".stp", "STEP"},
      {".iges", "IGES"},
      {".igs", "IGES"},
      {".png", translatable("PNG picture")},
      {".jpg", translatable("JPEG picture")},
      {".jpeg", translatable("JPEG picture")},
      {".webp", translatable("WebP picture")},
      {".svg", translatable("SVG line drawing")},
      {".pdf", "PDF"},
      {".dxf", "DXF"},
      {".jsonl", translatable("Replay")},
      {"", ""},
  }};
  for (const auto& [known, name] : names)
    if (known == ending) return name;
  return "";
}

}  // namespace hariko
