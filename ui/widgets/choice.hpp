#pragma once

// A labelled combo box over a fixed list of choices.

#include <optional>
#include <span>
#include <string>

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Both in English; translated where they are shown.
struct Choice {
  const char* label;
  const char* help;
};

/// Returns the new choice. `current` < 0 shows "mixed". Marks: "combo.<id>" and "choice.<id>.<number>".
std::optional<int> choose(PanelContext& context, const char* id, const char* label, const char* help,
                          std::span<const Choice> choices, int current);

}  // namespace hariko
