// Commands that make objects of live copies, and that take live copies away.

#include <algorithm>

#include "ui/editor/selected_items.hpp"
#include "ui/shell/arrange_operations.hpp"

namespace hariko {

namespace {

void make_objects_of_copies(Editor& editor) {
  const std::vector<ObjectId> originals = chosen_ids(editor);
  make_copies(editor, copies_to_objects(editor.history.current(), originals), originals,
              translatable("Make copies objects"));
}

void remove_live_copies(Editor& editor) {
  Result<Document> result = editor.history.current();
  for (const auto& object : chosen_objects(editor))
    if (result && !object->copies->empty()) result = set_copies(*result, object->id, {});
  editor.commit(result, translatable("Remove live copies"));
}

WhyNot needs_live_copies(const Editor& editor) {
  return only_if(
      needs_object(editor),
      [&editor] {
        const auto objects = chosen_objects(editor);
        return std::any_of(objects.begin(), objects.end(),
                           [](const auto& object) { return !object->copies->empty(); });
      },
      translatable("What is chosen has no live copies."));
}

}  // namespace

void add_live_copy_commands(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add({.id = "object.copies_to_objects",
                  .menu = arrange_menu(),
                  .label = "Make copies objects",
                  .help =
                      "Objects of their own in the place of the live copies of the chosen objects: an array "
                      "that is taken apart.",
                  .changes_document = true,
                  .separator_before = true,
                  .run = [&editor] { make_objects_of_copies(editor); },
                  .why_not = needs_live_copies(editor),
                  .contexts = Context::object});
  host.table.add({.id = "object.remove_copies",
                  .menu = arrange_menu(),
                  .label = "Remove live copies",
                  .help =
                      "The chosen objects stay at their own places alone, without the other places of their "
                      "arrays.",
                  .changes_document = true,
                  .run = [&editor] { remove_live_copies(editor); },
                  .why_not = needs_live_copies(editor),
                  .contexts = Context::object});
}

}  // namespace hariko
