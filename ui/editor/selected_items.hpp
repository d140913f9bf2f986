#pragma once

// Subjects of the panels: the chosen objects.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/document.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

using Objects = std::vector<std::shared_ptr<const Object>>;

/// Those for which `test` gives something that holds.
template <class Test>
Objects objects_where(const Objects& objects, const Test& test) {
  Objects out;
  for (const auto& object : objects)
    if (std::invoke(test, *object)) out.push_back(object);
  return out;
}

/// The chosen objects, the active one first, with all of a chosen group (`ChosenGroup`); empty when there is
/// none.
Objects chosen_objects(const Editor& editor);

/// Their ids.
std::vector<ObjectId> chosen_ids(const Editor& editor);

/// Chooses whole objects instead of what was chosen and selected; hidden and locked ones are left out. The
/// first becomes the active one.
void choose_objects(Editor& editor, std::span<const ObjectId> objects);

inline constexpr Code e_no_object_named{"E_NO_SUCH_OBJECT"};

/// Ids of all objects with these names: in the order of the names, those of one name in the order of the
/// document. Errors: E_NO_SUCH_OBJECT, with the nearest name. O(names * objects).
Result<std::vector<ObjectId>> objects_named(const Document& document, std::span<const std::string> names);

/// "3 vertices", "1 solid", "2 points": in the words of the object's kind. `object` may be null.
std::string describe_in(const Object* object, const ElementSelection& selection, const Language& tr);

/// Count of hidden elements that a box left out, and the keys of the command that takes it too; empty where
/// nothing was, or something else is selected by now.
std::string left_out_text(const Editor& editor, const std::string& keys);

}  // namespace hariko
