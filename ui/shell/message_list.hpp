#pragma once

// The messages about an object: why its surface failed, and what validation warns of.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Draws nothing when there is nothing to say. A click on a message selects its element and frames it. Marks:
/// "message.0" ...
void draw_message_list(PanelContext& context, const Object& object);

/// Selects what a message is about and brings it into view. False when it names no element.
bool show_element(Editor& editor, ObjectId object, const Element& element);

}  // namespace hariko
