#pragma once

// Sections that run the same way round.

#include "core/skinning/skin.hpp"

namespace hariko {

/// Turns sections round whose direction the designer has not chosen: closed ones where that brings them
/// nearer to the section before, each way round from the start of the least displacement
/// (section_starts.hpp); open ones where that brings 32 points at equal parameters nearer to the section
/// before, by more than 1% of the sum of squares. Links keep their points. Used where sections come in; a
/// skin that is edited is never turned by itself.
Skin turn_sections(Skin skin);

}  // namespace hariko
