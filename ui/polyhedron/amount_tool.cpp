#include "ui/polyhedron/amount_tool.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/document/length_units.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "ui/editor/operations.hpp"
#include "ui/view/axis_lock.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

constexpr double fine_amount = 0.1;
/// Limit of a drag, as a share of the amount at which something would shrink to nothing.
constexpr double nearly_all = 0.98;

/// Step of a script, with an amount in the document's space; none where single faces were chosen instead of
/// regions, or the other way round.
std::vector<WrittenCommand> written_amount(const AmountOperation& operation, double amount,
                                           Grouping grouping) {
  if (operation.command.empty() || grouping != operation.grouping) return {};
  return {WrittenCommand{operation.command, {written(operation.argument, amount)}}};
}

/// The operation on what is selected now, with an amount in the document's space.
Result<BegunOperation> amount_again(const Editor& editor, const AmountOperation& first, double amount,
                                    Grouping grouping) {
  auto again = first.again(editor);
  if (!again) return again.error();
  const Object* object = editor.history.current().find(again->object);
  const double own = object ? amount / object->transform.scale : amount;
  BegunOperation begun;
  begun.label = again->label;
  begun.written = [steps = written_amount(*again, amount, grouping)](std::span<const OperationNumber>) {
    return steps;
  };
  begun.make = [operation = std::move(again).value(), own, grouping](
                   const Document& document, std::span<const OperationNumber>) -> Result<OperationResult> {
    auto done = edit_polyhedron(document, operation.object, [&](const PolyhedronSource& source) {
      return operation.apply(source, own, grouping);
    });
    if (!done) return done.error();
    OperationResult result{done->document, operation.object, done->selection};
    result.selects_as_operation = true;
    return result;
  };
  return begun;
}

class AmountTool final : public ModalTool {
 public:
  explicit AmountTool(AmountOperation operation)
      : operation_(std::move(operation)), grouping_(operation_.grouping) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    const Document& document = context.editor.history.current();
    const auto lengths = length_units(document.unit);
    input_ = NumericInput(1, {lengths.begin(), lengths.end()});
    from_ = at_ = pointer_ = press.pixel;
    camera_ = context.editor.camera();
    if (const Object* object = document.find(operation_.object)) scale_ = object->transform.scale;
    find_limit(context);
    show(context);
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    follow(context, event);
    show(context);
    return event.kind == PointerEvent::Kind::press ? confirm(context) : ToolState::stay;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    if (press.chord.key == Key::enter) return confirm(context);
    if (!input_.key(press)) {
      if (press.chord.control || press.chord.alt || press.text == 0) return std::nullopt;
      // Other letters would run commands in the middle of the gesture.
      if (press.chord.key != Key::i || !operation_.grouped) return ToolState::stay;
      grouping_ = grouping_ == Grouping::region ? Grouping::individual : Grouping::region;
      find_limit(context);
    }
    show(context);
    return ToolState::stay;
  }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!operation_.axis.isZero(0))
      draw_axis_line(overlay, context.projector(), operation_.anchor, operation_.axis,
                     with_alpha(palette().text, 0.5F));
    const std::string value = value_text(context.editor.language);
    draw_value_label(overlay, pointer_, error_.empty() ? value : value + "   " + error_, !error_.empty());
  }

  std::string hint(const Language& tr) const override {
    std::string text = value_text(tr) + "   |   ";
    if (operation_.grouped) text += std::string(tr("I region or each face")) + "   ";
    return text + tr("digits type   Shift fine   Ctrl steps   Enter confirms   Esc cancels");
  }

 private:
  void find_limit(const ToolContext& context) {
    limit_ = std::numeric_limits<double>::infinity();
    const Object* object = context.editor.history.current().find(operation_.object);
    if (operation_.limit && object && object->polyhedron())
      limit_ = operation_.limit(*object->polyhedron(), grouping_) * scale_;
  }

  void follow(const ToolContext& context, const PointerEvent& event) {
    stepped_ = event.control;
    fine_ = event.shift;
    const Camera now = context.editor.camera();
    if (now.target != camera_.target || now.distance != camera_.distance ||
        now.orientation.coeffs() != camera_.orientation.coeffs() ||
        now.orthographic != camera_.orthographic) {
      // After the view has turned the pointer begins anew from what was reached.
      reached_ = dragged(Projector(camera_, context.editor.viewport));
      camera_ = now;
      from_ = at_ = pointer_ = event.pixel;
      return;
    }
    at_ += (fine_ && !stepped_ ? fine_amount : 1) * (event.pixel - pointer_);
    pointer_ = event.pixel;
  }

  double dragged(const Projector& projector) const {
    const Vector3& axis = operation_.axis;
    if (axis.isZero(0)) return reached_ + (at_ - from_).x() * projector.pixel_length_at(operation_.anchor);
    Matrix3 frame;
    frame.col(2) = axis;
    frame.col(0) = axis.unitOrthogonal();
    frame.col(1) = axis.cross(frame.col(0));
    const AxisLock lock{AxisLock::Kind::axis, 2, false};
    return reached_ +
           drag_vector(projector, lock, frame, operation_.anchor + reached_ * axis, from_, at_).dot(axis);
  }

  /// In the document's space.
  double wanted(const ToolContext& context) const {
    if (input_.active()) return input_.value().value_or(0);
    const Projector projector = context.projector();
    double amount = dragged(projector);
    if (stepped_) {
      const DecimalStep step = grid_step(context, operation_.anchor);
      amount = (fine_ ? step.tenth() : step).nearest(amount);
    }
    if (!operation_.negative) amount = std::max(amount, 0.0);
    return std::min(amount, nearly_all * limit_);
  }

  /// `confirmed`: what is typed counts even where it may go on.
  void show(ToolContext& context, bool confirmed = false) {
    Editor& editor = context.editor;
    error_.clear();
    // With its unit, as typed numbers may have one.
    text_ = input_.active() ? input_.text(0) : length_text(editor, amount_);
    // Until the unit is whole the last number stays in view.
    if (input_.unfinished() && !confirmed) return;
    amount_ = wanted(context);
    if (!input_.active()) text_ = length_text(editor, amount_);
    changed_ = false;
    if (const auto wrong = input_.error()) error_ = editor.language.text_of(*wrong);
    if (amount_ == 0 || !error_.empty()) return editor.cancel_preview();
    const auto done = edit_polyhedron(editor.history.current(), operation_.object, [&](const auto& source) {
      return operation_.apply(source, amount_ / scale_, grouping_);
    });
    if (!done) {
      error_ = editor.language.text_of(done.error());
      return editor.cancel_preview();
    }
    result_ = done->selection;
    changed_ = editor.preview(done->document);
  }

  ToolState confirm(ToolContext& context) {
    if (input_.unfinished()) show(context, true);
    if (!error_.empty()) return ToolState::stay;
    if (!changed_ || !context.editor.commit_preview(operation_.label)) {
      context.editor.cancel_preview();
      return ToolState::cancel;
    }
    select_result(context.editor, operation_.object, result_);
    context.editor.tell_script(written_amount(operation_, amount_, grouping_));
    remember(context.editor);
    return ToolState::commit;
  }

  void remember(Editor& editor) const {
    if (!operation_.again) return;
    OperationStep step;
    step.label = operation_.label;
    step.begin = [first = operation_, amount = amount_, grouping = grouping_](const Editor& now) {
      return amount_again(now, first, amount, grouping);
    };
    editor.last_operation.take_up(editor, {}, std::move(step));
  }

  std::string value_text(const Language& tr) const {
    std::string text = std::string(tr(operation_.name)) + "  " + text_;
    if (operation_.grouped && grouping_ == Grouping::individual) text += "  " + std::string(tr("each face"));
    return text;
  }

  AmountOperation operation_;
  Grouping grouping_;
  NumericInput input_;
  // Pixels; `at_` counts a tenth while Shift is down.
  Vector2 from_ = Vector2::Zero(), at_ = Vector2::Zero();
  Camera camera_;
  double scale_ = 1;
  double limit_ = 0, amount_ = 0, reached_ = 0;  ///< lengths in the document's space
  bool stepped_ = false, fine_ = false;
  bool changed_ = false;  ///< whether a preview shows
  ElementSet result_;
  std::string text_;
};

}  // namespace

std::unique_ptr<Tool> make_amount_tool(AmountOperation operation) {
  return std::make_unique<AmountTool>(std::move(operation));
}

}  // namespace hariko
