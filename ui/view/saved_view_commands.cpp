// Commands of saved views and of the lens.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/edits/edit_views.hpp"
#include "core/document/words.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/saved_views.hpp"
#include "ui/view/view_menus.hpp"

namespace hariko {

namespace {

/// Lenses that the keys go through, in millimetres.
constexpr std::array usual_lenses{15.0, 20.0, 24.0, 28.0, 35.0, 50.0, 70.0, 85.0, 105.0, 135.0, 200.0, 300.0};

const std::string saved_folder = submenu("View", translatable("Saved views"));
const std::string lens_folder = submenu("View", translatable("Lens"));

WhyNot needs_saved_view(const Editor& editor) {
  return only_if(
      needs_document(editor), [&editor] { return chosen_view(editor) != nullptr; },
      translatable("No view is saved yet."));
}

/// Name of the chosen view; only where the document has views.
std::string chosen_name(const Editor& editor) {
  const SavedView* chosen = chosen_view(editor);
  HARIKO_ASSERT(chosen, "no view is saved");
  return chosen->name;
}

/// Goes from the chosen view to the next one of the list, or to the one before it; round at the ends.
void step_saved_view(Editor& editor, bool forward) {
  const SavedViews& all = *editor.document().saved_views;
  if (all.empty()) return;
  std::size_t at = forward ? 0 : all.size() - 1;
  if (const SavedView* chosen = chosen_view(editor)) {
    const auto place = static_cast<std::size_t>(chosen - all.data());
    at = (place + (forward ? 1 : all.size() - 1)) % all.size();
  }
  go_to_view(editor, std::string(all[at].name));
}

void step_lens(Editor& editor, bool longer) {
  constexpr double rounding = 1e-6;
  View& view = editor.layout.active_view();
  const double own = focal_length_of(view.goal().field_of_view);
  double next = longer ? usual_lenses.back() : usual_lenses.front();
  for (const double lens : usual_lenses) {
    if (longer && lens > own + rounding) next = std::min(next, lens);
    if (!longer && lens < own - rounding) next = std::max(next, lens);
  }
  if (std::abs(next - own) > rounding) view.fly_to(view.goal().with_focal_length(next), editor.now);
}

// Scripts.

std::vector<std::string> side_words() {
  std::vector<std::string> words;
  for (const StandardView side :
       {StandardView::iso, StandardView::front, StandardView::back, StandardView::left, StandardView::right,
        StandardView::top, StandardView::bottom})
    words.emplace_back(to_string(side));
  return words;
}

std::vector<ArgumentSpec> view_arguments() {
  return {
      text_argument("name", translatable("Name")),
      word_argument("from", translatable("side that the view looks from, unless it has an orientation"),
                    side_words(), "iso"),
      optional(point_argument("orientation", translatable("x, y and z of a quaternion from camera to model"),
                              ArgumentUnit::none, {})),
      number_argument("orientation_w", translatable("w of that quaternion"), 1, -1, 1),
      optional(point_argument("target", translatable("point in the middle; without it everything is framed"),
                              ArgumentUnit::length, {})),
      optional(length_argument("distance", translatable("from the eye to the target"), {}, 0)),
      word_argument("projection", translatable("kind of projection"),
                    {"perspective", "parallel", "two_point"}, "perspective"),
      number_argument("focal_length", translatable("millimetres on film of 36 x 24 mm"), 50,
                      SavedView::least_focal_length, SavedView::greatest_focal_length)};
}

/// View that a script describes. What it leaves out is such that everything fits into a picture of 3 : 2.
SavedView view_of_script(const Editor& editor, const Arguments& given) {
  constexpr PixelSize picture{1500, 1000};
  SavedView view;
  view.name = given.text("name");
  view.projection = *enum_value<Projection>(given.text("projection"));
  view.focal_length = given.number("focal_length");
  view.orientation = Camera::standard(*standard_view_from(given.text("from"))).orientation;
  if (given.has("orientation")) {
    const Vector3& axis = given.point("orientation");
    view.orientation = Eigen::Quaterniond(given.number("orientation_w"), axis.x(), axis.y(), axis.z());
  }
  if (given.has("target")) view.target = given.point("target");
  if (given.has("distance")) view.distance = given.number("distance");
  if (given.has("target") && given.has("distance")) return view;
  const Box3 box = box_of_visible(editor.document());
  const Camera framed = camera_of(view).frame(box, picture);
  if (!given.has("target")) view.target = framed.target;
  if (!given.has("distance")) view.distance = framed.distance;
  return view;
}

void save_by_script(Editor& editor, const Arguments& given) {
  editor.saved_view = given.text("name");
  editor.commit(add_view(editor.history.current(), view_of_script(editor, given)), translatable("Save view"));
}

void update_by_script(Editor& editor, const Arguments& given) {
  editor.commit(update_view(editor.history.current(), view_of_script(editor, given)),
                translatable("Update view"));
}

void add_view_saving(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows rows(host.table, saved_folder);
  rows.add_edit("view.save", "Save view", "Keep what this view shows under a name, in the document.",
                [&editor] { save_view(editor, name_for_new_view(editor)); }, document,
                {.keys = "Ctrl+Alt+V",
                 .script = {.arguments = view_arguments(),
                            .run = [&editor](const Arguments& given) { save_by_script(editor, given); }}});
  const WhyNot any = needs_saved_view(editor);
  const auto stepping = [&](const char* id, const char* label, const char* help, const char* keys,
                            bool forward) {
    rows.add(id, label, help, [&editor, forward] { step_saved_view(editor, forward); }, any,
             {.keys = keys, .while_tool_runs = true});
  };
  stepping("view.next_saved", "Next saved view", "Go to the saved view after the chosen one.", "Alt+PgDn",
           true);
  stepping("view.previous_saved", "Previous saved view", "Go to the saved view before the chosen one.",
           "Alt+PgUp", false);
}

void add_view_changing(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot chosen = needs_saved_view(editor);
  const auto name_argument = [] { return text_argument("name", translatable("Name")); };
  MenuRows rows(host.table, saved_folder);
  rows.add("view.go", "Back to the saved view", "Show again what the saved view shows that was chosen last.",
           [&editor] { go_to_view(editor, chosen_name(editor)); }, chosen, {.while_tool_runs = true});
  rows.add_edit("view.update", "Update saved view",
                "Put what this view shows in the place of the saved view that was chosen last.",
                [&editor] { take_over_view(editor, chosen_name(editor)); }, chosen,
                {.separator_before = true,
                 .script = {.arguments = view_arguments(),
                            .run = [&editor](const Arguments& given) { update_by_script(editor, given); }}});
  rows.add_edit("view.rename", "Rename saved view\u2026",
                "Give the saved view that was chosen last another name.",
                [&editor, &host] { ask_view_name(editor, host.services, chosen_name(editor)); }, chosen,
                {.needs_window = true,
                 .script = {.arguments = {name_argument(), text_argument("to", translatable("the new name"))},
                            .run = [&editor](const Arguments& given) {
                              name_view(editor, given.text("name"), given.text("to"));
                            }}});
  rows.add_edit(
      "view.delete", "Delete saved view", "Take the saved view that was chosen last out of the document.",
      [&editor] { delete_view(editor, chosen_name(editor)); }, chosen,
      {.script = {.arguments = {name_argument()},
                  .run = [&editor](const Arguments& given) { delete_view(editor, given.text("name")); }}});
}

void add_lens_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows rows(host.table, lens_folder, true);
  rows.add("view.focal_length", "Focal length\u2026",
           "How wide the view sees in perspective, in millimetres as on film of 36 x 24 mm.",
           [&editor, &host] { ask_focal_length(editor, host.services); }, document, {.needs_window = true});
  rows.add("view.longer_lens", "Longer lens", "The next longer focal length: flatter, from farther away.",
           [&editor] { step_lens(editor, true); }, document, {.keys = "Alt+Num +"});
  rows.add("view.wider_lens", "Wider lens", "The next shorter focal length: deeper, from nearer by.",
           [&editor] { step_lens(editor, false); }, document, {.keys = "Alt+Num -"});
  rows.add("view.two_point", "Two-point perspective",
           "Upright edges stay upright and parallel in the picture.",
           [&editor] { editor.layout.active_view().toggle_two_point(); }, document,
           {.keys = "Ctrl+Num 5", .separator_before = true, .checked = [&editor] {
              return editor.camera().two_point && !editor.camera().orthographic;
            }});
}

}  // namespace

void add_saved_view_commands(CommandHost& host) {
  add_view_saving(host);
  add_view_changing(host);
  add_lens_commands(host);
}

}  // namespace hariko
