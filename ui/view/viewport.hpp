#pragma once

// Viewport: shows the views, with what stands over them, and gives pointer events to tools.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/editor/scene_builder.hpp"
#include "ui/editor/selection_size.hpp"
#include "ui/view/patch_jumps.hpp"
#include "ui/view/pointer_tools.hpp"
#include "ui/view/view_layer.hpp"
#include "ui/view/view_panes.hpp"
#include "ui/view/view_pictures.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class Viewport {
 public:
  /// `quick_samples`: the most samples a pixel while something moves (1 on software renderers, 4 otherwise).
  /// `layers`: what stands over the pictures; the first lies above the others.
  Viewport(Editor& editor, Renderer& renderer, int quick_samples,
           std::vector<std::unique_ptr<ViewLayer>> layers)
      : editor_(editor),
        pictures_(renderer, quick_samples),
        tools_(editor, scene_),
        panes_(editor),
        layers_(std::move(layers)) {}
  Viewport(const Viewport&) = delete;
  Viewport& operator=(const Viewport&) = delete;

  /// Handles the pointer, redraws the pictures that changed, and shows them.
  void draw(PanelContext& context, const PanelRect& rect);

  bool tool_active() const { return tools_.running() != nullptr; }
  /// Starts a tool from a command (see Tool::modal). Cancels a running one.
  void start_modal(std::unique_ptr<Tool> tool) { tools_.start_modal(std::move(tool)); }
  /// Gives a key to the running tool. True when the tool took it.
  bool tool_key(const KeyPress& press) { return tools_.key(press); }
  /// Ends the active tool as if it had never begun. False when there is none.
  bool cancel_tool() { return tools_.cancel(); }
  /// Hints on what the pointer can do now, or what the running tool says.
  std::string hint() const;
  const SceneBuilder& scene() const { return scene_; }
  /// The point of a surface under the pointer, where no tool runs.
  const std::optional<SurfacePoint>& pointed_at() const { return pointed_at_; }
  /// Seconds until a picture wants another frame without any event; negative when none does.
  double next_frame_in() const;
  /// Milliseconds that OpenGL took for the pictures of the last frame; measured while the overlay shows.
  double picture_milliseconds() const { return pictures_.milliseconds(); }
  std::uint64_t pictures_drawn() const { return pictures_.drawn(); }
  /// Place of the active view, in window pixels: tools and commands act there.
  const PanelRect& rect() const { return panes_.rect(); }

 private:
  using Place = ViewPanes::Place;
  void frame_views();
  void gizmo_button(PanelContext& context, Place& place);
  void show(PanelContext& context, const Place& place);
  void draw_over(PanelContext& context, const Place& place, const Camera& camera);
  void handle_pointer(bool hovered);
  void update_layers();
  std::optional<std::unique_ptr<Tool>> tool_of_layer(const PointerEvent& press);
  void hover(const Vector2& pixel, bool inside);

  Editor& editor_;
  ViewPictures pictures_;
  SceneBuilder scene_;
  PointerTools tools_;
  ViewPanes panes_;
  PatchJumps jumps_;
  std::vector<std::unique_ptr<ViewLayer>> layers_;  ///< from above
  std::optional<SurfacePoint> pointed_at_;
  SelectionSize selection_size_;
};

}  // namespace hariko
