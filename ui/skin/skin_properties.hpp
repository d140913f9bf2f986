#pragma once

// Part of the properties: how the active skin is made, and its selected points.

#include <functional>
#include <string>
#include <vector>

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Nothing where the active object is no skin.
void draw_skin_properties(PanelContext& context);

/// A choice of one of the lists, by what it is called.
struct SkinChoice {
  std::string id;                   ///< "skin_frame.3"
  const char *list, *label, *help;  ///< English; the list is what its row is called
  std::function<void(Editor&, const Object&)> choose;
};
/// Those of the lists that every skin has.
std::vector<SkinChoice> skin_choices();

/// A button that does what the remedy of a skin's message says, where one click can.
void draw_skin_fix(PanelContext& context, const Object& object, const SurfaceView& view);

}  // namespace hariko
