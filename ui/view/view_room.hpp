#pragma once

// Room of the views: panels beside them take some of it and give it back.

#include "ui/editor/editor.hpp"

namespace hariko {

/// After a panel beside the views was opened (`narrower`), or before one closes. What is seen as a whole
/// stays so and fills its view again; a view that was turned to a part stays where it is.
void change_room_of_views(Editor& editor, bool narrower);

}  // namespace hariko
