#include "ui/editor/last_operation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/editor/editor.hpp"

namespace hariko {

bool LastOperation::run(Editor& editor, std::string label, std::vector<OperationNumber> numbers,
                        MakeOperation make) {
  LastOperation next;
  next.label_ = std::move(label);
  next.numbers_ = std::move(numbers);
  next.make_ = std::move(make);
  next.before_ = editor.history.current();
  if (!next.commit(editor, next.before_, next.numbers_)) return false;
  *this = std::move(next);
  return true;
}

bool LastOperation::adjust(Editor& editor, std::size_t number, double value) {
  if (!can_adjust(editor) || number >= numbers_.size() || std::isnan(value)) return false;
  std::vector<OperationNumber> numbers = numbers_;
  OperationNumber& changed = numbers[number];
  changed.value = std::clamp(changed.whole ? std::round(value) : value, changed.low, changed.high);
  if (changed.value == numbers_[number].value) return false;
  const Result<OperationResult> tried = make_(before_, numbers);
  if (!tried) {
    editor.notify(tried.error());
    return false;
  }
  editor.undo();
  if (!commit(editor, before_, numbers)) return false;
  numbers_ = std::move(numbers);
  return true;
}

bool LastOperation::can_adjust(const Editor& editor) const {
  return make_ && !editor.history.in_gesture() && editor.history.can_undo() &&
         editor.history.current() == after_;
}

bool LastOperation::commit(Editor& editor, const Document& before, std::span<const OperationNumber> numbers) {
  Result<OperationResult> made = make_(before, numbers);
  if (!made) {
    editor.notify(made.error());
    return false;
  }
  after_ = made->document;
  const ObjectId active = made->active;
  const ElementSelection selected = made->selected;
  if (!editor.commit(Result<Document>(std::move(made).value().document), label_)) return false;
  editor.selection.clear_elements();
  editor.selection.active = active;
  if (!selected.empty()) editor.selection.set(active, selected);
  return true;
}

}  // namespace hariko
