#pragma once

// Viewport: shows the views and gives pointer events to tools.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/gauss_view.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/skin_overlay.hpp"
#include "ui/patch_jumps.hpp"
#include "ui/scene_builder.hpp"
#include "ui/tools/gizmo.hpp"
#include "ui/tools/outline_handles.hpp"
#include "ui/tools/tool.hpp"
#include "ui/view_pictures.hpp"

namespace hariko {

class Viewport {
 public:
  /// `quick_samples`: samples a pixel while something moves (1 on software renderers, 4 otherwise).
  Viewport(Editor& editor, Renderer& renderer, int quick_samples)
      : editor_(editor), pictures_(renderer, quick_samples) {}

  /// What is pointed at on the Gauss sphere shows in the views, too. It must outlive the viewport.
  void link(const GaussView& gauss) { gauss_ = &gauss; }

  /// Handles the pointer, redraws the pictures that changed, and shows them.
  void draw(PanelContext& context, const PanelRect& rect);

  bool tool_active() const { return tool_ != nullptr; }
  /// Starts a tool from a command (see Tool::modal). Cancels a running one.
  void start_modal(std::unique_ptr<Tool> tool);
  /// Gives a key to the running tool. True when the tool took it.
  bool tool_key(const KeyPress& press);
  /// Ends the active tool as if it had never begun. False when there is none.
  bool cancel_tool();
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
  /// Where the active view is, in window pixels: tools and commands act there.
  const PanelRect& rect() const { return rect_; }

 private:
  struct Place {
    int view = 0;
    PanelRect rect;
    bool title_hovered = false;
    bool gizmo_hovered = false;
  };

  void place_views(const PanelRect& rect);
  void activate_under_pointer(const PanelRect& rect);
  void drag_splitter(PanelContext& context, const PanelRect& rect);
  void gizmo_button(PanelContext& context, Place& place);
  void show(PanelContext& context, const Place& place);
  const Place& active_place() const;
  PixelSize size_of(const Place& place) const;
  Vector2 pixel_at(ImVec2 point) const;

  void handle_pointer(bool hovered);
  void drive_modal(PointerEvent event, bool hovered);
  void drive_held(PointerEvent event);
  bool begin_navigation(PointerEvent event);
  void drive_navigation(PointerEvent event);
  void wheel(const PointerEvent& event);
  void look_for_press(PointerEvent event);
  bool has_news(const PointerEvent& event) const;
  void feed(const PointerEvent& event);
  void finish(ToolState state, const PointerEvent& last);
  void end_stale_tool();
  void start(std::unique_ptr<Tool> tool, const PointerEvent& press);
  void hover(const Vector2& pixel, bool inside);

  Editor& editor_;
  ViewPictures pictures_;
  SceneBuilder scene_;
  PatchJumps jumps_;
  std::unique_ptr<Tool> tool_;
  std::pair<std::uint64_t, std::uint64_t> tool_found_;  ///< the document that the tool knows
  Gizmo gizmo_;
  SkinOverlay skin_overlay_;
  const GaussView* gauss_ = nullptr;
  std::optional<GizmoHandle> hot_handle_;  ///< under the pointer
  OutlineHandles arrows_;
  std::optional<Index> hot_arrow_;        ///< under the pointer
  bool shift_ = false, control_ = false;  ///< as the tool knows them
  PointerEvent press_;
  std::unique_ptr<Tool> navigation_;  ///< turns the view while a modal tool waits
  PointerEvent navigation_press_;
  Vector2 pointer_ = Vector2::Constant(-1);
  std::optional<SurfacePoint> pointed_at_;
  bool on_paper_ = false;  ///< what is hovered of the paper is hovered here
  double wheel_at_ = -1;   ///< when the wheel was turned last
  PanelRect rect_{};
  std::vector<Place> places_;
};

}  // namespace hariko
