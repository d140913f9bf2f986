#include "ui/editor/selection_text.hpp"

#include "ui/editor/object_kind.hpp"

namespace hariko {

std::string describe_in(const Object* object, const ElementSelection& selection, const Language& tr) {
  return object ? object_kind(*object).describe(selection, tr) : describe(selection, tr);
}

std::string left_out_text(const Editor& editor, const std::string& keys) {
  if (!editor.left_out || !(editor.left_out->selection == editor.selection)) return {};
  const std::size_t count = editor.left_out->count;
  const Language& tr = editor.language;
  return fill(tr(count == 1 ? "1 hidden element left out" : "{0} hidden elements left out"),
              {std::to_string(count)}) +
         (keys.empty() ? std::string() : "   " + fill(tr("{0}: take hidden ones, too"), {keys}));
}

}  // namespace hariko
