#include "ui/viewport.hpp"

#include <algorithm>
#include <array>

namespace hariko {

namespace {

bool same(const Camera& a, const Camera& b) {
  return a.target == b.target && a.orientation.coeffs() == b.orientation.coeffs() &&
         a.distance == b.distance && a.field_of_view == b.field_of_view && a.orthographic == b.orthographic;
}

constexpr std::array buttons{PointerButton::left, PointerButton::right,
                             PointerButton::middle};  // as ImGui counts

std::size_t button_index(PointerButton button) {
  return static_cast<std::size_t>(std::find(buttons.begin(), buttons.end(), button) - buttons.begin());
}

}  // namespace

void Viewport::draw(PanelContext& context, const PanelRect& rect) {
  rect_ = rect;
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  editor_.viewport = {std::max(1, static_cast<int>(rect.width() * scale.x)),
                      std::max(1, static_cast<int>(rect.height() * scale.y))};
  if (editor_.wants_framing) editor_.frame_all(true);
  editor_.wants_framing = false;
  if (begin_panel("Viewport", rect, palette().window, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    ImGui::InvisibleButton("surface", {rect.width(), rect.height()},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    context.marks.item("viewport");
    scene_.update(editor_);  // hovering and clicking look at what is there now
    handle_pointer(ImGui::IsItemHovered());
    scene_.update(editor_);
    refresh();
    ImGui::GetWindowDrawList()->AddImage(
        // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui passes names of textures as pointers
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(renderer_.texture())), rect.min, rect.max,
        {0, 1}, {1, 0});
    draw_legend(context, rect);
    if (tool_) tool_->draw({editor_, scene_}, {*ImGui::GetWindowDrawList(), rect.min, context.metrics});
  }
  ImGui::End();
}

void Viewport::handle_pointer(bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vector2 pixel((io.MousePos.x - rect_.min.x) * io.DisplayFramebufferScale.x,
                      (io.MousePos.y - rect_.min.y) * io.DisplayFramebufferScale.y);
  PointerEvent event;
  event.pixel = pixel;
  event.shift = io.KeyShift;
  event.control = io.KeyCtrl;
  event.alt = io.KeyAlt;
  if (tool_ && tool_->modal())
    drive_modal(event, hovered);
  else if (tool_)
    drive_held(event);
  else if (hovered)
    look_for_press(event);
  if (hovered && io.MouseWheel != 0) {
    ToolContext context{editor_, scene_};
    const double steps = static_cast<double>(io.MouseWheel);
    if (!tool_ || !tool_->wheel(context, steps, event)) zoom_at(editor_, steps, pixel);
  }
  if (!tool_) hover(pixel, hovered);
  pointer_ = pixel;
}

void Viewport::look_for_press(PointerEvent event) {
  event.kind = PointerEvent::Kind::press;
  for (std::size_t i = 0; i < buttons.size() && !tool_; ++i) {
    event.clicks = ImGui::GetMouseClickedCount(static_cast<int>(i));
    if (event.clicks == 0) continue;
    event.button = buttons[i];
    start(tool_for(event), event);
  }
}

void Viewport::drive_held(PointerEvent event) {
  event.button = press_.button;
  if (event.pixel != pointer_) {
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
  if (event.pixel != pointer_) {
    event.kind = PointerEvent::Kind::move;
    feed(event);
  }
  if (tool_ && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    cancel_tool();
  } else if (tool_ && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) {
    event.kind = PointerEvent::Kind::press;
    event.button = PointerButton::middle;
    navigation_press_ = event;
    navigation_ = tool_for(event);
    ToolContext context{editor_, scene_};
    navigation_->begin(context, event);
  } else if (tool_ && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    event.kind = PointerEvent::Kind::press;
    event.clicks = ImGui::GetMouseClickedCount(ImGuiMouseButton_Left);
    feed(event);
  } else if (tool_ && ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    event.kind = PointerEvent::Kind::release;
    feed(event);
  }
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
  press_ = press;
  editor_.hovered.reset();
  ToolContext context{editor_, scene_};
  tool_->begin(context, press);
}

void Viewport::feed(const PointerEvent& event) {
  ToolContext context{editor_, scene_};
  finish(tool_->update(context, event), event);
}

void Viewport::finish(ToolState state, const PointerEvent& last) {
  if (state == ToolState::stay) return;
  navigation_.reset();
  const std::unique_ptr<Tool> done = std::move(tool_);
  auto next = state == ToolState::commit ? done->successor() : nullptr;
  if (!next) return;
  start(std::move(next), press_);
  feed(last);
}

void Viewport::start_modal(std::unique_ptr<Tool> tool) {
  cancel_tool();
  PointerEvent at;
  at.pixel = pointer_;
  start(std::move(tool), at);
}

bool Viewport::tool_key(const KeyPress& press) {
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
  return true;
}

void Viewport::hover(const Vector2& pixel, bool inside) {
  if (!inside) {
    editor_.hovered.reset();
    return;
  }
  const ToolContext context{editor_, scene_};
  const auto hit = pick_element(context, pixel);
  editor_.hovered.reset();
  if (hit)
    editor_.hovered = element_at(editor_.document(), scene_.object_id(hit->object), hit->kind, hit->index);
}

void Viewport::refresh() {
  const Camera camera = editor_.camera();
  const bool changed = pictures_ == 0 || scene_.version() != drawn_version_ || !same(camera, drawn_camera_) ||
                       editor_.viewport != drawn_size_;
  if (changed) changed_at_ = editor_.now;
  const bool moving = tool_ || editor_.flying() || editor_.now - changed_at_ < rest_seconds;
  const int samples = moving && pictures_ > 0 ? quick_samples_ : 4;
  if (!changed && samples <= drawn_samples_) return;
  const auto drawn = renderer_.draw(scene_.scene(), camera, {editor_.viewport, samples});
  if (!drawn.ok()) editor_.notify(drawn.error());
  drawn_version_ = scene_.version();
  drawn_camera_ = camera;
  drawn_size_ = editor_.viewport;
  drawn_samples_ = samples;
  ++pictures_;
}

double Viewport::next_frame_in() const {
  if (!editor_.has_document) return -1;
  if (editor_.flying()) return 0;
  if (drawn_samples_ >= 4 || tool_) return -1;
  return std::max(0.0, changed_at_ + rest_seconds - editor_.now);
}

std::string Viewport::hint() const {
  if (tool_) return tool_->hint(editor_.language);
  if (editor_.hovered) return "Click selects   Shift adds   Ctrl removes   drag moves";
  return describe(editor_.selection.of_active()) + "   |   middle drag orbits   Shift pans   wheel zooms";
}

}  // namespace hariko
