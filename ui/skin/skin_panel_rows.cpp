// Rows of the properties about a skin and its selected points, for commands that name them and scripts that
// set them.

#include <array>
#include <utility>
#include <vector>

#include "core/document/words.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/sections/make_rails.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/skin/skin_properties.hpp"
#include "ui/widgets/script_edits.hpp"

namespace hariko {

namespace {

bool row_of_skin(const Editor& editor) {
  return editor.active_object()->skin() != nullptr;
}
bool row_of_skin_mirror(const Editor& editor) {
  return row_of_skin(editor) && editor.active_object()->skin()->skin->mirror.has_value();
}
bool row_of_section_points(const Editor& editor) {
  return row_of_skin(editor) && !selected_section_points(editor).empty();
}
bool row_of_section_start(const Editor& editor) {
  const SkinSection* section = row_of_skin(editor) ? selected_section(editor) : nullptr;
  return section && section->closed && section->size() > 2;
}
bool row_of_path_point(const Editor& editor) {
  return row_of_skin(editor) && selected_path_points(editor).size() == 1;
}

constexpr const char* no_section_point =
    translatable("No point of a section is selected. Click one in the view.");
constexpr const char* no_path_point =
    translatable("No point of the path is selected. Click one in the view.");
constexpr const char* no_skin_mirror = translatable("The skin has no mirror. Choose one first.");

constexpr std::array rows_of_skins{
    PanelRow{"skin_frame", "Rails", "How sections turn along the path", "Skin", row_of_skin},
    PanelRow{"skin_closed", "Tube", "Sections are closed curves and the skin is a tube", "Skin", row_of_skin},
    PanelRow{"skin_closed_path", "Closed path", "The path runs back to its beginning", "Skin", row_of_skin},
    PanelRow{"skin_mirror_at", "At", "Where the mirror is on the axis of the object", "Skin",
             row_of_skin_mirror, no_skin_mirror},
    PanelRow{"skin_sharp", "Corner", "The section has a corner here, and the surface a crease", "Skin",
             row_of_section_points, no_section_point},
    PanelRow{"skin_start", "Own start",
             "The first point belongs to the first point of the section before; otherwise the section begins "
             "where the two are nearest",
             "Skin", row_of_section_start, no_section_point},
    PanelRow{"skin_path_sharp", "Corner", "The path has a corner here", "Skin", row_of_path_point,
             no_path_point},
};

/// Adds an edit of skins; other objects stay as they are.
void add_skin_edit(PropertyScripts& scripts, const char* id, ArgumentSpec argument, const char* step,
                   Result<SkinEdit> (*edit)(const Skin&, const Arguments&),
                   WrittenArguments (*read)(const Skin&)) {
  scripts.add(
      id, {std::move(argument)}, step,
      [edit](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
        if (!object.skin()) return document;
        return with_skin(document, object.id, edit(*object.skin()->skin, given));
      },
      [read](const Object& object) {
        return object.skin() ? read(*object.skin()->skin) : WrittenArguments();
      });
}

Result<SkinEdit> frame_skin(const Skin& skin, const Arguments& given) {
  SkinEdit plain{skin, 0, {}, {}, {}};
  plain.skin.frame = chosen_of<FrameMode>(given);
  return plain.skin.frame == FrameMode::two_rail ? make_rails(skin) : plain;
}

}  // namespace

std::vector<PanelRow> skin_panel_rows() {
  return {rows_of_skins.begin(), rows_of_skins.end()};
}

void add_skin_scripts(PropertyScripts& scripts) {
  add_skin_edit(scripts, "skin_frame", one_of<FrameMode>(), "Frames of the skin", frame_skin,
                [](const Skin& now) { return word_now(now.frame); });
  add_skin_edit(
      scripts, "skin_closed", on_or_off(), "Close or open sections",
      [](const Skin& skin, const Arguments& given) { return set_closed(skin, given.on("on")); },
      [](const Skin& now) { return on_now(has_closed_sections(now)); });
  add_skin_edit(
      scripts, "skin_closed_path", on_or_off(), "Close or open path",
      [](const Skin& skin, const Arguments& given) { return set_path_closed(skin, given.on("on")); },
      [](const Skin& now) { return on_now(now.path.closed); });
}

}  // namespace hariko
