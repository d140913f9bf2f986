#include "ui/editor/saved_views.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/edits/edit_views.hpp"
#include "core/document/words.hpp"

namespace hariko {

namespace {

/// Arguments of `view.save` and `view.update` that give this very view.
std::vector<WrittenArgument> written_view(const SavedView& view) {
  return {written("name", view.name),
          written("target", view.target),
          written("orientation", Vector3(view.orientation.vec())),
          written("orientation_w", view.orientation.w()),
          written("distance", view.distance),
          written("projection", std::string(enum_word(view.projection))),
          written("focal_length", view.focal_length)};
}

}  // namespace

SavedView saved_view_of(const Camera& camera, std::string name) {
  const double own = focal_length_of(camera.field_of_view);
  const double focal = std::clamp(own, SavedView::least_focal_length, SavedView::greatest_focal_length);
  SavedView view;
  view.name = std::move(name);
  view.target = camera.target;
  view.orientation = camera.orientation.normalized();
  view.distance = focal == own ? camera.distance : camera.with_focal_length(focal).distance;
  view.projection = camera.orthographic ? Projection::parallel
                    : camera.two_point  ? Projection::two_point
                                        : Projection::perspective;
  view.focal_length = focal;
  return view;
}

Camera camera_of(const SavedView& view) {
  Camera camera;
  camera.target = view.target;
  camera.orientation = view.orientation;
  camera.distance = view.distance;
  camera.field_of_view = field_of_view_of(view.focal_length);
  camera.orthographic = view.projection == Projection::parallel;
  camera.two_point = view.projection == Projection::two_point;
  return camera;
}

bool looks_as(const Camera& camera, const SavedView& view) {
  constexpr double rounding = 1e-6;
  const Camera other = camera_of(view);
  return camera.orthographic == other.orthographic &&
         (camera.orthographic || camera.two_point == other.two_point) &&
         (camera.target - other.target).norm() <= rounding * other.distance &&
         std::abs(camera.distance - other.distance) <= rounding * other.distance &&
         camera.orientation.angularDistance(other.orientation) <= rounding &&
         std::abs(camera.field_of_view - other.field_of_view) <= rounding;
}

const SavedView* chosen_view(const Editor& editor) {
  if (const SavedView* named = find_view(editor.document(), editor.saved_view)) return named;
  const SavedViews& all = *editor.document().saved_views;
  return all.empty() ? nullptr : &all.back();
}

std::string name_for_new_view(const Editor& editor) {
  for (std::size_t number = 1;; ++number) {
    std::string name = fill(editor.language("View {0}"), {std::to_string(number)});
    if (!find_view(editor.document(), name)) return name;
  }
}

bool save_view(Editor& editor, std::string name) {
  const SavedView view = saved_view_of(editor.layout.active_view().goal(), std::move(name));
  if (!editor.commit(add_view(editor.history.current(), view), translatable("Save view"))) return false;
  editor.tell_script({{"view.save", written_view(view)}});
  editor.saved_view = view.name;
  editor.inform({"The view was saved as {0}.", {view.name}});
  return true;
}

bool go_to_view(Editor& editor, std::string_view name) {
  const SavedView* found = find_view(editor.document(), name);
  if (!found)
    return editor.refuse(update_view(editor.document(), saved_view_of({}, std::string(name))).error());
  const Camera camera = camera_of(*found);
  View& view = editor.layout.active_view();
  constexpr double same = 1e-6;
  if (camera.orientation.angularDistance(view.goal().orientation) > same) view.turns = true;
  view.go_to(camera, editor.now);
  editor.saved_view = found->name;
  return true;
}

bool take_over_view(Editor& editor, const std::string& name) {
  const SavedView view = saved_view_of(editor.layout.active_view().goal(), name);
  if (!editor.commit(update_view(editor.history.current(), view), translatable("Update view"))) return false;
  editor.tell_script({{"view.update", written_view(view)}});
  editor.saved_view = name;
  return true;
}

bool name_view(Editor& editor, const std::string& name, const std::string& next) {
  if (!editor.commit(rename_view(editor.history.current(), name, next), translatable("Rename view")))
    return false;
  editor.tell_script({{"view.rename", {written("name", name), written("to", next)}}});
  if (editor.saved_view == name) editor.saved_view = next;
  return true;
}

bool delete_view(Editor& editor, const std::string& name) {
  if (!editor.commit(remove_view(editor.history.current(), name), translatable("Delete view"))) return false;
  editor.tell_script({{"view.delete", {written("name", name)}}});
  return true;
}

}  // namespace hariko
