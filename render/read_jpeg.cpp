#include "render/read_photo.hpp"

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
  /// The camera's notes, in the first APP1 marker, from the header of TIFF on.
  std::string_view notes() const {
    constexpr std::string_view mark("Exif\0\0", 6);
    for (jpeg_saved_marker_ptr marker = info_.marker_list; marker; marker = marker->next) {
      if (marker->marker != JPEG_APP0 + 1) continue;
      const std::string_view bytes(reinterpret_cast<const char*>(marker->data), marker->data_length);
      return bytes.starts_with(mark) ? bytes.substr(mark.size()) : std::string_view();
    }
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
  return upright_size(size, exif_orientation(decoder.notes()));
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
  return upright_image(std::move(image), orientation);
}

}  // namespace hariko
