#pragma once

// Tools: what the pointer does in the viewport. Small classes that live from a press to its end.

#include <memory>
#include <optional>
#include <string>

#include "render/camera.hpp"
#include "render/picking.hpp"
#include "ui/editor.hpp"
#include "ui/scene_builder.hpp"

namespace hariko {

enum class PointerButton { left, middle, right };

struct PointerEvent {
  enum class Kind { press, move, release };
  Kind kind = Kind::move;
  PointerButton button = PointerButton::left;
  Vector2 pixel = Vector2::Zero();  ///< framebuffer pixels from the viewport's upper left corner
  bool shift = false, control = false, alt = false;
};

/// What a tool may look at and change.
struct ToolContext {
  Editor& editor;
  const SceneBuilder& scene;

  Projector projector() const { return {editor.camera(), editor.viewport}; }
};

enum class ToolState { stay, commit, cancel };

class Tool {
 public:
  virtual ~Tool() = default;
  /// The press that chose the tool.
  virtual void begin(ToolContext& context, const PointerEvent& press) = 0;
  /// Moves and the release. `commit` and `cancel` end the tool; it has done its work then.
  virtual ToolState update(ToolContext& context, const PointerEvent& event) = 0;
  /// Esc, or the window lost the pointer: everything is as it was before `begin`.
  virtual void cancel(ToolContext& context) = 0;
  /// For the status line.
  virtual std::string hint() const = 0;
  /// The tool that takes over at once after `commit`; it gets the same press and then the present move.
  virtual std::unique_ptr<Tool> successor() { return nullptr; }
};

/// Pixels that the pointer must move before a press becomes a drag.
inline constexpr double drag_threshold = 3;

/// What a click would take, by the element mode.
std::optional<PickHit> pick_element(const ToolContext& context, const Vector2& pixel);

std::unique_ptr<Tool> make_select_tool();
std::unique_ptr<Tool> make_move_tool();
std::unique_ptr<Tool> make_orbit_tool();
std::unique_ptr<Tool> make_pan_tool();

/// The tool for a press: left selects and drags, middle or right or Alt+left orbits, Shift with these pans.
std::unique_ptr<Tool> tool_for(const PointerEvent& press);

/// One step of the wheel towards the pixel; negative steps back.
void zoom_at(Editor& editor, double steps, const Vector2& pixel);

}  // namespace hariko
