#include "app/window/window_icons.hpp"

#include <string>

namespace hariko {

std::vector<Image> window_icons(const std::filesystem::path& icons) {
  std::vector<Image> out;
  for (const int size : {16, 24, 32, 48, 64, 128}) {
    const std::string side = std::to_string(size);
    auto icon = read_png(icons / "hicolor" / (side + "x" + side) / "apps" / "hariko.png");
    if (icon.ok()) out.push_back(std::move(icon).value());
  }
  return out;
}

}  // namespace hariko
