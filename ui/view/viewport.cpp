#include "ui/view/viewport.hpp"

#include <algorithm>

#include "ui/base/texture.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/view/axis_gizmo.hpp"
#include "ui/view/legend.hpp"
#include "ui/view/navigation.hpp"
#include "ui/view/view_frame.hpp"
#include "ui/view/view_menus.hpp"
#include "ui/widgets/items.hpp"

namespace hariko {

namespace {

constexpr float gizmo_radius = 44, gizmo_margin = 12;  // design pixels

/// Small views have a small gizmo, and none where it would hide the model.
float gizmo_size(const Metrics& metrics, const PanelRect& rect) {
  const float room = std::min(rect.width(), rect.height());
  return room < metrics.px(160) ? 0 : std::min(metrics.px(gizmo_radius), room / 6);
}

AxisGizmo gizmo_of(const Metrics& metrics, const PanelRect& rect, const Camera& camera) {
  const float radius = gizmo_size(metrics, rect);
  const float inset = radius + metrics.px(gizmo_margin);
  return {camera, {rect.max.x - inset, rect.min.y + inset}, radius};
}

}  // namespace

void Viewport::frame_views() {
  for (const Place& place : panes_.places()) {
    View& view = editor_.layout.views[static_cast<std::size_t>(place.view)];
    if (!view.wants_framing && !editor_.wants_framing) continue;
    editor_.frame_at_once(place.view, ViewPanes::size_of(place));
    view.wants_framing = false;
  }
  if (editor_.wants_framing)
    for (int i = 0; i < ViewLayout::count; ++i)
      editor_.layout.views[static_cast<std::size_t>(i)].wants_framing = !editor_.layout.shows(i);
  editor_.wants_framing = false;
}

void Viewport::draw(PanelContext& context, const PanelRect& rect) {
  // Compared pictures are seen from the same place.
  if (editor_.meshing.comparing()) editor_.layout.views.fill(View(editor_.layout.active_view()));
  panes_.arrange(rect);
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  editor_.pixel_scale = double(context.metrics.scale) * double(scale.x);
  frame_views();
  if (begin_panel("Viewport", rect, palette().window, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    // Controls over the pictures come first: ImGui gives the pointer to the first of overlapping items.
    panes_.drag_splitters(context, rect);
    for (Place& place : panes_.places()) {
      place.title_hovered = view_title_button(context, place.view, place.rect);
      const PanelRect title = view_title_place(context, place.view, place.rect);
      place.views_hovered = views_button(context, place.view, title, place.rect);
      place.snaps_hovered =
          snap_button(context, place.view, views_button_place(context, title, place.rect), place.rect);
      gizmo_button(context, place);
    }
    const bool hovered = pointer_area(context.marks, "viewport", rect, all_buttons);
    tools_.end_stale_tool();
    panes_.activate_under_pointer(rect, tool_active());
    scene_.update(editor_);  // hovering and clicking look at what is there now
    update_layers();
    handle_pointer(hovered);
    // A title or a tool may have arranged the views anew.
    panes_.arrange(rect);
    scene_.update(editor_);
    std::vector<ViewPictures::Shown> shown;
    for (const Place& place : panes_.places()) shown.push_back({place.view, ViewPanes::size_of(place)});
    update_layers();
    jumps_.update(editor_);
    selection_size_.update(editor_);
    pictures_.update(editor_, scene_, shown, tool_active(), jumps_.count());
    for (const Place& place : panes_.places()) show(context, place);
    draw_legend(context, rect, scene_);
  }
  ImGui::End();
}

void Viewport::update_layers() {
  for (const auto& layer : layers_) layer->update({editor_, scene_}, tool_active());
}

void Viewport::gizmo_button(PanelContext& context, Place& place) {
  place.gizmo_hovered = false;
  const float radius = gizmo_size(context.metrics, place.rect);
  if (radius <= 0) return;
  const Camera camera = editor_.layout.views[static_cast<std::size_t>(place.view)].camera(editor_.now);
  const AxisGizmo gizmo = gizmo_of(context.metrics, place.rect, camera);
  const std::string name = "view." + std::to_string(place.view) + ".axes";
  for (const AxisGizmo::Ball& ball : gizmo.balls()) {
    const ImVec2 c = gizmo.centre_of(ball);
    const std::string end{ball.positive ? '+' : '-', "xyz"[ball.axis]};
    context.marks.rect(name + end, {c.x - 2, c.y - 2}, {c.x + 2, c.y + 2});
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (tool_active() || !gizmo.holds(mouse)) return;
  const float margin = context.metrics.px(gizmo_margin), side = 2 * radius;
  const ImVec2 low(place.rect.max.x - side - margin, place.rect.min.y + margin);
  place.gizmo_hovered = pointer_area(context.marks, name, {low, {low.x + side, low.y + side}});
  if (!ImGui::IsItemClicked(ImGuiMouseButton_Left)) return;
  panes_.activate(place);
  PointerEvent press;
  press.kind = PointerEvent::Kind::press;
  press.pixel = panes_.pixel_at(mouse);
  tools_.start(make_axis_gizmo_tool(gizmo.side_at(mouse)), press);
}

void Viewport::show(PanelContext& context, const Place& place) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Camera camera = editor_.layout.views[static_cast<std::size_t>(place.view)].camera(editor_.now);
  context.marks.rect("view." + std::to_string(place.view), place.rect.min, place.rect.max);
  list.PushClipRect(place.rect.min, place.rect.max, true);
  const auto picture = [&](unsigned texture, float opacity) {
    list.AddImage(imgui_texture(texture), place.rect.min, place.rect.max, {0, 1}, {1, 0},
                  with_alpha(IM_COL32_WHITE, opacity));
  };
  const double share = pictures_.shown_share(place.view, editor_.now);
  if (share < 1) picture(pictures_.faded_texture(place.view), 1);
  picture(pictures_.texture(place.view), static_cast<float>(share));
  draw_over(context, place, camera);
  if (place.view == editor_.layout.active() && panes_.places().size() > 1)
    list.AddRect(place.rect.min, place.rect.max,
                 (palette().secondary & 0x00ffffff) | (0xb0U << IM_COL32_A_SHIFT), 0, 0,
                 context.metrics.px(1));
  list.PopClipRect();
}

/// Scales, layers and titles over the picture of a view.
void Viewport::draw_over(PanelContext& context, const Place& place, const Camera& camera) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const PixelSize size = ViewPanes::size_of(place);
  const bool active = place.view == editor_.layout.active();
  draw_scale_bar(context, camera, place.rect);
  draw_grid_labels(context, camera, place.rect, scene_.scene().grid);
  const ToolContext around{editor_, scene_};
  const ToolOverlay overlay{list, place.rect.min, context.metrics};
  const bool free = active && !tool_active() && holds(place.rect, ImGui::GetIO().MousePos);
  const LayerPane pane{Projector(camera, size), overlay, active,
                       free ? std::optional(panes_.pixel_at(ImGui::GetIO().MousePos)) : std::nullopt,
                       context.marks};
  for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) (*layer)->draw(around, pane);
  if (active && tool_active()) tools_.running()->draw(around, overlay);
  if (gizmo_size(context.metrics, place.rect) > 0) {
    const auto pointer = place.gizmo_hovered ? std::optional(ImGui::GetIO().MousePos) : std::nullopt;
    gizmo_of(context.metrics, place.rect, camera).draw(list, pointer, place.gizmo_hovered);
  }
  draw_mesh_overlay(context, camera, size, place.rect, static_cast<std::size_t>(place.view));
  if (active) draw_probe(context, camera, size, place.rect, pointed_at_);
  if (active) draw_frame_overlay(context, place.rect);
  draw_view_title(context, place.view, place.rect, place.title_hovered);
  const PanelRect title = view_title_place(context, place.view, place.rect);
  draw_views_button(context, place.view, title, place.rect, place.views_hovered);
  draw_snap_button(context, place.view, views_button_place(context, title, place.rect), place.rect,
                   place.snaps_hovered);
}

void Viewport::handle_pointer(bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerEvent now;
  now.pixel = panes_.pixel_at(io.MousePos);
  now.shift = io.KeyShift;
  now.control = io.KeyCtrl;
  now.alt = io.KeyAlt;
  tools_.frame(now, hovered, [this](const PointerEvent& press) { return tool_of_layer(press); });
  pointed_at_.reset();
  for (const auto& layer : layers_) layer->leave({editor_, scene_});
  if (!tool_active()) hover(now.pixel, hovered);
}

std::optional<std::unique_ptr<Tool>> Viewport::tool_of_layer(const PointerEvent& press) {
  for (const auto& layer : layers_)
    if (auto answer = layer->press({editor_, scene_}, press)) return answer;
  return {};
}

void Viewport::hover(const Vector2& pixel, bool inside) {
  editor_.hovered.reset();
  if (!inside) return;
  const ToolContext context{editor_, scene_};
  pointed_at_ = surface_point(scene_, context.projector().ray(pixel));
  for (const auto& layer : layers_)
    if (layer->hover(context, pixel)) return;
  const auto under = elements_under(context, pixel);
  if (!under.empty()) editor_.hovered = under.front();
}

double Viewport::next_frame_in() const {
  if (!editor_.has_document) return -1;
  if (editor_.flying() || (selection_size_.unfinished() && !editor_.history.in_gesture())) return 0;
  return pictures_.next_frame_in(editor_, tool_active());
}

std::string Viewport::hint() const {
  if (tool_active()) return tools_.running()->hint(editor_.language);
  const Language& tr = editor_.language;
  for (const auto& layer : layers_)
    if (const char* hint = layer->hint()) return tr(hint);
  if (editor_.hovered) return tr("Click selects   Shift adds   Ctrl removes   drag moves");
  const std::size_t objects = editor_.selection.objects().size();
  const std::string selected = editor_.mode == ElementMode::object && objects > 0
                                   ? tr.counted(objects, "{0} object", "{0} objects")
                                   : describe_in(editor_.has_document ? editor_.active_object() : nullptr,
                                                 editor_.selection.of_active(), editor_.language);
  const bool parallel = editor_.camera().orthographic;
  const std::string size = selection_size_.text().empty() ? "" : "   " + selection_size_.text();
  return selected + size + "   |   " + tr(navigation_hint(editor_.settings.navigation, parallel));
}

}  // namespace hariko
