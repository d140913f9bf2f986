#include "ui/editor/last_operation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/modeling/objects/primitives.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/operations.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

/// Says that a step was not made, as what was prepared for it fits no longer.
void say_changed_meanwhile(Editor& editor, const Phrase& label) {
  editor.warn({"\u201c{0}\u201d was not applied, as its objects were changed meanwhile. Run it again.",
               {editor.language(label)}});
}

LongEdit followed_by(LongEdit first, std::function<void()> next) {
  first.work = [work = std::move(first.work), next = std::move(next)](const CancelToken& cancel,
                                                                      const Progress& progress) {
    return LongEdit::Then([keep = work(cancel, progress), next] {
      keep();
      next();
    });
  };
  return first;
}

}  // namespace

OperationNumber distance_number(const char* id, const char* label, double value) {
  return {id, label, value, -max_primitive_length, max_primitive_length};
}

OperationNumber choice_number(const char* id, const char* label, std::vector<const char*> choices,
                              int value) {
  const double last = double(choices.size()) - 1;
  return {id, label, double(value), 0, last, true, false, std::move(choices)};
}

bool LastOperation::run(Editor& editor, OperationStep step) {
  if (step.prepare)
    if (const auto first = step.prepare(editor.history.current(), step.numbers))
      return run_prepared(editor, *first, std::move(step));
  LastOperation next;
  next.step_ = next.again_ = std::move(step);
  next.before_ = editor.history.current();
  next.count_ = count_;
  if (!next.commit(editor, next.before_, next.step_)) return false;
  next.note(editor, {});
  *this = std::move(next);
  return true;
}

/// Runs the step after its work, on the document as it is then. False where that was done at once and the
/// step refused.
bool LastOperation::run_prepared(Editor& editor, const LongEdit& first, OperationStep step) {
  const auto refused = std::make_shared<bool>(false);
  editor.make(followed_by(
      first, [&editor, refused, step = std::move(step), documents = editor.documents, object = first.object] {
        const Document& now = editor.history.current();
        if (editor.documents != documents || !now.find(object)) return;
        *refused = true;
        if (step.prepare(now, step.numbers)) return say_changed_meanwhile(editor, step.label);
        *refused = !editor.last_operation.run(editor, step);
      }));
  return !*refused;
}

/// Adjusts the step after its work, where it still is the last one. False where that was done at once and the
/// number refused.
bool LastOperation::adjust_prepared(Editor& editor, const LongEdit& first, std::size_t number, double value) {
  const auto refused = std::make_shared<bool>(false);
  editor.make(followed_by(first, [&editor, refused, number, value, documents = editor.documents,
                                  count = count_, label = step_.label] {
    if (editor.documents != documents) return;
    LastOperation& last = editor.last_operation;
    *refused = true;
    if (last.count_ != count || !last.can_adjust(editor)) return say_changed_meanwhile(editor, label);
    *refused = !last.adjust(editor, number, value);
  }));
  return !*refused;
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
  if (step.prepare)
    if (const auto first = step.prepare(before_, step.numbers))
      return adjust_prepared(editor, *first, number, changed.value);
  const Result<OperationResult> tried = step.make(before_, step.numbers);
  if (!tried) return editor.refuse(tried.error());
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
    if (!begun) return editor.refuse(begun.error());
    step.make = begun->make;
    step.written = begun->written;
    step.prepare = begun->prepare;
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
  if (!made) return editor.refuse(made.error());
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

namespace {

ArgumentSpec argument_of(const OperationNumber& number) {
  ArgumentSpec spec;
  spec.name = number.id;
  spec.help = number.label;
  if (!number.choices.empty()) {
    spec.type = ArgumentType::word;
    spec.words.assign(number.choices.begin(), number.choices.end());
    spec.standard = spec.words[static_cast<std::size_t>(number.value)];
    return spec;
  }
  spec.type = number.whole ? ArgumentType::whole : ArgumentType::number;
  spec.unit = number.whole ? ArgumentUnit::none : number.angle ? ArgumentUnit::degrees : ArgumentUnit::length;
  spec.standard = number.value;
  spec.low = number.low;
  spec.high = number.high;
  return spec;
}

}  // namespace

std::vector<ArgumentSpec> arguments_of(std::span<const OperationNumber> numbers) {
  std::vector<ArgumentSpec> out;
  for (const OperationNumber& number : numbers) out.push_back(argument_of(number));
  return out;
}

std::vector<OperationNumber> with_values(std::vector<OperationNumber> numbers, const Arguments& arguments) {
  for (OperationNumber& number : numbers) {
    if (number.choices.empty()) {
      number.value = arguments.number(number.id);
      continue;
    }
    const auto chosen = std::find(number.choices.begin(), number.choices.end(), arguments.text(number.id));
    number.value = static_cast<double>(chosen - number.choices.begin());
  }
  return numbers;
}

std::vector<WrittenArgument> written_numbers(std::span<const OperationNumber> numbers) {
  std::vector<WrittenArgument> out;
  for (const OperationNumber& number : numbers)
    out.push_back(number.choices.empty()
                      ? written(number.id, number.value)
                      : written(number.id, std::string(number.choices[std::size_t(number.value)])));
  return out;
}

}  // namespace hariko
