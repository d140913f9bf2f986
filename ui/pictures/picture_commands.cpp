// Commands on reference pictures: where they come from, and how large they are.

#include <filesystem>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edits.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/reference_pictures.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/pictures/picture_rows.hpp"
#include "ui/view/viewport.hpp"
#include "ui/widgets/application_services.hpp"
#include "ui/widgets/command_services.hpp"

namespace hariko {

namespace {

WhyNot needs_picture(const Editor& editor) {
  return only_if([&editor] { return active_picture(editor) != nullptr; },
                 translatable("No reference picture is chosen. Choose one in the list of objects."));
}

/// The chosen pictures that are packed, or linked.
std::vector<ObjectId> chosen_pictures(const Editor& editor, bool packed) {
  std::vector<ObjectId> out;
  for (const ObjectId id : chosen_ids(editor)) {
    const Object* object = editor.document().find(id);
    if (object && object->picture() && object->picture()->packed() == packed) out.push_back(id);
  }
  return out;
}

void scale_by_points(CommandHost& host) {
  const Object* object = active_picture(host.editor);
  look_at_picture(host.editor, *object);
  host.viewport.start_modal(make_picture_scale_tool(object->id));
}

void find_first_missing(CommandHost& host) {
  const Object& first = *host.editor.document().find(missing_pictures(host.editor).front());
  const std::filesystem::path path(first.picture()->path);
  host.services.find_pictures(sanitized_utf8(path.filename().string()));
}

void add_file_rows(CommandHost& host, const std::string& menu) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  ApplicationServices& application = host.application;
  const WhyNot picture = needs_picture(editor);
  MenuRows rows(host.table, menu);
  rows.add_edit("picture.pack", "Pack into the document",
                "Take the files of the chosen pictures into the document, so that they go where it goes.",
                [&] { application.pack_pictures(chosen_pictures(editor, false)); },
                only_if(
                    picture, [&editor] { return !chosen_pictures(editor, false).empty(); },
                    translatable("The picture is in the document already.")),
                {.separator_before = true});
  rows.add_edit("picture.unpack", "Save as a file\u2026", "Write a packed picture to a file and link it.",
                [&] { services.unpack_picture(editor.selection.active); },
                only_if(
                    picture, [&editor] { return active_picture(editor)->picture()->packed(); },
                    translatable("The picture is a file already.")),
                {.needs_window = true,
                 .script = {.arguments = {path_argument("path", translatable("File"))},
                            .run = [&](const Arguments& given) {
                              application.unpack_picture(editor.selection.active, given.text("path"));
                            }}});
  rows.add_edit("picture.replace", "Choose another file\u2026", "Show another picture in this one's place.",
                [&] { services.replace_picture(editor.selection.active); }, picture,
                {.needs_window = true,
                 .script = {.arguments = {path_argument("path", translatable("File"))},
                            .run = [&](const Arguments& given) {
                              application.replace_picture(editor.selection.active, given.text("path"));
                            }}});
  rows.add_edit("picture.find", "Find missing pictures\u2026",
                "Show where the first missing picture is; the others are looked for beside it.",
                [&host] { find_first_missing(host); },
                only_if([&editor] { return editor.has_document && !missing_pictures(editor).empty(); },
                        translatable("No reference picture is missing.")),
                {.needs_window = true});
  rows.add("picture.read_again", "Read pictures again", "Show linked pictures as their files are now.",
           [&editor] { editor.references.read_again = true; },
           only_if([&editor] { return editor.has_document && !editor.references.views.empty(); },
                   translatable("The document has no reference pictures.")),
           {.needs_window = true});
}

}  // namespace

void add_picture_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  MenuRows(host.table, "File")
      .add_edit("picture.add", "Add reference picture\u2026",
                "Put a photograph or a drawing (PNG, JPEG or WebP) into the scene, to model by.",
                [&services] { services.add_picture(); }, {},
                {.icon = icon::picture,
                 .needs_window = true,
                 .contexts = Context::empty,
                 .script = {.arguments = {path_argument("path", translatable("File"))},
                            .run = [&host](const Arguments& given) {
                              host.application.add_pictures({given.text("path")});
                            }}});
  const std::string menu = submenu("File", translatable("Reference pictures"));
  MenuRows(host.table, menu)
      .add_edit(
          "picture.scale", "Scale by two points",
          "Click two points of the picture and type how far apart they are.",
          [&host] { scale_by_points(host); },
          [&editor, picture = needs_picture(editor)]() -> Reason {
            if (auto reason = picture()) return reason;
            const Object& object = *active_picture(editor);
            if (object.locked) return translatable("The picture is locked. Unlock it first.");
            if (!object.visible) return translatable("The picture is hidden. Show it first.");
            return {};
          },
          {.needs_window = true});
  add_file_rows(host, menu);
}

}  // namespace hariko
