#pragma once

// Tips: the help of what is under the pointer, beside the panel or dialog that it belongs to.

#include <string>

namespace hariko {

/// Shows a text for the last item, already translated; nothing when it is empty. It stands left of the panel
/// or dialog, right of it where the left has no room, narrower where both have little, and above the item
/// where neither has any: so it never covers the next rows. Nothing while a field is typed into or an item is
/// held.
void show_tip(const char* text);
void show_tip(const std::string& text);

}  // namespace hariko
