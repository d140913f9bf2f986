#include "core/document/format/read_picture.hpp"

#include "core/base/text/base64.hpp"
#include "core/document/format/format_names.hpp"

namespace hariko::detail {

namespace {

/// Reads base64 text in its canonical form; other spellings would be written back changed.
std::string read_bytes(JsonReader& reader, const JsonCursor& at) {
  const std::string text = reader.string(at);
  if (reader.failed()) return {};
  Base64Bytes data = from_base64(text);
  if (data.wrong || data.bytes.empty() || to_base64(data.bytes) != text)
    reader.fail(at, "bytes in base64 were expected");
  return std::move(data.bytes);
}

PictureLook read_look(JsonReader& reader, const JsonCursor& at) {
  PictureLook look;
  reader.if_member(at, "opacity", [&](const JsonCursor& m) { look.opacity = reader.number(m); });
  reader.if_member(at, "layer",
                   [&](const JsonCursor& m) { look.layer = PictureLayer(reader.choice(m, layer_names)); });
  reader.if_member(at, "only_from",
                   [&](const JsonCursor& m) { look.only_from = PictureSide(reader.choice(m, side_names)); });
  return look;
}

}  // namespace

PictureSource read_picture(JsonReader& reader, const JsonCursor& at) {
  PictureSource picture;
  reader.member(at, "path", [&](const JsonCursor& m) { picture.path = reader.string(m); });
  reader.member(at, "pixels", [&](const JsonCursor& m) {
    if (reader.array_size(m, 2, 2) != 2) return;
    picture.columns = reader.integer(JsonCursor(m, 0), 1, PictureSource::most_pixels);
    picture.rows = reader.integer(JsonCursor(m, 1), 1, PictureSource::most_pixels);
  });
  reader.member(at, "width", [&](const JsonCursor& m) { picture.width = reader.number(m); });
  picture.look = read_look(reader, at);
  reader.if_member(at, "data", [&](const JsonCursor& m) { picture.bytes = read_bytes(reader, m); });
  if (reader.failed()) return picture;
  if (const auto checked = check_picture(picture); !checked)
    reader.fail(at, checked.error().text.substr(0, checked.error().text.size() - 1));
  return picture;
}

}  // namespace hariko::detail
