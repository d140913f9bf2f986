#pragma once

// Tips: the help of what is under the pointer, beside the panel, dialog or menu that it belongs to.

#include <imgui.h>

#include <functional>
#include <string>

namespace hariko {

/// Shows a text for the last item, already translated; nothing when it is empty. It stands left of the panel
/// or dialog, right of it where the left has no room, narrower where both have little, and above the item
/// where neither has any: so it never covers the next rows. Nothing while something is typed or an item is
/// held.
void show_tip(const char* text);
void show_tip(const std::string& text);

/// Shows a text at the pointer, for what is drawn there, already translated.
void pointer_tip(const std::string& text);

/// Area that a tip leaves free: the panel or dialog of the last item, or the menus that are open.
enum class TipBeside { panel, menu };

/// Gives the tip that begins next its place, as `show_tip` does. `size` tells how large its text is with
/// lines of at most a width; the width to use.
float place_tip(TipBeside beside, const std::function<ImVec2(float width)>& size);

}  // namespace hariko
