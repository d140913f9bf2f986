#pragma once

// Fields to type in, and what the keyboard does in them. A mark is also the name of its field for ImGui.

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "ui/base/marks.hpp"

namespace hariko {

/// Text that the arrow up (1) or down (-1) makes of the one in a field; nothing leaves it.
using ArrowKeys = std::function<std::optional<std::string>(const std::string& text, int direction)>;

/// A field with a text, of a width in pixels; -1 for the rest of the row. `hint` stands in it while it is
/// empty. True when the text changed; with ImGuiInputTextFlags_EnterReturnsTrue when Enter was pressed.
bool text_field(Marks& marks, const std::string& mark, std::string& text, float width, const char* hint = "",
                ImGuiInputTextFlags flags = 0, ArrowKeys arrows = {});

/// A colour, as red, green and blue from 0 to 1, over the rest of the row. True when it changed.
bool colour_field(Marks& marks, const std::string& mark, std::array<float, 3>& colour);

/// Arrow keys in this frame, repeated while they are held: 1 for down, -1 for up.
int arrow_step();

}  // namespace hariko
