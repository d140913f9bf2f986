#include "app/commands/saved_view_camera.hpp"

#include "core/document/edits/edit_views.hpp"
#include "ui/editor/saved_views.hpp"

namespace hariko {

Result<Camera> camera_for(const Document& document, const std::string& saved, StandardView side,
                          const Box3& box, PixelSize size) {
  if (saved.empty()) return Camera::standard(side).frame(box, size);
  if (const SavedView* found = find_view(document, saved)) return camera_of(*found);
  std::string names;
  for (const SavedView& view : *document.saved_views) names += (names.empty() ? "" : ", ") + view.name;
  return make_error(e_unknown_view, "There is no saved view called \"" + saved + "\".",
                    names.empty() ? "The document has none: save a view in the window first."
                                  : "Choose one of these: " + names + ".");
}

}  // namespace hariko
