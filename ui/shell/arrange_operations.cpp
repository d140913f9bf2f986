#include "ui/shell/arrange_operations.hpp"

#include <utility>

#include "ui/editor/new_object.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

std::vector<ObjectId> with_copies_of(std::vector<ObjectId> originals, std::span<const ObjectId> copies) {
  originals.insert(originals.end(), copies.begin(), copies.end());
  return originals;
}

}  // namespace

std::string arrange_menu() {
  return submenu("Edit", translatable("Array and align"));
}

BeginOperation begin_on_chosen(const MakeOfObjects& make, const WriteOfObjects& write) {
  return [make, write](const Editor& editor) -> Result<BegunOperation> {
    if (const Reason reason = needs_object(editor)()) return make_error(e_no_objects, *reason);
    auto made = make(editor, chosen_ids(editor));
    if (!made) return made.error();
    return BegunOperation{std::move(made).value(), {}, write(editor)};
  };
}

void run_on_chosen(Editor& editor, const char* label, std::vector<OperationNumber> numbers,
                   const MakeOfObjects& make, const WriteOfObjects& write) {
  OperationStep step{label, std::move(numbers), {}, begin_on_chosen(make, write)};
  auto begun = step.begin(editor);
  if (!begun) return editor.notify(begun.error());
  step.make = begun->make;
  step.written = begun->written;
  if (editor.last_operation.run(editor, std::move(step))) bring_into_sight(editor, chosen_ids(editor));
}

Result<OperationResult> all_chosen(const Result<AddedObjects>& added,
                                   const std::vector<ObjectId>& originals) {
  if (!added) return added.error();
  OperationResult result{added->document, originals.front()};
  result.objects = with_copies_of(originals, added->ids);
  return result;
}

Result<OperationResult> chosen_with_live_copies(Result<Document> made,
                                                const std::vector<ObjectId>& originals) {
  if (!made) return made.error();
  OperationResult result{std::move(made).value(), originals.front()};
  result.objects = originals;
  return result;
}

OperationNumber kind_of_copies() {
  return choice_number("array_copies", translatable("Copies as"),
                       {translatable("Objects"), translatable("Live copies")});
}

bool wants_live_copies(std::span<const OperationNumber> numbers) {
  return numbers.back().value != 0;
}

ArgumentSpec live_copies_argument() {
  return on_off_argument("live", translatable("Live copies"), false);
}

OperationNumber count_of_places(int value) {
  return {"array_count", translatable("Total count"), double(value), least_places, most_places, true};
}

void make_copies(Editor& editor, const Result<AddedObjects>& added, std::vector<ObjectId> originals,
                 const char* step) {
  if (!added) return editor.notify(added.error());
  if (editor.commit(added->document, step))
    choose_objects(editor, with_copies_of(std::move(originals), added->ids));
}

void make_live_copies(Editor& editor, const Result<Document>& made, const char* step) {
  editor.commit(made, step);
}

}  // namespace hariko
