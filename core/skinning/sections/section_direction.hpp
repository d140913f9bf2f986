#pragma once

// Consistent direction of sections.

#include "core/skinning/skin.hpp"

namespace hariko {

/// Reverses sections whose direction the designer has not chosen: closed ones where that brings them nearer
/// to the section before, comparing both directions at their best starts (section_starts.hpp); open ones
/// where that brings 32 points at equal parameters nearer to the section before, by more than 1% of the sum
/// of squares. Links keep their points. Used for imported and new sections; editing a skin never reverses
/// sections automatically.
Skin turn_sections(Skin skin);

}  // namespace hariko
