#pragma once

// Tools: what the pointer and the keys do in the viewport. Small classes that live from a press, or from the
// command that started them, to their end.

#include <memory>
#include <optional>
#include <string>

#include "render/camera.hpp"
#include "render/picking.hpp"
#include "ui/base/theme.hpp"
#include "ui/editor/command_table.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/scene_builder.hpp"

namespace hariko {

enum class PointerButton { left, middle, right };

struct PointerEvent {
  enum class Kind { press, move, release };
  Kind kind = Kind::move;
  PointerButton button = PointerButton::left;
  Vector2 pixel = Vector2::Zero();  ///< framebuffer pixels from the viewport's upper left corner
  bool shift = false, control = false, alt = false;
  int clicks = 1;  ///< count of a press: 2 for the second of a double click

  /// The left button without modifiers: with them a press is for the selection or for the view.
  bool plain_left() const { return button == PointerButton::left && !shift && !control && !alt; }
};

/// Context of a tool: what it may look at and change.
struct ToolContext {
  Editor& editor;
  const SceneBuilder& scene;

  Projector projector() const { return {editor.camera(), editor.viewport}; }
};

enum class ToolState { stay, commit, cancel };

/// Answer of a tool to a key that it does not use: letters would run commands in the middle of the gesture,
/// others go on to what else takes them.
inline std::optional<ToolState> unused_key(const KeyPress& press) {
  if (press.chord.control || press.chord.alt || press.text == 0) return std::nullopt;
  return ToolState::stay;
}

/// Overlay on the picture that a tool draws: ImGui's list and the viewport's upper left corner in window
/// pixels.
struct ToolOverlay {
  ImDrawList& list;
  ImVec2 corner;
  const Metrics& metrics;
};

/// A tool is held (from a press to the release of the same button) or modal (moves come without a button,
/// left presses and releases are passed on, a right press cancels; the view can be turned and zoomed
/// meanwhile).
class Tool {
 public:
  virtual ~Tool() = default;
  virtual bool modal() const { return false; }
  /// The press that chose the tool; for modal tools a move to where the pointer is.
  virtual void begin(ToolContext& context, const PointerEvent& press) = 0;
  /// Moves, presses and the release. `commit` and `cancel` end the tool; it has done its work then.
  virtual ToolState update(ToolContext& context, const PointerEvent& event) = 0;
  /// A key while the tool runs; nothing when it is none of the tool's. Esc never comes here: it cancels.
  virtual std::optional<ToolState> key(ToolContext&, const KeyPress&) { return {}; }
  /// The wheel over the viewport; false when it is to zoom.
  virtual bool wheel(ToolContext&, double /*steps*/, const PointerEvent&) { return false; }
  /// Draws over the picture: the value that is dragged, a rectangle, a gizmo.
  virtual void draw(const ToolContext&, const ToolOverlay&) const {}
  /// Esc, or the window lost the pointer: everything is as it was before `begin`, without the preview.
  virtual void cancel(ToolContext& context) { context.editor.cancel_preview(); }
  /// For the status line: the value and the tool's keys.
  virtual std::string hint(const Language& tr) const = 0;
  /// The tool that takes over at once after `commit`; it gets the same press and then the present move.
  virtual std::unique_ptr<Tool> successor() { return nullptr; }
};

/// Design pixels (`Editor::pixel_scale`) that the pointer must move before a press becomes a drag.
inline constexpr double drag_threshold = 3;

/// Element that a click would take, by the element mode; in object mode the front-most face or edge.
std::optional<PickHit> pick_element(const ToolContext& context, const Vector2& pixel);
/// All that a click could take, nearest first.
std::vector<ElementRef> elements_under(const ToolContext& context, const Vector2& pixel);

std::unique_ptr<Tool> make_select_tool();
std::unique_ptr<Tool> make_orbit_tool();
std::unique_ptr<Tool> make_pan_tool();

/// For a press on the axis gizmo, with the side of the ball that it hit.
std::unique_ptr<Tool> make_axis_gizmo_tool(std::optional<StandardView> side);

/// The tool for a press: what the navigation preset of the settings says, else left selects and drags.
/// Nothing for presses without a meaning.
std::unique_ptr<Tool> tool_for(const Editor& editor, const PointerEvent& press);

/// Base of tools that say at the pointer why what was done last is refused.
class SpeakingTool : public Tool {
 protected:
  /// Says why, in English or as an error; the tool goes on.
  ToolState refuse(const ToolContext& context, const Phrase& why) {
    error_ = context.editor.language(why);
    return ToolState::stay;
  }
  ToolState refuse(const ToolContext& context, const Message& why) {
    error_ = context.editor.language.text_of(why);
    return ToolState::stay;
  }

  Vector2 pointer_ = Vector2::Zero();  ///< framebuffer pixels
  std::string error_;                  ///< in the language of the interface; empty while nothing is refused
};

/// Base of modal tools.
class ModalTool : public SpeakingTool {
 public:
  bool modal() const override { return true; }
};

/// Base of modal tools that find out what is under the pointer.
class PointingTool : public ModalTool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    look(context);
  }

 protected:
  /// Finds what is under `pointer_`.
  virtual void look(const ToolContext& context) = 0;
};

}  // namespace hariko
