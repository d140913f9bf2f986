#include "render/read_photo.hpp"

#include <algorithm>

namespace hariko {

namespace {

bool turns_aside(int orientation) {
  return orientation >= 5;
}

}  // namespace

int exif_orientation(std::string_view notes) {
  const bool little = notes.starts_with("II");
  const auto number = [&](std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size && at + i < notes.size(); ++i)
      value |= std::uint32_t(static_cast<unsigned char>(notes[at + i])) << (8 * (little ? i : size - 1 - i));
    return value;
  };
  if (notes.size() < 8 || number(2, 2) != 42) return 1;
  const std::size_t table = number(4, 4);
  const std::size_t count = table < notes.size() ? number(table, 2) : 0;
  constexpr std::size_t entry_size = 12;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = table + 2 + entry_size * i;
    if (entry + entry_size > notes.size()) break;
    if (number(entry, 2) != 0x0112) continue;
    const std::uint32_t value = number(entry + 8, 2);
    return value >= 1 && value <= 8 ? int(value) : 1;
  }
  return 1;
}

PixelSize upright_size(PixelSize file, int orientation) {
  return turns_aside(orientation) ? PixelSize{file.height, file.width} : file;
}

Image upright_image(Image file, int orientation) {
  if (orientation == 1) return file;
  Image out = turns_aside(orientation) ? Image(file.height, file.width) : Image(file.width, file.height);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      int column = turns_aside(orientation) ? y : x, row = turns_aside(orientation) ? x : y;
      if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
        column = file.width - 1 - column;
      if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
        row = file.height - 1 - row;
      std::copy_n(file.pixel(column, row), 4, out.pixel(x, y));
    }
  return out;
}

}  // namespace hariko
