#pragma once

// Viewport: shows the scene and gives pointer events to tools.

#include <memory>
#include <string>

#include "render/renderer.hpp"
#include "ui/panels/panels.hpp"
#include "ui/scene_builder.hpp"
#include "ui/tools/tool.hpp"

namespace hariko {

class Viewport {
 public:
  /// `quick_samples`: samples a pixel while something moves (1 on software renderers, 4 otherwise).
  Viewport(Editor& editor, Renderer& renderer, int quick_samples)
      : editor_(editor), renderer_(renderer), quick_samples_(quick_samples) {}

  /// Handles the pointer, redraws the picture when it changed, and shows it.
  void draw(PanelContext& context, const PanelRect& rect);

  bool tool_active() const { return tool_ != nullptr; }
  /// Starts a tool from a command (see Tool::modal). Cancels a running one.
  void start_modal(std::unique_ptr<Tool> tool);
  /// Gives a key to the running tool. True when the tool took it.
  bool tool_key(const KeyPress& press);
  /// Ends the active tool as if it had never begun. False when there is none.
  bool cancel_tool();
  std::string hint() const;
  const SceneBuilder& scene() const { return scene_; }
  /// Seconds until the picture wants another frame without any event; negative when it does not.
  double next_frame_in() const;
  std::uint64_t pictures_drawn() const { return pictures_; }
  /// Where the viewport is, in window pixels.
  const PanelRect& rect() const { return rect_; }

 private:
  void handle_pointer(bool hovered);
  void drive_modal(PointerEvent event, bool hovered);
  void drive_held(PointerEvent event);
  void drive_navigation(PointerEvent event);
  void look_for_press(PointerEvent event);
  void feed(const PointerEvent& event);
  void finish(ToolState state, const PointerEvent& last);
  void start(std::unique_ptr<Tool> tool, const PointerEvent& press);
  void hover(const Vector2& pixel, bool inside);
  void refresh();

  Editor& editor_;
  Renderer& renderer_;
  int quick_samples_;
  SceneBuilder scene_;
  std::unique_ptr<Tool> tool_;
  PointerEvent press_;
  std::unique_ptr<Tool> navigation_;  ///< turns the view while a modal tool waits
  PointerEvent navigation_press_;
  Vector2 pointer_ = Vector2::Constant(-1);
  PanelRect rect_{};

  std::uint64_t drawn_version_ = 0, pictures_ = 0;
  Camera drawn_camera_;
  PixelSize drawn_size_;
  int drawn_samples_ = 0;
  double changed_at_ = 0;
  static constexpr double rest_seconds = 0.15;  ///< after which a still picture is drawn with all samples
};

}  // namespace hariko
