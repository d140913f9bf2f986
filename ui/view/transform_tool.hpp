#pragma once

// TransformTool: moves, rotates and scales what is selected.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ui/editor/numeric_input.hpp"
#include "ui/view/axis_lock.hpp"
#include "ui/view/snapping.hpp"
#include "ui/view/tool.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

enum class TransformKind { move, rotate, scale };

/// Drives of a transform tool: by a command (the pointer moves freely), by dragging an element or a handle
/// with a button down, or by typing alone.
enum class DrivenBy { command, element, handle, typing };

/// Objects that a command has just made: they join the document with the tool's step, and not at all where
/// it is cancelled.
struct NewObjects {
  Document document;  ///< the current one with them
  std::vector<ObjectId> objects;
  std::string step;  ///< label of the step that makes and moves them
  /// Is called after the step, with the document before it, what was moved, and how.
  std::function<void(Editor&, const Document& before, const TransformTarget&, const Transformation&)> moved;
};

class TransformTool final : public SpeakingTool {
 public:
  explicit TransformTool(TransformKind kind, DrivenBy by = DrivenBy::command, AxisLock lock = {})
      : kind_(kind), by_(by), lock_(lock) {}
  /// Moves new objects instead of what is selected.
  TransformTool(TransformKind kind, NewObjects made)
      : kind_(kind), by_(DrivenBy::command), made_(std::make_shared<const NewObjects>(std::move(made))) {}

  bool modal() const override { return by_ == DrivenBy::command || by_ == DrivenBy::typing; }
  void begin(ToolContext& context, const PointerEvent& press) override;
  ToolState update(ToolContext& context, const PointerEvent& event) override;
  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override;
  bool wheel(ToolContext& context, double steps, const PointerEvent& event) override;
  void draw(const ToolContext& context, const ToolOverlay& overlay) const override;
  std::string hint(const Language& tr) const override;
  std::unique_ptr<Tool> successor() override { return std::move(successor_); }

 private:
  Matrix3 frame() const { return lock_.local ? target_.local_frame() : Matrix3::Identity(); }
  std::size_t fields() const {
    if (kind_ == TransformKind::move) return lock_.components();
    return kind_ == TransformKind::rotate ? 1 : lock_.kind == AxisLock::Kind::plane ? 2 : 3;
  }
  /// The lock that sections begin with: their planes.
  static constexpr AxisLock section_plane_lock{AxisLock::Kind::plane, 2, true};
  bool lock_key(const KeyPress& press);
  void restart(ToolContext& context, TransformKind kind);
  void follow_pointer(const ToolContext& context, const PointerEvent& event);
  void keep_through_view_change(const ToolContext& context, const Vector2& pixel);
  Vector3 dragged(const ToolContext& context) const;
  double drag_ratio(const ToolContext& context) const;

  Transformation transformation(const ToolContext& context);
  Transformation move(const ToolContext& context);
  Transformation rotation(const ToolContext& context);
  Transformation scaling(const ToolContext& context);
  Vector3 snapped(const ToolContext& context, const Vector3& translation);

  /// `confirmed`: what is typed counts even where it may go on.
  ToolState show(ToolContext& context, bool confirmed = false);
  ToolState confirm(ToolContext& context);
  void change_radius(ToolContext& context, double steps);
  void apply_falloff(const ToolContext& context);
  std::string value_text(const Language& tr) const;
  void draw_guides(const ToolContext& context, const ToolOverlay& overlay) const;
  void draw_falloff(const ToolContext& context, const ToolOverlay& overlay) const;

  TransformKind kind_;
  DrivenBy by_;
  AxisLock lock_;
  std::shared_ptr<const NewObjects> made_;  ///< null: what is selected is transformed
  TransformTarget target_;
  std::optional<SnapPlaces> places_;  ///< places that a move can jump to
  NumericInput input_;
  std::unique_ptr<Tool> successor_;

  // The pointer: where it pressed and is, in pixels that count a tenth while Shift is down.
  Vector2 from_ = Vector2::Zero(), at_ = Vector2::Zero();
  bool moved_ = false, fine_ = false, snapping_ = false;
  Vector3 anchor_ = Vector3::Zero();  ///< the grabbed point, in the document's space
  Vector3 source_ = Vector3::Zero();  ///< the selected point that snaps to others
  // Transformation reached before the view changed last.
  Camera camera_;
  Vector3 base_move_ = Vector3::Zero();
  double base_ratio_ = 1;
  double screen_degrees_ = 0;  ///< counter-clockwise on the screen

  Transformation done_;  ///< transformation that is shown
  std::optional<SnapTarget> snap_;
  bool shown_ = false;
  std::string length_unit_;
  int decimals_ = 3;
};

std::unique_ptr<Tool> make_transform_tool(TransformKind kind, DrivenBy by = DrivenBy::command,
                                          AxisLock lock = {});
/// Moves objects that a command has just made.
std::unique_ptr<Tool> make_transform_tool(NewObjects made);

/// A step that a transform tool has made.
struct DoneTransform {
  std::string verb;                    ///< "Move": its label begins with it
  Matrix3 axes = Matrix3::Identity();  ///< the local axes then
  Transformation transformation;
  bool local = false;  ///< it was made along the local axes, and is repeated along those of what is selected
};

/// Steps of a script that transform what is selected like this, softly where the editor does; empty where
/// scripts have no words for it, such as a turn about the direction of the view.
std::vector<WrittenCommand> written_transform(const Editor& editor, const DoneTransform& done);

/// Lets the last step of the editor be repeated as this one, and written in a script.
void remember_transform(Editor& editor, const DoneTransform& done);

}  // namespace hariko
