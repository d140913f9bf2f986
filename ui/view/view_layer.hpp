#pragma once

// ViewLayer: something that stands over the pictures of the views, such as the gizmo or the points of a skin,
// and that the pointer can take. Each workspace brings its own; the viewport knows them by this interface.

#include <memory>
#include <optional>

#include "ui/base/marks.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// A view of the window while layers are drawn over it.
struct LayerPane {
  Projector projector;
  ToolOverlay overlay;
  bool active = false;             ///< tools and commands act in this view
  std::optional<Vector2> pointer;  ///< framebuffer pixels; only in the active view, while no tool runs
  Marks& marks;
};

class ViewLayer {
 public:
  virtual ~ViewLayer() = default;

  /// Looks at the document in the active view: before the pointer is handled, and again before drawing.
  virtual void update(const ToolContext& /*context*/, bool /*tool_runs*/) {}
  /// Lights what is under the pointer. True when it is something of this layer: what lies below is not
  /// hovered.
  virtual bool hover(const ToolContext& /*context*/, const Vector2& /*pixel*/) { return false; }
  /// Lights nothing any more: the pointer left the view, or has a tool. Called before every `hover`, too.
  virtual void leave(const ToolContext& /*context*/) {}
  /// Answers a press: nothing where it is not for this layer, a null tool where that is all.
  virtual std::optional<std::unique_ptr<Tool>> press(const ToolContext& /*context*/,
                                                     const PointerEvent& /*press*/) {
    return {};
  }
  virtual void draw(const ToolContext& /*context*/, const LayerPane& /*pane*/) {}
  /// Hint of the status line on what the pointer is at, in English; null where it is elsewhere.
  virtual const char* hint() const { return nullptr; }
};

}  // namespace hariko
