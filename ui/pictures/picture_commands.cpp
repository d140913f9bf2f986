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
  return [&editor]() -> Reason {
    if (active_picture(editor)) return {};
    return translatable("No reference picture is chosen. Choose one in the list of objects.");
  };
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

void add_file_rows(CommandHost& host, const std::string& menu) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  ApplicationServices& application = host.application;
  const WhyNot picture = needs_picture(editor);
  host.table.add({"picture.pack", menu, "Pack into the document",
                  "Take the files of the chosen pictures into the document, so that they go where it goes.",
                  "", "", true, true, [&] { application.pack_pictures(chosen_pictures(editor, false)); },
                  [&editor, picture]() -> Reason {
                    if (auto reason = picture()) return reason;
                    if (!chosen_pictures(editor, false).empty()) return {};
                    return translatable("The picture is in the document already.");
                  }});
  host.table.add({"picture.unpack", menu, "Save as a file\u2026",
                  "Write a packed picture to a file and link it.", "", "", true, false,
                  [&] { services.unpack_picture(editor.selection.active); },
                  [&editor, picture]() -> Reason {
                    if (auto reason = picture()) return reason;
                    if (active_picture(editor)->picture()->packed()) return {};
                    return translatable("The picture is a file already.");
                  }});
  host.table.add({"picture.replace", menu, "Choose another file\u2026",
                  "Show another picture in this one's place.", "", "", true, false,
                  [&] { services.replace_picture(editor.selection.active); }, picture});
  host.table.add({"picture.find", menu, "Find missing pictures\u2026",
                  "Show where the first missing picture is; the others are looked for beside it.", "", "",
                  true, false,
                  [&] {
                    const Object& first = *editor.document().find(missing_pictures(editor).front());
                    const std::filesystem::path path(first.picture()->path);
                    services.find_pictures(sanitized_utf8(path.filename().string()));
                  },
                  [&editor]() -> Reason {
                    if (editor.has_document && !missing_pictures(editor).empty()) return {};
                    return translatable("No reference picture is missing.");
                  }});
  host.table.add({"picture.read_again", menu, "Read pictures again",
                  "Show linked pictures as their files are now.", "", "", false, false,
                  [&editor] { editor.references.read_again = true; },
                  [&editor]() -> Reason {
                    if (editor.has_document && !editor.references.views.empty()) return {};
                    return translatable("The document has no reference pictures.");
                  }});
}

}  // namespace

void add_picture_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  host.table.add({"picture.add",
                  "File",
                  "Add reference picture\u2026",
                  "Put a photograph or a drawing (PNG or JPEG) into the scene, to model by.",
                  "",
                  icon::picture,
                  true,
                  false,
                  [&services] { services.add_picture(); },
                  {},
                  {},
                  Context::empty});
  const std::string menu = submenu("File", translatable("Reference pictures"));
  host.table.add({"picture.scale", menu, "Scale by two points",
                  "Click two points of the picture and type how far apart they are.", "", "", true, false,
                  [&host] { scale_by_points(host); },
                  [&editor, picture = needs_picture(editor)]() -> Reason {
                    if (auto reason = picture()) return reason;
                    const Object& object = *active_picture(editor);
                    if (object.locked) return translatable("The picture is locked. Unlock it first.");
                    if (!object.visible) return translatable("The picture is hidden. Show it first.");
                    return {};
                  }});
  add_file_rows(host, menu);
}

}  // namespace hariko
