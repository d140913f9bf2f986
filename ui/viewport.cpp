#include "ui/viewport.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/panels/axis_gizmo.hpp"
#include "ui/panels/gauss_panel.hpp"
#include "ui/panels/legend.hpp"
#include "ui/panels/mesh_overlay.hpp"
#include "ui/panels/view_frame.hpp"
#include "ui/selection_text.hpp"
#include "ui/tools/navigation.hpp"
#include "ui/tools/skin_tool.hpp"

namespace hariko {

namespace {

constexpr std::array buttons{PointerButton::left, PointerButton::right,
                             PointerButton::middle};   // as ImGui counts
constexpr float gizmo_radius = 44, gizmo_margin = 12;  // design pixels
constexpr float gap = 2;                               // between views

bool holds(const PanelRect& rect, ImVec2 point) {
  return point.x >= rect.min.x && point.x < rect.max.x && point.y >= rect.min.y && point.y < rect.max.y;
}

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

/// Another one for every document that the editor can have.
std::pair<std::uint64_t, std::uint64_t> name_of_document(const Editor& editor) {
  return {editor.documents, editor.history.serial()};
}

std::size_t button_index(PointerButton button) {
  return static_cast<std::size_t>(std::find(buttons.begin(), buttons.end(), button) - buttons.begin());
}

}  // namespace

void Viewport::draw(PanelContext& context, const PanelRect& rect) {
  // Compared pictures are seen from the same place.
  if (editor_.meshing.comparing()) editor_.layout.views.fill(View(editor_.layout.active_view()));
  place_views(rect);
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  editor_.pixel_scale = double(context.metrics.scale) * double(scale.x);
  for (const Place& place : places_) {
    View& view = editor_.layout.views[static_cast<std::size_t>(place.view)];
    if (!view.wants_framing && !editor_.wants_framing) continue;
    editor_.frame_at_once(place.view, size_of(place));
    view.wants_framing = false;
  }
  if (editor_.wants_framing)
    for (int i = 0; i < ViewLayout::count; ++i)
      editor_.layout.views[static_cast<std::size_t>(i)].wants_framing = !editor_.layout.shows(i);
  editor_.wants_framing = false;

  if (begin_panel("Viewport", rect, palette().window, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    // What lies over the pictures comes first: ImGui gives the pointer to the first of overlapping items.
    drag_splitter(context, rect);
    for (Place& place : places_) {
      place.title_hovered = view_title_button(context, place.view, place.rect);
      gizmo_button(context, place);
    }
    ImGui::SetCursorScreenPos(rect.min);
    ImGui::InvisibleButton("surface", {rect.width(), rect.height()},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    context.marks.item("viewport");
    const bool hovered = ImGui::IsItemHovered();
    activate_under_pointer(rect);
    scene_.update(editor_);  // hovering and clicking look at what is there now
    gizmo_.update(editor_, tool_ != nullptr);
    arrows_.update(editor_);
    handle_pointer(hovered);
    // A title or a tool may have arranged the views anew.
    place_views(rect);
    scene_.update(editor_);
    std::vector<ViewPictures::Shown> shown;
    for (const Place& place : places_) shown.push_back({place.view, size_of(place)});
    gizmo_.update(editor_, tool_ != nullptr);
    jumps_.update(editor_);
    pictures_.update(editor_, scene_, shown, tool_ != nullptr, jumps_.count());
    for (const Place& place : places_) show(context, place);
    draw_legend(context, rect, scene_);
  }
  ImGui::End();
}

void Viewport::place_views(const PanelRect& rect) {
  std::vector<Place> before = std::move(places_);
  places_.clear();
  for (const Pane& pane : editor_.layout.panes()) {
    Place place;
    place.view = pane.view;
    const auto at = [&](float x, float y) {
      return ImVec2(std::round(rect.min.x + x * rect.width()), std::round(rect.min.y + y * rect.height()));
    };
    place.rect = {at(pane.left, pane.top), at(pane.right, pane.bottom)};
    if (pane.left > 0) place.rect.min.x += gap / 2;
    if (pane.top > 0) place.rect.min.y += gap / 2;
    if (pane.right < 1) place.rect.max.x -= gap / 2;
    if (pane.bottom < 1) place.rect.max.y -= gap / 2;
    for (const Place& old : before) {
      if (old.view != place.view) continue;
      place.title_hovered = old.title_hovered;
      place.gizmo_hovered = old.gizmo_hovered;
    }
    places_.push_back(place);
  }
  rect_ = active_place().rect;
  editor_.viewport = size_of(active_place());
}

const Viewport::Place& Viewport::active_place() const {
  const auto found = std::find_if(places_.begin(), places_.end(),
                                  [&](const Place& place) { return place.view == editor_.layout.active(); });
  return found == places_.end() ? places_.front() : *found;
}

PixelSize Viewport::size_of(const Place& place) const {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {std::max(1, static_cast<int>(place.rect.width() * scale.x)),
          std::max(1, static_cast<int>(place.rect.height() * scale.y))};
}

Vector2 Viewport::pixel_at(ImVec2 point) const {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {double((point.x - rect_.min.x) * scale.x), double((point.y - rect_.min.y) * scale.y)};
}

/// The view under the pointer is the active one, unless something is being dragged. A pointer that only
/// crosses a view on its way to a menu leaves the one active that was worked in.
void Viewport::activate_under_pointer(const PanelRect& rect) {
  bool pressed = false;
  if (tool_ || ImGui::IsAnyMouseDown()) {
    // The press itself comes with a pointer that may have jumped here since the last frame.
    pressed = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    if (tool_ || !pressed) return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  ViewLayout& layout = editor_.layout;
  if (!ImGui::IsWindowHovered() && holds(rect, mouse)) return;  // under a menu or a dialog
  layout.point_at({});
  for (const Place& place : places_) {
    if (!holds(place.rect, mouse)) continue;
    layout.point_at(place.view);
    if (pressed) layout.activate(place.view);
  }
  rect_ = active_place().rect;
  editor_.viewport = size_of(active_place());
}

void Viewport::drag_splitter(PanelContext& context, const PanelRect& rect) {
  ViewLayout& layout = editor_.layout;
  if (layout.arrangement() == Arrangement::one) return;
  const bool four = layout.arrangement() == Arrangement::four;
  const float x = rect.min.x + layout.split_x * rect.width(), y = rect.min.y + layout.split_y * rect.height();
  const float thick = context.metrics.px(4), middle = context.metrics.px(9);
  const auto bar = [&](const char* name, ImVec2 min, ImVec2 max, bool moves_x, bool moves_y,
                       ImGuiMouseCursor cursor) {
    ImGui::SetCursorScreenPos(min);
    ImGui::InvisibleButton(name, {max.x - min.x, max.y - min.y});
    context.marks.item(name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(cursor);
    if (!ImGui::IsItemActive()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto fraction = [](float value) {
      return std::clamp(value, ViewLayout::least_split, 1 - ViewLayout::least_split);
    };
    if (moves_x) layout.split_x = fraction((mouse.x - rect.min.x) / rect.width());
    if (moves_y) layout.split_y = fraction((mouse.y - rect.min.y) / rect.height());
  };
  if (four)
    bar("splitter.middle", {x - middle, y - middle}, {x + middle, y + middle}, true, true,
        ImGuiMouseCursor_ResizeAll);
  bar("splitter.x", {x - thick, rect.min.y}, {x + thick, rect.max.y}, true, false, ImGuiMouseCursor_ResizeEW);
  if (four)
    bar("splitter.y", {rect.min.x, y - thick}, {rect.max.x, y + thick}, false, true,
        ImGuiMouseCursor_ResizeNS);
  if (layout.arrangement() != Arrangement::one) place_views(rect);
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
  if (tool_ || !gizmo.holds(mouse)) return;
  const float inset = 2 * radius + context.metrics.px(gizmo_margin);
  ImGui::SetCursorScreenPos({place.rect.max.x - inset, place.rect.min.y + context.metrics.px(gizmo_margin)});
  ImGui::InvisibleButton(name.c_str(), {2 * radius, 2 * radius});
  place.gizmo_hovered = ImGui::IsItemHovered();
  if (!ImGui::IsItemClicked(ImGuiMouseButton_Left)) return;
  editor_.layout.activate(place.view);
  rect_ = place.rect;
  editor_.viewport = size_of(place);
  PointerEvent press;
  press.kind = PointerEvent::Kind::press;
  press.pixel = pixel_at(mouse);
  start(make_axis_gizmo_tool(gizmo.side_at(mouse)), press);
}

void Viewport::show(PanelContext& context, const Place& place) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Camera camera = editor_.layout.views[static_cast<std::size_t>(place.view)].camera(editor_.now);
  context.marks.rect("view." + std::to_string(place.view), place.rect.min, place.rect.max);
  list.PushClipRect(place.rect.min, place.rect.max, true);
  const auto picture = [&](unsigned texture, float opacity) {
    list.AddImage(
        // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui passes names of textures as pointers
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), place.rect.min, place.rect.max,
        {0, 1}, {1, 0}, with_alpha(IM_COL32_WHITE, opacity));
  };
  const double share = pictures_.shown_share(place.view, editor_.now);
  if (share < 1) picture(pictures_.faded_texture(place.view), 1);
  picture(pictures_.texture(place.view), static_cast<float>(share));
  const bool active = place.view == editor_.layout.active();
  draw_scale_bar(context, camera, place.rect);
  draw_grid_labels(context, camera, place.rect, scene_.scene().grid);
  if (!editor_.view.surfaces_only) draw_tension_numbers(context, place.rect, camera, scene_.scene());
  const ToolOverlay overlay{list, place.rect.min, context.metrics};
  const bool free = active && !tool_ && holds(place.rect, ImGui::GetIO().MousePos);
  const bool bare = editor_.view.surfaces_only;
  if (!bare)
    skin_overlay_.draw(editor_, Projector(camera, size_of(place)), overlay,
                       free ? std::optional(pixel_at(ImGui::GetIO().MousePos)) : std::nullopt,
                       active ? &context.marks : nullptr);
  if (gauss_)
    draw_gauss_overlay(editor_, *gauss_, Projector(camera, size_of(place)), list, place.rect.min,
                       context.metrics);
  if (tool_ && active) tool_->draw({editor_, scene_}, overlay);
  if (active) {
    arrows_.draw(overlay, hot_arrow_);
    arrows_.mark(context.marks, overlay);
    gizmo_.draw(overlay, hot_handle_);
    gizmo_.mark(context.marks, overlay);
  }
  if (gizmo_size(context.metrics, place.rect) > 0) {
    const auto pointer = place.gizmo_hovered ? std::optional(ImGui::GetIO().MousePos) : std::nullopt;
    gizmo_of(context.metrics, place.rect, camera).draw(list, pointer, place.gizmo_hovered);
  }
  draw_mesh_overlay(context, camera, size_of(place), place.rect, static_cast<std::size_t>(place.view));
  if (active) draw_probe(context, camera, size_of(place), place.rect, pointed_at_);
  if (active) draw_frame_overlay(context, place.rect);
  draw_view_title(context, place.view, place.rect, place.title_hovered);
  if (active && places_.size() > 1)
    list.AddRect(place.rect.min, place.rect.max,
                 (palette().secondary & 0x00ffffff) | (0xb0U << IM_COL32_A_SHIFT), 0, 0,
                 context.metrics.px(1));
  list.PopClipRect();
}

void Viewport::handle_pointer(bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vector2 pixel = pixel_at(io.MousePos);
  PointerEvent event;
  event.pixel = pixel;
  event.shift = io.KeyShift;
  event.control = io.KeyCtrl;
  event.alt = io.KeyAlt;
  end_stale_tool();
  if (tool_ && tool_->modal())
    drive_modal(event, hovered);
  else if (tool_)
    drive_held(event);
  else if (hovered)
    look_for_press(event);
  if (hovered && (io.MouseWheel != 0 || io.MouseWheelH != 0)) wheel(event);
  pointed_at_.reset();
  if (!tool_) hover(pixel, hovered);
  pointer_ = pixel;
  shift_ = event.shift;
  control_ = event.control;
}

void Viewport::wheel(const PointerEvent& event) {
  const ImGuiIO& io = ImGui::GetIO();
  ToolContext context{editor_, scene_};
  const Vector2 steps{double(io.MouseWheelH), double(io.MouseWheel)};
  if (tool_ && tool_->wheel(context, steps.y(), event)) {
    tool_found_ = name_of_document(editor_);
    return;
  }
  editor_.layout.activate(editor_.layout.active());
  constexpr double pause = 0.7;  // seconds that separate two steps to go back from
  turn_wheel(context, {steps, event.pixel, event.shift, event.control}, editor_.now - wheel_at_ > pause);
  wheel_at_ = editor_.now;
}

void Viewport::look_for_press(PointerEvent event) {
  event.kind = PointerEvent::Kind::press;
  for (std::size_t i = 0; i < buttons.size() && !tool_; ++i) {
    event.clicks = ImGui::GetMouseClickedCount(static_cast<int>(i));
    if (event.clicks == 0) continue;
    editor_.layout.activate(editor_.layout.active());  // something is done there
    event.button = buttons[i];
    if (scene_.paper() && event.button == PointerButton::left && editor_.paper.hovered.facet != no_index &&
        !navigation_of(editor_, event)) {
      editor_.paper.selected = editor_.paper.hovered.facet;
      return;
    }
    // With modifiers the press is for the selection or for the view.
    const bool plain = event.button == PointerButton::left && !event.shift && !event.control && !event.alt;
    const auto handle = plain ? gizmo_.hit(event.pixel) : std::nullopt;
    const auto arrow = plain && !handle ? arrows_.hit(event.pixel) : std::nullopt;
    auto tool = handle  ? make_transform_tool(handle->kind, DrivenBy::handle, handle->lock)
                : arrow ? make_normal_tool(editor_.selection.active, *arrow)
                : editor_.view.surfaces_only ? nullptr
                                             : skin_tool_at({editor_, scene_}, event);
    if (!tool) tool = tool_for(editor_, event);
    if (tool) start(std::move(tool), event);
  }
}

/// A modifier alone changes what a tool shows, too.
bool Viewport::has_news(const PointerEvent& event) const {
  return event.pixel != pointer_ || event.shift != shift_ || event.control != control_;
}

void Viewport::drive_held(PointerEvent event) {
  event.button = press_.button;
  if (has_news(event)) {
    event.kind = PointerEvent::Kind::move;
    feed(event);
  }
  if (tool_ && !tool_->modal() && !ImGui::GetIO().MouseDown[button_index(press_.button)]) {
    event.kind = PointerEvent::Kind::release;
    feed(event);
  }
}

void Viewport::drive_modal(PointerEvent event, bool hovered) {
  if (navigation_) return drive_navigation(event);
  if (has_news(event)) {
    event.kind = PointerEvent::Kind::move;
    feed(event);
  }
  // The right button alone cancels, whatever else it does when no tool runs.
  if (tool_ && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && !event.alt) {
    cancel_tool();
  } else if (tool_ && hovered && begin_navigation(event)) {
  } else if (tool_ && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    event.kind = PointerEvent::Kind::press;
    event.clicks = ImGui::GetMouseClickedCount(ImGuiMouseButton_Left);
    feed(event);
  } else if (tool_ && ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    event.kind = PointerEvent::Kind::release;
    feed(event);
  }
}

bool Viewport::begin_navigation(PointerEvent event) {
  event.kind = PointerEvent::Kind::press;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    event.button = buttons[i];
    if (!ImGui::IsMouseClicked(static_cast<int>(i)) || !navigation_of(editor_, event)) continue;
    navigation_press_ = event;
    navigation_ = tool_for(editor_, event);
    ToolContext context{editor_, scene_};
    navigation_->begin(context, event);
    return true;
  }
  return false;
}

void Viewport::drive_navigation(PointerEvent event) {
  const bool down = ImGui::GetIO().MouseDown[button_index(navigation_press_.button)];
  event.kind = down ? PointerEvent::Kind::move : PointerEvent::Kind::release;
  event.button = navigation_press_.button;
  ToolContext context{editor_, scene_};
  if (navigation_->update(context, event) != ToolState::stay) navigation_.reset();
}

void Viewport::start(std::unique_ptr<Tool> tool, const PointerEvent& press) {
  tool_ = std::move(tool);
  tool_found_ = name_of_document(editor_);
  press_ = press;
  hot_handle_.reset();
  hot_arrow_.reset();
  editor_.hovered.reset();
  ToolContext context{editor_, scene_};
  tool_->begin(context, press);
}

void Viewport::feed(const PointerEvent& event) {
  ToolContext context{editor_, scene_};
  finish(tool_->update(context, event), event);
}

/// A tool works on the document that it found. What came in between, as a step that the list of steps went to
/// or work that was done meanwhile, is not for it.
void Viewport::end_stale_tool() {
  if (tool_ && tool_found_ != name_of_document(editor_)) cancel_tool();
}

void Viewport::finish(ToolState state, const PointerEvent& last) {
  tool_found_ = name_of_document(editor_);
  if (state == ToolState::stay) return;
  navigation_.reset();
  const std::unique_ptr<Tool> done = std::move(tool_);
  auto next = state == ToolState::commit ? done->successor() : nullptr;
  if (!next) return;
  start(std::move(next), done->modal() ? last : press_);
  feed(last);
}

void Viewport::start_modal(std::unique_ptr<Tool> tool) {
  cancel_tool();
  PointerEvent at;
  at.pixel = pointer_;
  start(std::move(tool), at);
}

bool Viewport::tool_key(const KeyPress& press) {
  end_stale_tool();
  if (!tool_) return false;
  ToolContext context{editor_, scene_};
  const auto state = tool_->key(context, press);
  if (!state) return false;
  PointerEvent at;
  at.pixel = pointer_;
  finish(*state, at);
  return true;
}

bool Viewport::cancel_tool() {
  if (!tool_) return false;
  ToolContext context{editor_, scene_};
  navigation_.reset();
  tool_->cancel(context);
  tool_.reset();
  // What it puts back was selected in the document that it found.
  editor_.selection.prune(editor_.history.current());
  return true;
}

void Viewport::hover(const Vector2& pixel, bool inside) {
  hot_handle_.reset();
  hot_arrow_.reset();
  if (std::exchange(on_paper_, false)) editor_.paper.hovered = {};
  if (!inside) {
    editor_.hovered.reset();
    return;
  }
  hot_handle_ = gizmo_.hit(pixel);
  const ToolContext context{editor_, scene_};
  pointed_at_ = surface_point(scene_, context.projector().ray(pixel));
  if (!hot_handle_) hot_arrow_ = arrows_.hit(pixel);
  if (hot_handle_ || hot_arrow_) return editor_.hovered.reset();
  if (const PaperSolid* paper = scene_.paper()) {
    const Projector projector = context.projector();
    const double reach = 5 * editor_.pixel_scale * editor_.camera().pixel_length(editor_.viewport);
    editor_.paper.hovered = paper_under(*paper, projector.ray(pixel), reach);
    on_paper_ = true;
    return editor_.hovered.reset();
  }
  const auto under = elements_under(context, pixel);
  editor_.hovered.reset();
  if (!under.empty()) editor_.hovered = under.front();
}

double Viewport::next_frame_in() const {
  if (!editor_.has_document) return -1;
  if (editor_.flying()) return 0;
  return pictures_.next_frame_in(editor_, tool_ != nullptr);
}

std::string Viewport::hint() const {
  if (tool_) return tool_->hint(editor_.language);
  const Language& tr = editor_.language;
  if (hot_handle_) return tr("Drag the handle   click to type a number");
  if (hot_arrow_) return tr("Drag turns the normal   click selects the point");
  if (editor_.hovered) return tr("Click selects   Shift adds   Ctrl removes   drag moves");
  const std::size_t objects = editor_.selection.objects().size();
  const std::string selected =
      editor_.mode == ElementMode::object && objects > 0
          ? fill(tr(objects == 1 ? "{0} object" : "{0} objects"), {std::to_string(objects)})
          : describe_in(editor_.has_document ? editor_.active_object() : nullptr,
                        editor_.selection.of_active(), editor_.language);
  const bool parallel = editor_.camera().orthographic;
  return selected + "   |   " + tr(navigation_hint(editor_.settings.navigation, parallel));
}

}  // namespace hariko
