#include "render/read_jpeg.hpp"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <string>

// Included after cstdio, on which jpeglib.h depends.
#include <jpeglib.h>

namespace hariko {

namespace {

constexpr std::size_t most_marker_bytes = 0xffff;

/// Decoder with libjpeg's error handling by longjmp: methods that call setjmp have no objects with
/// destructors.
class JpegDecoder {
 public:
  JpegDecoder() {
    info_.err = jpeg_std_error(&errors_);
    errors_.error_exit = &JpegDecoder::leave;
    errors_.emit_message = [](j_common_ptr, int) {};
    info_.client_data = this;
  }
  ~JpegDecoder() {
    if (created_) jpeg_destroy_decompress(&info_);
  }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;

  bool read_header(std::string_view file) {
    if (setjmp(jump_) != 0) return false;
    jpeg_create_decompress(&info_);
    created_ = true;
    jpeg_save_markers(&info_, JPEG_APP0 + 1, most_marker_bytes);
    jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(file.data()), file.size());
    jpeg_read_header(&info_, TRUE);
    info_.out_color_space = printed() ? JCS_CMYK : JCS_EXT_RGBA;
    return true;
  }
  /// Reads the pixels, four bytes each, row by row.
  bool read_rows(std::uint8_t* pixels) {
    if (setjmp(jump_) != 0) return false;
    jpeg_start_decompress(&info_);
    while (info_.output_scanline < info_.output_height) {
      JSAMPROW row = pixels + std::size_t(info_.output_scanline) * info_.output_width * 4;
      jpeg_read_scanlines(&info_, &row, 1);
    }
    jpeg_finish_decompress(&info_);
    return true;
  }

  std::uint32_t columns() const { return info_.image_width; }
  std::uint32_t rows() const { return info_.image_height; }
  /// Whether the file is in CMYK, the colours of print.
  bool printed() const { return info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK; }
  /// Whether CMYK values are inverted: Photoshop writes the bare share of paper instead of ink, and marks
  /// such files.
  bool inverted() const { return info_.saw_Adobe_marker != 0; }
  /// Bytes of the first APP1 marker, which has the camera's notes.
  std::string_view notes() const {
    for (jpeg_saved_marker_ptr marker = info_.marker_list; marker; marker = marker->next)
      if (marker->marker == JPEG_APP0 + 1)
        return {reinterpret_cast<const char*>(marker->data), marker->data_length};
    return {};
  }
  std::string why() {
    std::array<char, JMSG_LENGTH_MAX> text{};
    info_.err->format_message(reinterpret_cast<j_common_ptr>(&info_), text.data());
    return text.data();
  }

 private:
  [[noreturn]] static void leave(j_common_ptr info) {
    std::longjmp(static_cast<JpegDecoder*>(info->client_data)->jump_, 1);
  }

  jpeg_decompress_struct info_{};
  jpeg_error_mgr errors_{};
  std::jmp_buf jump_{};
  bool created_ = false;
};

/// EXIF orientation, 1 .. 8: position of the file's first row and column; 1 where none is noted.
int exif_orientation(std::string_view notes) {
  constexpr std::string_view mark("Exif\0\0", 6);
  if (!notes.starts_with(mark)) return 1;
  notes.remove_prefix(mark.size());
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

bool turns_aside(int orientation) {
  return orientation >= 5;
}

Image upright(Image file, int orientation) {
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

void from_print(Image& image, bool inverted) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    std::uint8_t* p = image.rgba.data() + i;
    const auto paper = [&](std::size_t k) { return inverted ? p[k] : 255 - p[k]; };
    const int black = paper(3);
    for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(paper(k) * black / 255);
    p[3] = 255;
  }
}

Message unreadable(JpegDecoder& decoder) {
  return make_error(e_image_read, "The picture is a damaged JPEG file: " + decoder.why() + ".",
                    "Save it again with a program for pictures.");
}

}  // namespace

bool looks_like_jpeg(std::string_view file) {
  return file.starts_with("\xff\xd8\xff");
}

Result<PixelSize> jpeg_size(std::string_view file) {
  JpegDecoder decoder;
  if (!decoder.read_header(file)) return unreadable(decoder);
  const PixelSize size{int(decoder.columns()), int(decoder.rows())};
  return turns_aside(exif_orientation(decoder.notes())) ? PixelSize{size.height, size.width} : size;
}

Result<Image> read_jpeg(std::string_view file, std::uint64_t most_pixels) {
  JpegDecoder decoder;
  if (!decoder.read_header(file)) return unreadable(decoder);
  if (std::uint64_t(decoder.columns()) * decoder.rows() > most_pixels)
    return make_error(e_image_read, "The picture has too many pixels.", "Make it smaller.");
  const int orientation = exif_orientation(decoder.notes());  // discarded when the rows are read
  Image image(int(decoder.columns()), int(decoder.rows()));
  if (!decoder.read_rows(image.rgba.data())) return unreadable(decoder);
  if (decoder.printed()) from_print(image, decoder.inverted());
  return upright(std::move(image), orientation);
}

}  // namespace hariko
