#pragma once

// Gizmo: handles at the selection that move, rotate and scale it.

#include <array>
#include <optional>
#include <vector>

#include "ui/view/transform_tool.hpp"
#include "ui/view/view_layer.hpp"

namespace hariko {

struct GizmoHandle {
  TransformKind kind = TransformKind::move;
  AxisLock lock;
  friend bool operator==(const GizmoHandle&, const GizmoHandle&) = default;
};

/// Keeps where the selection is between frames. Arrows move along an axis and squares in a plane, arcs
/// rotate, boxes scale. Sizes are of the screen; what points at the viewer is left out. In a local edit of
/// one vertex the handles follow its tangent plane, which is drawn with its two tangents in their own size.
class Gizmo final : public ViewLayer {
 public:
  /// Looks at the present selection. Hidden when nothing is selected, when it is switched off, and while
  /// `busy`.
  void update(const Editor& editor, bool busy);
  void update(const ToolContext& context, bool tool_runs) override { update(context.editor, tool_runs); }
  std::optional<GizmoHandle> hit(const Vector2& pixel) const;
  bool hover(const ToolContext& context, const Vector2& pixel) override;
  void leave(const ToolContext&) override { hot_.reset(); }
  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override;
  void draw(const ToolContext& context, const LayerPane& pane) override;
  const char* hint() const override;

  /// Design pixels round a handle, that hit it.
  static constexpr double hit_radius = 8;

 private:
  struct Shape {
    GizmoHandle handle;
    std::vector<Vector2> line;  ///< pixels; closed and filled for squares
    bool closed = false;
    Vector2 mark = Vector2::Zero();
    /// Pixels from a pixel; 0 inside of a square.
    double distance(const Vector2& pixel) const;
    bool reaches(const Vector2& pixel, double radius) const;
  };
  /// The handle whose line is nearest, among arcs or among all others.
  std::optional<GizmoHandle> nearest(const Vector2& pixel, bool arcs) const;
  void place(const Editor& editor);
  void place_plane(const Projector& projector);
  void leave_out_covered();
  void draw_plane(const ToolOverlay& overlay) const;
  void draw_shape(const ToolOverlay& overlay, const Shape& shape) const;
  /// Names a point of each handle for tests: "gizmo.move.x", "gizmo.rotate.z", "gizmo.move.xy".
  void mark(Marks& marks, const ToolOverlay& overlay) const;
  /// Names an arc where most room is round it; false where others cover more than half of it.
  static bool go_to_freest(Shape& arc, const std::vector<Shape>& others, double reach);

  // State that the pivot was made for.
  Document document_;
  Selection selection_;
  ElementMode mode_ = ElementMode::vertex;
  PivotMode pivot_mode_ = PivotMode::median;
  bool local_edit_ = false;
  bool known_ = false;

  std::optional<Vector3> pivot_;
  Matrix3 object_frame_ = Matrix3::Identity();
  std::optional<std::array<Vector3, 2>> tangents_;  ///< tangents at the vertex of a local edit
  bool in_planes_ = false;                          ///< sections: handles for their plane only
  std::vector<Vector2> plane_;                      ///< outline of the disc that they span
  std::vector<Vector2> plane_axes_;                 ///< the centre and the tips of both
  double scale_ = 1;
  std::vector<Shape> shapes_;
  std::optional<GizmoHandle> hot_;  ///< under the pointer
};

}  // namespace hariko
