// Saved views in files. Since version 8.

#include <algorithm>

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"
#include "core/document/words.hpp"

namespace hariko::detail {

template <class Archive>
void describe(Archive& archive, Described<Archive, SavedView>& view) {
  archive.line();
  archive.required("name", view.name);
  archive.required("target", view.target);
  archive.required("orientation", view.orientation);
  archive.required("distance", view.distance);
  archive.changed("projection", view.projection, Projection::perspective);
  archive.required("focal_length", view.focal_length);
  archive.check([&] { return check_view(view); });
}

void read_value(JsonReader& reader, const JsonCursor& at, SavedViews& views) {
  reader.array_size(at, 0, Document::max_views);
  reader.for_each(at, [&](const JsonCursor& entry) { read_described(reader, entry, views.emplace_back()); });
  if (reader.failed()) return;
  std::vector<std::string_view> names;
  for (const SavedView& view : views) names.push_back(view.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) reader.fail(at, "two views have the name \"" + std::string(*twice) + "\"");
}
void write_value(DocumentText& text, const SavedView& view) {
  write_described(text, view);
}

}  // namespace hariko::detail
