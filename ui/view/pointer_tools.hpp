#pragma once

// PointerTools: the tool that runs in the active view. Presses choose it, pointer, keys and wheel are given
// to it, and the view is turned beside it.

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "ui/view/tool.hpp"

namespace hariko {

class PointerTools {
 public:
  /// Something that stands over the picture and answers a press first: nothing where the press is not for it,
  /// a null tool where it is done with the press.
  using Overhead = std::function<std::optional<std::unique_ptr<Tool>>(const PointerEvent& press)>;

  /// Both must outlive it.
  PointerTools(Editor& editor, const SceneBuilder& scene) : editor_(editor), scene_(scene) {}

  /// The running tool; null when none runs.
  const Tool* running() const { return tool_.get(); }
  /// Ends a tool whose document was changed under it. A press that has just come begins anew with the next
  /// `frame`: it took a typed number out of its field. Before anything looks at whether a tool runs.
  void end_stale_tool();
  /// Buttons, moves and wheel of a frame of ImGui. `now`: the pointer and the modifiers; `hovered`: whether
  /// nothing lies between the pointer and the view.
  void frame(PointerEvent now, bool hovered, const Overhead& overhead);
  void start(std::unique_ptr<Tool> tool, const PointerEvent& press);
  /// Starts a tool from a command (see Tool::modal). Cancels a running one.
  void start_modal(std::unique_ptr<Tool> tool);
  /// Gives a key to the running tool. True when the tool took it.
  bool key(const KeyPress& press);
  /// Ends the running tool as if it had never begun. False when there is none.
  bool cancel();

 private:
  void drive_modal(PointerEvent event, bool hovered);
  void drive_held(PointerEvent event);
  bool begin_navigation(PointerEvent event);
  void drive_navigation(PointerEvent event);
  void wheel(const PointerEvent& event);
  void look_for_press(PointerEvent event, const Overhead& overhead);
  /// True when what stands over the picture has the press.
  bool begin(const PointerEvent& press, const Overhead& overhead);
  bool has_news(const PointerEvent& event) const;
  void feed(const PointerEvent& event);
  void finish(ToolState state, const PointerEvent& last);

  Editor& editor_;
  const SceneBuilder& scene_;
  std::unique_ptr<Tool> tool_;
  std::pair<std::uint64_t, std::uint64_t> found_;  ///< the document that the tool knows
  bool shift_ = false, control_ = false;           ///< as the tool knows them
  PointerEvent press_;
  bool pressed_ = false;              ///< the tool began with a press in the last frame
  bool repeats_ = false;              ///< a press still to be answered, on another document
  std::unique_ptr<Tool> navigation_;  ///< turns the view while a modal tool waits
  PointerEvent navigation_press_;
  Vector2 pointer_ = Vector2::Constant(-1);
  double wheel_at_ = -1;  ///< time when the wheel was turned last
};

}  // namespace hariko
