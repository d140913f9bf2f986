// Reference pictures in files.

#include "core/base/text/base64.hpp"
#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"
#include "core/document/words.hpp"

namespace hariko::detail {

/// Reads base64 text in its canonical form; other spellings would be written back changed.
static void read_value(JsonReader& reader, const JsonCursor& at, Shared<std::string>& bytes) {
  const std::string text = reader.string(at);
  if (reader.failed()) return;
  Base64Bytes data = from_base64(text);
  if (data.wrong || data.bytes.empty() || to_base64(data.bytes) != text)
    reader.fail(at, "bytes in base64 were expected");
  bytes = std::move(data.bytes);
}
static void write_value(DocumentText& text, const Shared<std::string>& bytes) {
  text.raw("\"" + to_base64(*bytes) + "\"");
}

template <class Archive>
void describe(Archive& archive, Described<Archive, PictureSource>& picture) {
  archive.lines();
  archive.constant("kind", PictureSource::kind);
  archive.required("path", picture.path);
  archive.required_row("pixels", Whole{1, PictureSource::most_pixels}, picture.columns, picture.rows);
  archive.required("width", picture.width);
  archive.member("layer", picture.look.layer);
  archive.member("opacity", picture.look.opacity);
  archive.member("only_from", picture.look.only_from);
  archive.changed("data", picture.bytes, {});
  archive.kept(picture.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, PictureSource& picture) {
  read_described(reader, at, picture);
  if (reader.failed()) return;
  if (const auto checked = check_picture(picture); !checked)
    reader.fail(at, checked.error().text.substr(0, checked.error().text.size() - 1));
}
void write_value(DocumentText& text, const PictureSource& picture) {
  write_described(text, picture);
}

}  // namespace hariko::detail
