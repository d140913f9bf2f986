#pragma once

// What is selected, in words that fit the object.

#include <string>

#include "ui/editor/editor.hpp"

namespace hariko {

/// "3 vertices", "1 solid", "2 points": in the words of the object's kind. `object` may be null.
std::string describe_in(const Object* object, const ElementSelection& selection, const Language& tr);

/// Count of hidden elements that a box left out, and the keys of the command that takes it too; empty where
/// nothing was, or something else is selected by now.
std::string left_out_text(const Editor& editor, const std::string& keys);

}  // namespace hariko
