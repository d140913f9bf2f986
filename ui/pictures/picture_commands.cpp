// Commands on reference pictures: where they come from, and how large they are.

#include <filesystem>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edits.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/reference_pictures.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/pictures/picture_scale_tool.hpp"
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
  host.table.add(
      {.id = "picture.pack",
       .menu = menu,
       .label = "Pack into the document",
       .help = "Take the files of the chosen pictures into the document, so that they go where it goes.",
       .changes_document = true,
       .separator_before = true,
       .run = [&] { application.pack_pictures(chosen_pictures(editor, false)); },
       .why_not = only_if(
           picture, [&editor] { return !chosen_pictures(editor, false).empty(); },
           translatable("The picture is in the document already."))});
  host.table.add({.id = "picture.unpack",
                  .menu = menu,
                  .label = "Save as a file\u2026",
                  .help = "Write a packed picture to a file and link it.",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&] { services.unpack_picture(editor.selection.active); },
                  .why_not = only_if(
                      picture, [&editor] { return active_picture(editor)->picture()->packed(); },
                      translatable("The picture is a file already.")),
                  .script = {.arguments = {path_argument("path", translatable("File"))},
                             .run = [&](const Arguments& given) {
                               application.unpack_picture(editor.selection.active, given.text("path"));
                             }}});
  host.table.add({.id = "picture.replace",
                  .menu = menu,
                  .label = "Choose another file\u2026",
                  .help = "Show another picture in this one's place.",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&] { services.replace_picture(editor.selection.active); },
                  .why_not = picture,
                  .script = {.arguments = {path_argument("path", translatable("File"))},
                             .run = [&](const Arguments& given) {
                               application.replace_picture(editor.selection.active, given.text("path"));
                             }}});
  host.table.add(
      {.id = "picture.find",
       .menu = menu,
       .label = "Find missing pictures\u2026",
       .help = "Show where the first missing picture is; the others are looked for beside it.",
       .changes_document = true,
       .needs_window = true,
       .run = [&host] { find_first_missing(host); },
       .why_not = only_if([&editor] { return editor.has_document && !missing_pictures(editor).empty(); },
                          translatable("No reference picture is missing."))});
  host.table.add(
      {.id = "picture.read_again",
       .menu = menu,
       .label = "Read pictures again",
       .help = "Show linked pictures as their files are now.",
       .needs_window = true,
       .run = [&editor] { editor.references.read_again = true; },
       .why_not = only_if([&editor] { return editor.has_document && !editor.references.views.empty(); },
                          translatable("The document has no reference pictures."))});
}

}  // namespace

void add_picture_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  host.table.add({.id = "picture.add",
                  .menu = "File",
                  .label = "Add reference picture\u2026",
                  .help = "Put a photograph or a drawing (PNG, JPEG or WebP) into the scene, to model by.",
                  .icon = icon::picture,
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&services] { services.add_picture(); },
                  .contexts = Context::empty,
                  .script = {.arguments = {path_argument("path", translatable("File"))},
                             .run = [&host](const Arguments& given) {
                               host.application.add_pictures({given.text("path")});
                             }}});
  const std::string menu = submenu("File", translatable("Reference pictures"));
  host.table.add({.id = "picture.scale",
                  .menu = menu,
                  .label = "Scale by two points",
                  .help = "Click two points of the picture and type how far apart they are.",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&host] { scale_by_points(host); },
                  .why_not = [&editor, picture = needs_picture(editor)]() -> Reason {
                    if (auto reason = picture()) return reason;
                    const Object& object = *active_picture(editor);
                    if (object.locked) return translatable("The picture is locked. Unlock it first.");
                    if (!object.visible) return translatable("The picture is hidden. Show it first.");
                    return {};
                  }});
  add_file_rows(host, menu);
}

}  // namespace hariko
