// Live copies in files. Since version 9; mirrors since version 10.

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"

namespace hariko::detail {

static constexpr Whole count_of_places{least_places, most_places};

template <class Archive>
void describe(Archive& archive, Described<Archive, RowOfCopies>& row) {
  archive.line();
  archive.constant("kind", "row");
  archive.required("count", row.count, count_of_places);
  archive.required("step", row.step);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, RingOfCopies>& ring) {
  archive.line();
  archive.constant("kind", "ring");
  archive.required("count", ring.count, count_of_places);
  archive.required("point", ring.point);
  archive.required("direction", ring.direction);
  archive.required("angle", ring.degrees);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, MirrorOfCopies>& mirror) {
  archive.line();
  archive.constant("kind", "mirror");
  archive.required("point", mirror.point);
  archive.required("normal", mirror.normal);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, ListOfCopies>& list) {
  archive.lines();
  archive.constant("kind", "list");
  archive.required_list("places", list.places, Count{1, most_places - 1});
}

template <class Kind>
static CopyArray array_of(JsonReader& reader, const JsonCursor& at) {
  Kind array;
  read_described(reader, at, array);
  return array;
}

static void read_array_of_copies(JsonReader& reader, const JsonCursor& at, CopyArray& array) {
  if (!reader.is_object(at)) return;
  std::string kind;
  reader.member(at, "kind", [&](const JsonCursor& member) { kind = reader.string(member); });
  if (reader.failed()) return;
  if (kind == "row")
    array = array_of<RowOfCopies>(reader, at);
  else if (kind == "ring")
    array = array_of<RingOfCopies>(reader, at);
  else if (kind == "list")
    array = array_of<ListOfCopies>(reader, at);
  else if (kind == "mirror")
    array = array_of<MirrorOfCopies>(reader, at);
  else
    reader.fail(at, "live copies are a \"row\", a \"ring\", a \"list\" or a \"mirror\"");
}

void read_value(JsonReader& reader, const JsonCursor& at, LiveCopies& copies) {
  // Each array has two places or more, so their number is limited by that of all places.
  reader.array_size(at, 0, most_places);
  reader.for_each(
      at, [&](const JsonCursor& entry) { read_array_of_copies(reader, entry, copies.emplace_back()); });
  if (reader.failed()) return;
  if (const auto checked = check_copies(copies); !checked) reader.fail(at, checked.error());
}
void write_value(DocumentText& text, const CopyArray& array) {
  std::visit([&](const auto& own) { write_described(text, own); }, array);
}

}  // namespace hariko::detail
