// Documents and their objects in files.

#include <algorithm>

#include "core/document/edits/edit_copies.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/format/archive.hpp"
#include "core/document/format/describe_origin.hpp"
#include "core/document/format/described.hpp"
#include "core/document/format/folded_origin.hpp"
#include "core/document/format/format.hpp"
#include "core/document/group_tree.hpp"
#include "core/document/words.hpp"

namespace hariko {

namespace detail {

/// Reads a source of a known kind.
template <class Kind>
static std::optional<Source> source_of(JsonReader& reader, const JsonCursor& at) {
  Kind source;
  read_value(reader, at, source);
  return source;
}

/// Sources of other kinds stay as their text is.
static void read_value(JsonReader& reader, const JsonCursor& at, std::optional<Source>& source) {
  if (!reader.is_object(at)) return;
  std::string kind;
  reader.member(at, "kind", [&](const JsonCursor& member) { kind = reader.string(member); });
  if (reader.failed()) return;
  if (kind == PolyhedronSource::kind)
    source = read_polyhedron(reader, at);
  else if (kind == PatchSource::kind)
    source = read_patches(reader, at);
  else if (kind == MeshSource::kind)
    source = source_of<MeshSource>(reader, at);
  else if (kind == BezierSource::kind)
    source = source_of<BezierSource>(reader, at);
  else if (kind == SolidsSource::kind)
    source = source_of<SolidsSource>(reader, at);
  else if (kind == SkinSource::kind)
    source = source_of<SkinSource>(reader, at);
  else if (kind == OutlineSource::kind)
    source = source_of<OutlineSource>(reader, at);
  else if (kind == PictureSource::kind)
    source = source_of<PictureSource>(reader, at);
  else
    source = UnknownSource{kind, reader.json_of(*at.member())};
}
static void write_value(DocumentText& text, const UnknownSource& source) {
  text.raw(*source.json);
}
static void write_value(DocumentText& text, const Source& source) {
  std::visit([&](const auto& one) { write_value(text, one); }, source);
}

/// Moves the origin of a source whose place carries it into that place.
static void fold_origin(JsonReader& reader, const JsonCursor& object, const Source& source,
                        Similarity& transform) {
  if (!origin_is_folded(source) || reader.version() < origin_since_version) return;
  reader.if_member(object, "source", [&](const JsonCursor& at) {
    reader.if_member(at, "origin", [&](const JsonCursor& member) {
      transform = with_origin(transform, reader.vector(member));
      if (!reader.failed() && !transform.translation.allFinite())
        reader.fail(member, "the place of the object is not finite");
    });
  });
}

/// Rule for the names of objects.
struct ObjectName {};
static void read_value(JsonReader& reader, const JsonCursor& at, std::string& name, const ObjectName&) {
  name = reader.string(at);
  if (const auto checked = check_name(name); !checked && !reader.failed()) reader.fail(at, checked.error());
}

/// An object in a file, where it may lack its source.
struct FileObject {
  ObjectId id;
  std::string name;
  bool visible = true, locked = false;
  Similarity transform;
  DisplaySettings display;
  std::optional<Source> source;
  KeptMembers kept;
  GroupId group = {};
  LiveCopies copies = {};
};

/// The own switches of an object: what its groups do follows from them.
static bool& visible_of(FileObject& object) {
  return object.visible;
}
static bool visible_of(const Object& object) {
  return object.visible_itself();
}
static bool& locked_of(FileObject& object) {
  return object.locked;
}
static bool locked_of(const Object& object) {
  return object.locked_itself();
}

static LiveCopies& copies_of(FileObject& object) {
  return object.copies;
}
static const LiveCopies& copies_of(const Object& object) {
  return *object.copies;
}

template <class Archive, class AnyObject>
void describe_object(Archive& archive, AnyObject& object) {
  archive.lines();
  archive.required("id", object.id);
  archive.required("name", object.name, ObjectName{});
  archive.member("visible", visible_of(object));
  archive.member("locked", locked_of(object));
  archive.changed("group", object.group, GroupId{}, Whole{0, Group::max_id});
  archive.member("transform", object.transform);
  archive.list("copies", copies_of(object));
  archive.member("display", object.display);
  archive.required("source", object.source);
  archive.kept(object.kept);
  archive.close();
}

static void read_value(JsonReader& reader, const JsonCursor& at, std::shared_ptr<const Object>& object) {
  FileObject file;
  ReadArchive archive(reader, at);
  describe_object(archive, file);
  if (reader.failed()) return;
  fold_origin(reader, at, *file.source, file.transform);
  if (reader.failed()) return;
  Object made{file.id,      std::move(file.name),    file.visible,         file.locked, file.transform,
              file.display, *std::move(file.source), std::move(file.kept), file.group};
  made.copies = std::move(file.copies);
  if (!made.copies->empty() && !can_have_copies(made))
    return reader.fail(at, "this kind of object has no live copies");
  object = std::make_shared<const Object>(std::move(made));
}
static void write_value(DocumentText& text, const std::shared_ptr<const Object>& object) {
  WriteArchive archive(text);
  describe_object(archive, *object);
}

static void read_value(JsonReader& reader, const JsonCursor& at, std::shared_ptr<const PaperModel>& paper) {
  PaperModel own;
  read_value(reader, at, own);
  paper = std::make_shared<const PaperModel>(std::move(own));
}
static void write_value(DocumentText& text, const std::shared_ptr<const PaperModel>& paper) {
  write_value(text, *paper);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Document>& document) {
  archive.lines();
  archive.constant("format", "hariko");
  archive.constant("version", std::uint32_t{format_version});
  archive.member("unit", document.unit);
  archive.member("next_object_id", document.next_object_id, Whole{0, no_index});
  archive.required_list("objects", document.objects, Count{0, Document::max_objects});
  archive.shared(document.groups, [&](auto& groups) { archive.list("groups", groups); });
  archive.shared(document.dimensions, [&](auto& dimensions) { archive.list("dimensions", dimensions); });
  archive.shared(document.saved_views, [&](auto& views) { archive.list("views", views); });
  archive.changed("making", document.making, {});
  archive.changed("paper", document.paper, nullptr);
  archive.kept(document.kept);
}

/// Checks format and version (E_FORMAT, E_VERSION_NEWER) before anything else, because the rest of a newer
/// file may mean anything.
static void check_head(JsonReader& reader, const JsonCursor& root) {
  bool named = false;
  reader.if_member(root, "format", [&](const JsonCursor& at) {
    named = at.value().string() && *at.value().string() == "hariko";
  });
  if (!named)
    return reader.fail(make_error(e_format, "The file is not a Hariko document.",
                                  "Choose a file that Hariko has saved, or use Import for other formats."));
  reader.member(root, "version", [&](const JsonCursor& at) {
    const std::uint32_t version = reader.integer(at, 1, no_index - 1);
    if (version > static_cast<std::uint32_t>(format_version))
      reader.fail(make_error(e_version_newer,
                             "The file was saved by a newer Hariko: it has format version " +
                                 std::to_string(version) + ", this program reads versions up to " +
                                 std::to_string(format_version) + ".",
                             "Open it with a newer Hariko."));
    else
      reader.set_version(static_cast<int>(version));
  });
}

/// Checks that ids are unique and that new objects cannot get one of them again.
static void check_object_ids(JsonReader& reader, const JsonCursor& root, Document& document) {
  std::vector<ObjectId> ids;
  for (const auto& object : document.objects) ids.push_back(object->id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) reader.fail(root, "two objects have the id " + std::to_string(twice->value));
  const std::uint32_t lowest = ids.empty() ? 1 : ids.back().value + 1;
  if (!reader.find(root, "next_object_id")) document.next_object_id.value = lowest;
  if (document.next_object_id.value < lowest)
    reader.fail(root, "next_object_id must be above the ids of all objects");
}

/// Checks that the groups of objects exist and that every group has an object.
static void check_groups(JsonReader& reader, const JsonCursor& root, const Document& document) {
  for (const auto& object : document.objects)
    if (object->group != GroupId{} && !find_group(*document.groups, object->group))
      return reader.fail(
          root, "the object " + std::to_string(object->id.value) + " lies in a group that does not exist");
  const GroupTree tree(document);
  for (const Group& group : *document.groups)
    if (!tree.contains(group.id))
      return reader.fail(root, "the group " + std::to_string(group.id.value) + " has no objects");
}

}  // namespace detail

Result<Document> read_document(std::string_view text) {
  const Result<detail::JsonValue> parsed = detail::parse_json(text);
  if (!parsed) return parsed.error();
  detail::JsonReader reader(text);
  const detail::JsonCursor root(*parsed);
  detail::check_head(reader, root);
  if (reader.failed()) return reader.error();
  Document document;
  detail::read_described(reader, root, document);
  if (!reader.failed()) detail::check_object_ids(reader, root, document);
  if (!reader.failed()) detail::check_groups(reader, root, document);
  if (!reader.failed())
    if (const auto checked = check_packed_pictures(document); !checked) reader.fail(checked.error());
  if (reader.failed()) return reader.error();
  return with_group_switches(document);
}

std::string write_document(const Document& document) {
  detail::DocumentText text;
  detail::write_described(text, document);
  return text.take();
}

}  // namespace hariko
