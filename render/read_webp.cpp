#include "render/read_photo.hpp"

#ifdef HARIKO_WEBP
#include <webp/decode.h>
#endif

namespace hariko {

bool looks_like_webp(std::string_view file) {
  constexpr std::size_t kind_at = 8;
  return file.starts_with("RIFF") && file.size() >= kind_at && file.substr(kind_at).starts_with("WEBP");
}

#ifdef HARIKO_WEBP

namespace {

constexpr std::size_t first_chunk = 12, chunk_head = 8;

std::uint32_t webp_number(std::string_view file, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::uint32_t(static_cast<unsigned char>(file[at + i])) << (8 * i);
  return value;
}

bool is_animation(std::string_view file) {
  constexpr std::size_t flags_at = first_chunk + chunk_head;
  constexpr unsigned animated = 0x02;
  return file.size() > flags_at && file.substr(first_chunk).starts_with("VP8X") &&
         (static_cast<unsigned char>(file[flags_at]) & animated) != 0;
}

/// The camera's notes, from the header of TIFF on: those of the first chunk "EXIF". Some programs put the
/// mark of JPEG's notes before them.
std::string_view webp_notes(std::string_view file) {
  constexpr std::string_view mark("Exif\0\0", 6);
  for (std::size_t at = first_chunk; at + chunk_head <= file.size();) {
    const std::size_t size = webp_number(file, at + 4);
    std::string_view body = file.substr(at + chunk_head).substr(0, size);
    if (file.substr(at).starts_with("EXIF")) {
      if (body.starts_with(mark)) body.remove_prefix(mark.size());
      return body;
    }
    at += chunk_head + size + size % 2;  // chunks begin at even places
  }
  return {};
}

Message damaged_webp() {
  return make_error(e_image_read, "The picture is a damaged WebP file.",
                    "Save it again with a program for pictures.");
}

const std::uint8_t* bytes_of(std::string_view file) {
  return reinterpret_cast<const std::uint8_t*>(file.data());
}

/// Size of the rows and columns of the file.
Result<PixelSize> webp_file_size(std::string_view file) {
  if (is_animation(file))
    return make_error(e_image_read, "The picture is an animation.",
                      "Save one of its pictures as PNG or JPEG and use that.");
  PixelSize size;
  if (!WebPGetInfo(bytes_of(file), file.size(), &size.width, &size.height)) return damaged_webp();
  if (size.width < 1 || size.height < 1) return damaged_webp();
  return size;
}

}  // namespace

bool reads_webp() {
  return true;
}

Result<PixelSize> webp_size(std::string_view file) {
  const Result<PixelSize> size = webp_file_size(file);
  if (!size) return size.error();
  return upright_size(*size, exif_orientation(webp_notes(file)));
}

Result<Image> read_webp(std::string_view file, std::uint64_t most_pixels) {
  const Result<PixelSize> size = webp_file_size(file);
  if (!size) return size.error();
  if (std::uint64_t(size->width) * std::uint64_t(size->height) > most_pixels)
    return make_error(e_image_read, "The picture has too many pixels.", "Make it smaller.");
  Image image(size->width, size->height);
  if (!WebPDecodeRGBAInto(bytes_of(file), file.size(), image.rgba.data(), image.rgba.size(), 4 * image.width))
    return damaged_webp();
  return upright_image(std::move(image), exif_orientation(webp_notes(file)));
}

#else

namespace {

Message without_webp() {
  return make_error(e_picture_webp, "This Hariko was built without libwebp, which reads WebP pictures.",
                    "Save the picture as PNG or JPEG and use that.");
}

}  // namespace

bool reads_webp() {
  return false;
}

Result<PixelSize> webp_size(std::string_view) {
  return without_webp();
}

Result<Image> read_webp(std::string_view, std::uint64_t) {
  return without_webp();
}

#endif

}  // namespace hariko
