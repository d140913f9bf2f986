#include "ui/outline/gauss_panel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/base/icons.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float bar_height = 38, site_reach = 9, drag_pixels = 3;  // design pixels
constexpr float greatest_zoom = 12;
constexpr Index most_marks = 600;

/// The surface's normal at a point that was pointed at, in the axes of the object of the sphere.
std::optional<Vector3> normal_at(const Editor& editor, const GaussView& view,
                                 const std::optional<SurfacePoint>& point) {
  if (!point || !view.object || point->object != view.object->id) return {};
  const SurfaceView* surface = editor.view_of(point->object);
  if (!surface || point->patch >= surface->surface.patch_count()) return {};
  const PatchPoint at = surface->surface.patches().evaluate(point->patch, point->parameter, Order::first);
  const Vector3 normal = at.ds.cross(at.dt);
  if (!(normal.norm() > 0)) return {};
  return Vector3(normal.normalized());
}

Index nearest_site(const SphereMesh& mesh, const Vector3& direction) {
  Index best = 0;
  for (Index i = 1; i < mesh.site_count(); ++i)
    if (mesh.site(i).dot(direction) > mesh.site(best).dot(direction)) best = i;
  return best;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

void GaussPanel::draw(PanelContext& context, GaussView& view, const PanelRect& rect,
                      const std::optional<SurfacePoint>& pointed) {
  const Metrics& m = context.metrics;
  const float bar = m.px(bar_height);
  hint_.clear();
  if (begin_panel("Gauss sphere", {rect.min, {rect.max.x, rect.min.y + bar}}, palette().panel,
                  {m.px(8), m.px(6)}, ImGuiWindowFlags_NoScrollbar))
    toolbar(context, view, rect.width());
  ImGui::End();
  const bool steps = view.sphere && (view.sphere->mesh || view.sphere->inserted > 0);
  const PanelRect middle{{rect.min.x, rect.min.y + bar}, {rect.max.x, rect.max.y - (steps ? bar : 0)}};
  if (begin_panel("Sphere", middle, palette().window, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse))
    sphere(context, view, middle, pointed);
  ImGui::End();
  if (!steps) return;
  if (begin_panel("Steps", {{rect.min.x, rect.max.y - bar}, rect.max}, palette().panel, {m.px(8), m.px(6)},
                  ImGuiWindowFlags_NoScrollbar))
    step_bar(context, view, rect.width());
  ImGui::End();
}

void GaussPanel::toolbar(PanelContext& context, GaussView& view, float width) {
  const auto box = [&](const char* label, const char* id, const char* help, bool& value) {
    option_check(context, id, label, help, value);
    ImGui::SameLine();
  };
  box(translatable("Cells"), "gauss.cells",
      translatable("Directions that are nearer to a site than to others"), view.cells);
  box(translatable("Triangles"), "gauss.triangles", translatable("Sites whose planes meet in a corner"),
      view.triangles);
  const char* close = translatable("Close");
  const Metrics& m = context.metrics;
  const float size = ImGui::CalcTextSize(context.tr(close)).x + 2 * ImGui::GetStyle().FramePadding.x;
  const float left = ImGui::GetCursorPosX(), right = width - m.px(8);
  // The word gives way to a cross where there is no room for it.
  const bool word = left + size <= right;
  constexpr float cross = 24;
  ImGui::SetCursorPosX(std::max(left, right - (word ? size : m.px(cross))));
  const bool pressed = word ? text_button(context.marks, "gauss.close", context.tr(close))
                            : icon_button(context, icon::close, "gauss.close", close, false, cross);
  if (pressed) context.run("outline.sphere");
}

void GaussPanel::step_bar(PanelContext& context, GaussView& view, float width) {
  const Metrics& m = context.metrics;
  const int all = static_cast<int>(view.sphere->inserted);
  int step = view.step ? std::min(static_cast<int>(*view.step), all) : all;
  const int before = step;
  const auto arrow = [&](const char* id, ImGuiDir direction, int by, const char* help) {
    if (arrow_button(context.marks, id, direction, context.tr(help))) step = std::clamp(step + by, 0, all);
    ImGui::SameLine();
  };
  arrow("gauss.back", ImGuiDir_Left, -1, translatable("One site less"));
  arrow("gauss.forward", ImGuiDir_Right, 1, translatable("Insert one more site"));
  std::string text = fill(context.tr("{0} of {1} sites"), {std::to_string(step), std::to_string(all)});
  const auto track = [&] {
    return width - ImGui::GetCursorPosX() - ImGui::CalcTextSize(text.c_str()).x - m.px(24);
  };
  const float least_track = m.px(40);
  if (track() < least_track) text = std::to_string(step) + " / " + std::to_string(all);
  track_slider(context.marks, "gauss.step", std::max(least_track, track()), all, step);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    show_tip(context.tr("Inserts the sites one by one, each where most room is"));
  ImGui::SameLine();
  plain_text(text);
  if (step != before) view.step = step < all ? std::optional(Index(step)) : std::nullopt;
}

void GaussPanel::say(PanelContext& context, const std::string& text, const std::string& remedy, bool wrong,
                     const PanelRect& rect) const {
  const Metrics& m = context.metrics;
  const float width = std::min(rect.width() - m.px(32), m.px(420));
  ImGui::SetCursorScreenPos({rect.min.x + (rect.width() - width) / 2, rect.min.y + m.px(14)});
  ImGui::BeginChild("message", {width, m.px(110)}, false, ImGuiWindowFlags_NoInputs);
  coloured_lines(wrong ? palette().error : palette().dim_text, text);
  if (!remedy.empty()) coloured_lines(palette().dim_text, remedy);
  ImGui::EndChild();
}

SpherePlace GaussPanel::place_in(const Editor& editor, const GaussView& view, const PanelRect& rect) const {
  SpherePlace out;
  out.to_camera =
      editor.camera().orientation.conjugate().toRotationMatrix() * Matrix3(view.object->transform.rotation);
  const float room = std::min(rect.width(), rect.height());
  out.radius = 0.42F * room * zoom_;
  out.centre = {(rect.min.x + rect.max.x) / 2, (rect.min.y + rect.max.y) / 2};
  if (zoom_ <= 1) return out;
  Vector3 middle = Vector3::Zero();
  for (const auto& loop : view.sphere->loops)
    for (const Vector3& normal : loop) middle += normal;
  if (!(middle.norm() > 0)) return out;
  // At the beginning the sphere is in the middle, and more and more its image.
  const ImVec2 at = out.to_screen(middle.normalized());
  const float share = 1 - 1 / zoom_;
  out.centre = {out.centre.x - share * (at.x - out.centre.x), out.centre.y - share * (at.y - out.centre.y)};
  return out;
}

void GaussPanel::sphere(PanelContext& context, GaussView& view, const PanelRect& rect,
                        const std::optional<SurfacePoint>& pointed) {
  context.marks.rect("gauss.view", rect.min, rect.max);
  Editor& editor = context.editor;
  if (!active_outline(editor))
    return say(context, context.tr("The chosen object is not an outline. Choose one in the list of objects."),
               {}, false, rect);
  if (!view.sphere || !view.object) return;
  const bool hovered = pointer_area(context.marks, "gauss.view", rect);
  if (hovered && ImGui::GetIO().MouseWheel != 0)
    zoom_ = std::clamp(zoom_ * std::pow(1.15F, ImGui::GetIO().MouseWheel), 1.0F, greatest_zoom);
  const SpherePlace place = place_in(editor, view, rect);
  SphereHighlights lit;
  lit.pointed = normal_at(editor, view, pointed);
  if (hovered) {
    point_at(context, view, place, hovered);
  } else {
    view.hovered.reset();
    if (editor.hovered && editor.hovered->object == view.object->id &&
        editor.hovered->element.kind == Element::Kind::vertex)
      view.hovered = static_cast<Index>(editor.hovered->element.id);
    else if (lit.pointed && view.sphere->mesh)
      view.hovered = nearest_site(*view.sphere->mesh, *lit.pointed);
  }
  press_and_drag(context, view, place, hovered);
  lit.hovered = view.hovered;
  if (const Object* object = active_outline(editor)) lit.selected = selected_points(editor, *object);
  if (view.selected) lit.selected.insert(*view.selected);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(rect.min, rect.max, true);
  draw_gauss_sphere(list, context.metrics, view, place, lit);
  list.PopClipRect();
  if (view.sphere->error)
    say(context, context.tr.text_of(*view.sphere->error), context.tr.remedy_of(*view.sphere->error), true,
        rect);
  else if (!view.sphere->mesh)
    say(context, context.tr("The mode Position bends the surface in space: no sites are inserted here."), {},
        false, rect);
  if (!view.sphere->mesh) return;
  const auto mark = [&](const std::string& name, Index site) {
    const Vector3& direction = view.sphere->mesh->site(site);
    const ImVec2 at = place.to_screen(direction);
    if (place.depth(direction) >= 0 && at.x > rect.min.x && at.x < rect.max.x && at.y > rect.min.y &&
        at.y < rect.max.y)
      context.marks.rect(name, {at.x - 1, at.y - 1}, {at.x + 1, at.y + 1});
  };
  for (Index i = 0; i < std::min(view.sphere->mesh->site_count(), most_marks); ++i)
    mark("gauss.site." + std::to_string(i), i);
  if (view.has(view.hovered)) mark("gauss.hovered", *view.hovered);
}

void GaussPanel::point_at(PanelContext& context, GaussView& view, const SpherePlace& place, bool hovered) {
  view.hovered = hovered ? site_under(view, place, ImGui::GetIO().MousePos, context.metrics.px(site_reach))
                         : std::nullopt;
  hint_ = context.tr(view.hovered ? translatable("Click selects   drag turns the sphere and the view")
                                  : translatable("Drag turns the sphere and the view   the wheel zooms"));
  if (!view.has(view.hovered) || !view.sphere->points) return;
  const Index site = *view.hovered;
  const std::string name = fill(
      context.tr(view.sphere->mesh->is_boundary(site) ? translatable("Point {0}") : translatable("Site {0}")),
      {std::to_string(site)});
  pointer_tip(name + "\n" + context.tr("Gaussian curvature") + " " +
              number_text(view.sphere->points->curvature[site]));
}

void GaussPanel::press_and_drag(PanelContext& context, GaussView& view, const SpherePlace& place,
                                bool hovered) {
  Editor& editor = context.editor;
  const bool active = ImGui::IsItemActive();
  if (ImGui::IsItemActivated()) dragged_ = false;
  if (active && ImGui::IsMouseDragging(ImGuiMouseButton_Left, context.metrics.px(drag_pixels))) {
    View& model = editor.layout.active_view();
    if (!dragged_ && model.turns) model.begin_turning(editor.now);
    dragged_ = true;
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    const double yaw = double(by.x / place.radius), pitch = double(by.y / place.radius);
    const Camera camera = editor.camera();
    // Plans keep their direction, and the sphere is seen from there.
    if (model.turns)
      editor.set_camera(editor.settings.trackball ? camera.trackball(yaw, pitch, camera.target)
                                                  : camera.orbit(yaw, pitch));
  }
  if (!ImGui::IsItemDeactivated() || dragged_ || !hovered) return;
  const bool point = view.has(view.hovered) && view.sphere->mesh->is_boundary(*view.hovered);
  view.selected = view.hovered && !point && view.selected != view.hovered ? view.hovered : std::nullopt;
  if (!point) return;
  ElementSelection chosen;
  chosen.vertices.insert(VertexId{*view.hovered});
  editor.mode = ElementMode::vertex;
  editor.selection.select(view.object->id, chosen,
                          ImGui::GetIO().KeyShift ? Selection::How::add : Selection::How::replace);
}

}  // namespace hariko
