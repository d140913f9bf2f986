#pragma once

// Saved views of a document as cameras, and what commands and menus do with them.

#include <string>
#include <string_view>

#include "core/document/saved_view.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Look of a camera under a name. Focal lengths out of range are brought into it, with the target's plane as
/// large as before.
SavedView saved_view_of(const Camera& camera, std::string name);
/// Camera of a saved view.
Camera camera_of(const SavedView& view);
/// Whether a camera looks as a saved view does, up to rounding.
bool looks_as(const Camera& camera, const SavedView& view);

/// Saved view that was gone to or saved last, else the last one of the list; null where the document has
/// none.
const SavedView* chosen_view(const Editor& editor);

/// Name for a new view, in the language of the interface as those of new objects are: the first of "View 1",
/// "View 2" ... that is free. O(views squared).
std::string name_for_new_view(const Editor& editor);
/// Saves the look of the active view under a name, and tells the script. True when it was saved.
bool save_view(Editor& editor, std::string name);
/// Flies there in the active view. A view that keeps its direction turns freely afterwards where it looks
/// from elsewhere. False, with a notice, where there is no such view.
bool go_to_view(Editor& editor, std::string_view name);
/// Puts the look of the active view in the place of a saved one.
bool take_over_view(Editor& editor, const std::string& name);
bool name_view(Editor& editor, const std::string& name, const std::string& next);
bool delete_view(Editor& editor, const std::string& name);

}  // namespace hariko
