#pragma once

// OutlineHandles: arrows at the points of the active outline that show its normals and can be dragged.

#include <optional>
#include <vector>

#include "ui/view/tool.hpp"
#include "ui/view/view_layer.hpp"

namespace hariko {

/// Keeps where the arrows are between frames. Their length is of the screen; those whose head lies on their
/// point, because the normal looks at the viewer or away, cannot be taken.
class OutlineHandles final : public ViewLayer {
 public:
  /// Looks at the present document. Hidden when no outline is active, and while the paper is shown.
  void update(const ToolContext& context, bool tool_runs) override;
  bool hover(const ToolContext& context, const Vector2& pixel) override;
  void leave(const ToolContext&) override { hot_.reset(); }
  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override;
  void draw(const ToolContext& context, const LayerPane& pane) override;
  const char* hint() const override;

  /// Design pixels from a point to its arrowhead, seen from the side; and round a head, that hit it.
  static constexpr double arrow_length = 44, hit_radius = 7;

 private:
  struct Arrow {
    Vector2 from, to;  ///< pixels
    bool seen = true;  ///< in front of the eye
    bool selected = false;
    bool wrong = false;  ///< the last rebuild complained about the point
  };
  /// The point whose arrowhead is there.
  std::optional<Index> hit(const Vector2& pixel) const;
  /// Names the points and the heads for tests: "outline.point.3", "outline.normal.3".
  void mark(Marks& marks, const ToolOverlay& overlay) const;

  std::vector<Arrow> arrows_;  ///< by the number of the point
  std::optional<Index> hot_;   ///< under the pointer
};

/// Turns the normal of a point, and with it those of the other selected points, about the loop. For a press
/// on an arrowhead.
std::unique_ptr<Tool> make_normal_tool(ObjectId object, Index number);

/// Modal: clicks put corners on the working plane, or, when the first one is on a surface, on surfaces; Ctrl
/// snaps. A smooth loop runs through them. Enter, or a click on the first corner, makes it: a new
/// outline, or one more loop of `outline`, which bounds a hole. On the plane its normals lean away from the
/// surface; on surfaces it has theirs. Backspace takes the last corner away.
std::unique_ptr<Tool> make_loop_tool(std::optional<ObjectId> outline = {});

}  // namespace hariko
