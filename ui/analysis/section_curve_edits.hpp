#pragma once

// Changes of the section curves that commands and rows share.

#include "ui/editor/editor.hpp"

namespace hariko {

struct CommandHost;

inline constexpr double least_section_spacing = 1e-6;  ///< document's unit

/// Shows or hides the curves. The planes are spread over what is visible where none of them meets it.
void show_section_curves(Editor& editor, bool shown);
/// Spreads the planes evenly over what is visible.
void spread_sections(Editor& editor);
/// Gives the planes another direction (not zero), spread over what is visible.
void turn_section_planes(Editor& editor, const Vector3& direction);

/// Says how scripts use the commands of section curves, which must exist.
void use_sections_in_scripts(CommandHost& host);

}  // namespace hariko
