// Groups in files.

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"

namespace hariko::detail {

/// Rule for the names of groups.
struct GroupName {};
static void read_value(JsonReader& reader, const JsonCursor& at, std::string& name, const GroupName&) {
  name = reader.string(at);
  if (const auto checked = check_name(name); !checked && !reader.failed()) reader.fail(at, checked.error());
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Group>& group) {
  archive.line();
  archive.required("id", group.id, Whole{0, Group::max_id});
  archive.required("name", group.name, GroupName{});
  archive.changed("parent", group.parent, GroupId{}, Whole{0, Group::max_id});
  archive.changed("visible", group.visible, true);
  archive.changed("locked", group.locked, false);
  archive.member("colour", group.colour);
}

void read_value(JsonReader& reader, const JsonCursor& at, Groups& groups) {
  reader.array_size(at, 0, Document::max_objects);
  reader.for_each(at, [&](const JsonCursor& entry) { read_described(reader, entry, groups.emplace_back()); });
  if (reader.failed()) return;
  if (const auto fault = group_fault(groups)) reader.fail(at, *fault);
}
void write_value(DocumentText& text, const Group& group) {
  write_described(text, group);
}

}  // namespace hariko::detail
