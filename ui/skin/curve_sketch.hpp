#pragma once

// CurveSketch: a curve being drawn in a plane, point by point or by a stroke.

#include <optional>
#include <string>
#include <vector>

#include "core/skinning/sections/section_frame.hpp"
#include "core/subdivision/subdivision_curve.hpp"
#include "ui/editor/numeric_input.hpp"
#include "ui/view/snapping.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// Positions in the document's space.
class CurveSketch {
 public:
  /// The plane that is drawn in, with a unit normal.
  struct Plane {
    Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
    std::optional<Matrix3> axes = std::nullopt;  ///< the plane's own; none: upright ones
  };
  CurveSketch() = default;  ///< on the ground
  explicit CurveSketch(const Plane& plane) : plane_(plane) {}

  /// Presses, moves and releases of the pointer. A click adds a point, one on the first point closes the
  /// curve; a stroke adds points until the curve is within 2.5 design pixels of it, and closes the curve
  /// where it ends at its beginning. Errors: why nothing was added.
  std::optional<Message> feed(const ToolContext& context, const PointerEvent& event);
  /// Backspace takes the last point, or the closing, away; C opens and closes; P: the points are those of the
  /// control polygon, or of the curve. False for other keys.
  bool key(const KeyPress& press);
  /// Replaces what was drawn. `through`: the points are those of the curve, not of its control polygon.
  void fill(std::vector<Vector3> points, std::vector<char> sharp, bool closed, bool through);
  /// Whether a stroke or a point is on its way.
  bool busy() const { return !stroke_.empty(); }

  const Plane& plane() const { return plane_; }
  /// The plane's axes, or else: to the right, up, and towards one who looks along its normal.
  Matrix3 axes() const { return plane_.axes ? *plane_.axes : upright_axes(plane_.normal); }
  /// Takes up what can be caught. Call with every event before anything is placed.
  void look_for_places(const ToolContext& context) { catcher_.update(context); }
  /// Target under a pixel that would be caught.
  std::optional<SnapTarget> caught(const ToolContext& context, const Vector2& pixel) const;
  /// The point of the plane under a pixel; nothing near its horizon. With `snaps` the foot of what is caught
  /// there, else on the grid; without, on an axis through the plane's point where it is near to it.
  std::optional<Vector3> place(const ToolContext& context, const Vector2& pixel, bool snaps) const;
  int size() const { return int(points_.size()); }
  bool closed() const { return closed_; }
  bool through_points() const { return through_; }
  /// At least two points (closed: three).
  bool complete() const { return size() >= (closed_ ? 3 : 2); }
  /// The drawn curve, complete or not.
  SubdivisionCurve curve() const { return curve_of(points_, sharp_, closed_); }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const;

 private:
  SubdivisionCurve curve_of(const std::vector<Vector3>& points, std::vector<char> sharp, bool closed) const;
  /// The point of the plane under a pixel; nothing near its horizon.
  std::optional<Vector3> on_plane(const Projector& projector, const Vector2& pixel) const;
  bool at_first(const ToolContext& context, const Vector2& pixel) const;
  std::optional<Message> add_point(const ToolContext& context, const Vector2& pixel, bool snaps);
  std::optional<Message> add_stroke(const ToolContext& context);

  Plane plane_;
  std::vector<Vector3> points_;
  std::vector<char> sharp_;  ///< one a point
  bool closed_ = false, through_ = true;
  std::vector<Vector2> stroke_;  ///< pixels since the press
  Vector2 pointer_ = Vector2::Zero();
  bool snaps_ = false;
  SnapCatcher catcher_;
};

/// A curve of the document's space on the picture.
void draw_curve(const Projector& projector, const ToolOverlay& overlay, const SubdivisionCurve& curve,
                ImU32 colour, float width);

enum class SectionShape { circle, ellipse, rectangle };

/// Points that the closed curve of a shape goes through, and its corners, about the origin of a plane whose
/// axes are the first two columns of `axes`. `half`: half its width and height, both above zero; a circle has
/// the first one only.
struct ShapePoints {
  std::vector<Vector3> points;
  std::vector<char> sharp;
};
ShapePoints shape_points(SectionShape shape, const Vector3& middle, const Matrix3& axes, const Vector2& half);

class ShapeSketch {
 public:
  bool active() const { return shape_.has_value(); }
  void begin(SectionShape shape, Unit unit);
  void end() { shape_.reset(); }
  /// O a circle, E an ellipse, R a rectangle; then digits, its width and, after Tab, its height. False for
  /// other keys.
  bool key(const KeyPress& press, Unit unit);
  /// The pointer is at its edge or corner, on the grid with `snaps`.
  void follow(const ToolContext& context, const CurveSketch& sketch, const Vector2& pixel, bool snaps);
  /// Makes the shape what was drawn; false while it has no size.
  bool fill(CurveSketch& sketch) const;
  void draw(const ToolContext& context, const ToolOverlay& overlay, const CurveSketch& sketch) const;
  /// "Ellipse 40 × 20 mm", with what is being typed.
  std::string text(const Editor& editor) const;

 private:
  /// Half the width and height that count now.
  Vector2 half() const;

  std::optional<SectionShape> shape_;
  NumericInput input_;
  Vector2 pointed_ = Vector2::Zero();  ///< half the size that the pointer gives
};

}  // namespace hariko
