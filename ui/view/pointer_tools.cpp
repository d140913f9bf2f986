#include "ui/view/pointer_tools.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/view/navigation.hpp"

namespace hariko {

namespace {

constexpr std::array buttons{PointerButton::left, PointerButton::right,
                             PointerButton::middle};  // as ImGui counts

/// Another one for every document that the editor can have.
std::pair<std::uint64_t, std::uint64_t> name_of_document(const Editor& editor) {
  return {editor.documents, editor.history.serial()};
}

std::size_t button_index(PointerButton button) {
  return static_cast<std::size_t>(std::find(buttons.begin(), buttons.end(), button) - buttons.begin());
}

}  // namespace

void PointerTools::frame(PointerEvent now, bool hovered, const Overhead& overhead) {
  end_stale_tool();
  pressed_ = false;
  if (std::exchange(repeats_, false) && hovered) begin(PointerEvent(press_), overhead);
  if (tool_ && tool_->modal())
    drive_modal(now, hovered);
  else if (tool_)
    drive_held(now);
  else if (hovered)
    look_for_press(now, overhead);
  const ImGuiIO& io = ImGui::GetIO();
  if (hovered && (io.MouseWheel != 0 || io.MouseWheelH != 0)) wheel(now);
  pointer_ = now.pixel;
  shift_ = now.shift;
  control_ = now.control;
}

void PointerTools::wheel(const PointerEvent& event) {
  const ImGuiIO& io = ImGui::GetIO();
  ToolContext context{editor_, scene_};
  const Vector2 steps{double(io.MouseWheelH), double(io.MouseWheel)};
  if (tool_ && tool_->wheel(context, steps.y(), event)) {
    found_ = name_of_document(editor_);
    return;
  }
  editor_.layout.activate(editor_.layout.active());
  constexpr double pause = 0.7;  // seconds that separate two steps to go back from
  turn_wheel(context, {steps, event.pixel, event.shift, event.control}, editor_.now - wheel_at_ > pause);
  wheel_at_ = editor_.now;
}

void PointerTools::look_for_press(PointerEvent event, const Overhead& overhead) {
  event.kind = PointerEvent::Kind::press;
  for (std::size_t i = 0; i < buttons.size() && !tool_; ++i) {
    event.clicks = ImGui::GetMouseClickedCount(static_cast<int>(i));
    if (event.clicks == 0) continue;
    editor_.layout.activate(editor_.layout.active());  // something is done there
    event.button = buttons[i];
    if (begin(event, overhead)) return;
  }
}

bool PointerTools::begin(const PointerEvent& press, const Overhead& overhead) {
  std::optional<std::unique_ptr<Tool>> over = overhead(press);
  std::unique_ptr<Tool> tool = over ? std::move(*over) : tool_for(editor_, press);
  if (tool) start(std::move(tool), press);
  pressed_ = tool_ && !tool_->modal();
  return over.has_value();
}

/// A modifier alone changes what a tool shows, too.
bool PointerTools::has_news(const PointerEvent& event) const {
  return event.pixel != pointer_ || event.shift != shift_ || event.control != control_;
}

void PointerTools::drive_held(PointerEvent event) {
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

void PointerTools::drive_modal(PointerEvent event, bool hovered) {
  if (navigation_) return drive_navigation(event);
  if (has_news(event)) {
    event.kind = PointerEvent::Kind::move;
    feed(event);
  }
  // The right button alone cancels, whatever else it does when no tool runs.
  if (tool_ && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && !event.alt) {
    cancel();
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

bool PointerTools::begin_navigation(PointerEvent event) {
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

void PointerTools::drive_navigation(PointerEvent event) {
  const bool down = ImGui::GetIO().MouseDown[button_index(navigation_press_.button)];
  event.kind = down ? PointerEvent::Kind::move : PointerEvent::Kind::release;
  event.button = navigation_press_.button;
  ToolContext context{editor_, scene_};
  if (navigation_->update(context, event) != ToolState::stay) navigation_.reset();
}

void PointerTools::start(std::unique_ptr<Tool> tool, const PointerEvent& press) {
  tool_ = std::move(tool);
  found_ = name_of_document(editor_);
  press_ = press;
  editor_.hovered.reset();
  ToolContext context{editor_, scene_};
  tool_->begin(context, press);
}

void PointerTools::feed(const PointerEvent& event) {
  ToolContext context{editor_, scene_};
  finish(tool_->update(context, event), event);
}

/// A tool works on the document that it found. What came in between, as a step that the list of steps went to
/// or work that was done meanwhile, is not for it.
void PointerTools::end_stale_tool() {
  if (!tool_ || found_ == name_of_document(editor_)) return;
  cancel();
  repeats_ = pressed_;
}

void PointerTools::finish(ToolState state, const PointerEvent& last) {
  found_ = name_of_document(editor_);
  if (state == ToolState::stay) return;
  navigation_.reset();
  const std::unique_ptr<Tool> done = std::move(tool_);
  auto next = state == ToolState::commit ? done->successor() : nullptr;
  if (!next) return;
  start(std::move(next), done->modal() ? last : press_);
  feed(last);
}

void PointerTools::start_modal(std::unique_ptr<Tool> tool) {
  cancel();
  PointerEvent at;
  at.pixel = pointer_;
  start(std::move(tool), at);
}

bool PointerTools::key(const KeyPress& press) {
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

bool PointerTools::cancel() {
  if (!tool_) return false;
  ToolContext context{editor_, scene_};
  navigation_.reset();
  tool_->cancel(context);
  tool_.reset();
  // The tool may put back a selection of the document that it found.
  editor_.selection.prune(editor_.history.current());
  return true;
}

}  // namespace hariko
