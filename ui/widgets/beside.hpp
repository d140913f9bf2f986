#pragma once

// A second view beside those of the model.

#include <functional>

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Divides a view: `draw` fills its right part from `split` on, a fraction of the width, and a border between
/// the parts moves the split. Returns the left part. `mark`: of the border, such as "paper.border".
PanelRect draw_beside(PanelContext& context, const PanelRect& view, const char* mark, float& split,
                      const std::function<void(const PanelRect&)>& draw);

}  // namespace hariko
