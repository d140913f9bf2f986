#include "ui/editor/last_operation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/editor/editor.hpp"
#include "ui/editor/operations.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

bool LastOperation::run(Editor& editor, OperationStep step) {
  LastOperation next;
  next.step_ = next.again_ = std::move(step);
  next.before_ = editor.history.current();
  next.count_ = count_;
  if (!next.commit(editor, next.before_, next.step_)) return false;
  next.note(editor, {});
  *this = std::move(next);
  return true;
}

void LastOperation::take_up(const Editor& editor, Document before, OperationStep step) {
  again_ = std::move(step);
  if (!again_.numbers.empty()) {
    step_ = again_;
    before_ = std::move(before);
    after_ = editor.history.current();
  }
  note(editor, {});
}

void LastOperation::take_up_command(const Editor& editor, std::string id) {
  note(editor, std::move(id));
}

bool LastOperation::adjust(Editor& editor, std::size_t number, double value) {
  if (!can_adjust(editor) || number >= step_.numbers.size() || std::isnan(value)) return false;
  OperationStep step = step_;
  OperationNumber& changed = step.numbers[number];
  changed.value = std::clamp(changed.whole ? std::round(value) : value, changed.low, changed.high);
  if (changed.value == step_.numbers[number].value) return false;
  const Result<OperationResult> tried = step.make(before_, step.numbers);
  if (!tried) {
    editor.notify(tried.error());
    return false;
  }
  editor.undo();
  if (!commit(editor, before_, step)) return false;
  step_ = again_ = std::move(step);
  note(editor, {});
  return true;
}

bool LastOperation::repeat(Editor& editor) {
  HARIKO_ASSERT(can_repeat(editor) && command_.empty(), "there must be an operation to repeat");
  OperationStep step = again_;
  if (step.begin) {
    Result<BegunOperation> begun = step.begin(editor);
    if (!begun) {
      editor.notify(begun.error());
      return false;
    }
    step.make = begun->make;
    step.written = begun->written;
    if (!begun->label.empty()) step.label = begun->label;
  }
  return run(editor, std::move(step));
}

bool LastOperation::can_adjust(const Editor& editor) const {
  return step_.make && !editor.history.in_gesture() && editor.history.can_undo() &&
         editor.history.current() == after_;
}

bool LastOperation::can_repeat(const Editor& editor) const {
  return (again_.make || again_.begin || !command_.empty()) && editor.documents == documents_ &&
         editor.history.serial() <= serial_;
}

void LastOperation::note(const Editor& editor, std::string command) {
  command_ = std::move(command);
  ++count_;
  documents_ = editor.documents;
  serial_ = editor.history.serial();
}

bool LastOperation::commit(Editor& editor, const Document& before, const OperationStep& step) {
  Result<OperationResult> made = step.make(before, step.numbers);
  if (!made) {
    editor.notify(made.error());
    return false;
  }
  after_ = made->document;
  const OperationResult result = std::move(made).value();
  const bool changed = editor.commit(Result<Document>(result.document), step.label);
  if (result.say) result.say(editor);
  if (!changed) return false;
  if (step.written) editor.tell_script(step.written(step.numbers));
  after_ = editor.history.current();  // without the dimensions that have lost what they measured
  if (result.keeps_selection) return true;
  if (result.selects_as_operation) {
    select_result(editor, result.active, result.selected);
    return true;
  }
  editor.selection.clear_elements();
  if (!result.objects.empty()) choose_objects(editor, result.objects);
  editor.selection.active = result.active;
  if (!result.selected.empty()) editor.selection.set(result.active, result.selected);
  return true;
}

}  // namespace hariko
