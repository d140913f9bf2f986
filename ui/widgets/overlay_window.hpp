#pragma once

// Windows above all others, which take the pointer and the keys until they are closed: the palette, the cheat
// sheet, the box about the program.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Begins such a window while `open` is true; a click outside sets it to false. True when it is to be drawn:
/// pair with end_overlay() then.
bool begin_overlay(const char* id, bool& open, const PanelRect& rect, const Metrics& metrics);
void end_overlay();

/// Draws a key like the cap of a key, ending at `right`; gives the left end. Several chords one beside the
/// other.
float draw_keys(ImDrawList& list, const Metrics& metrics, float right, float y, std::string_view keys);
/// The width that `draw_keys` needs.
float keys_width(const Metrics& metrics, std::string_view keys);

/// `text` cut to a width, with "…" where something is missing.
std::string elided(const std::string& text, float width);

}  // namespace hariko
