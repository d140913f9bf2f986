#include "ui/view/transform_repeat.hpp"

#include "core/modeling/edit_result.hpp"

namespace hariko {

namespace {

/// The transformation along other local axes.
Transformation along_axes(const DoneTransform& done, const Matrix3& axes) {
  Transformation out = done.transformation;
  if (!done.local) return out;
  const Matrix3 turn = axes * done.axes.transpose();
  out.translation = turn * out.translation;
  out.axis = turn * out.axis;
  out.frame = turn * out.frame;
  return out;
}

Result<BegunOperation> transform_again(const Editor& editor, const DoneTransform& done) {
  TransformTarget target = TransformTarget::of(editor);
  if (target.empty())
    return make_error(e_wrong_selection, "Nothing is selected that can be moved.",
                      "Select something that is neither hidden nor locked.");
  const SoftSelection& soft = editor.transform.soft;
  target.follow(soft.on ? soft.radius : 0, soft.falloff);
  const Transformation again = along_axes(done, target.local_frame());
  BegunOperation begun;
  begun.label = done.verb + " " + target.describe();
  begun.make = [target = std::move(target), again, local = done.local](
                   const Document& document, std::span<const OperationNumber>) -> Result<OperationResult> {
    Result<Document> moved = target.apply(document, again, local);
    if (!moved) return moved.error();
    OperationResult result{std::move(moved).value(), {}};
    result.keeps_selection = true;
    return result;
  };
  return begun;
}

}  // namespace

void remember_transform(Editor& editor, const DoneTransform& done) {
  OperationStep step;
  step.label = editor.history.undo_label();
  step.begin = [done](const Editor& now) { return transform_again(now, done); };
  editor.last_operation.take_up(editor, {}, std::move(step));
}

}  // namespace hariko
