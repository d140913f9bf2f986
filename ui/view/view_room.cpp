#include "ui/view/view_room.hpp"

#include <cmath>

namespace hariko {

void change_room_of_views(Editor& editor, bool narrower) {
  // Half the view is left, which would cut the model off.
  if (narrower) {
    editor.wants_framing = true;
    return;
  }
  const Camera now = editor.layout.active_view().goal();
  editor.frame_all(true);
  const Camera framed = editor.layout.active_view().goal();
  editor.set_camera(now);
  constexpr double close = 1e-6;  // of the distance
  const bool whole = std::abs(framed.distance - now.distance) <= close * now.distance &&
                     (framed.target - now.target).norm() <= close * now.distance;
  if (whole) editor.wants_framing = true;
}

}  // namespace hariko
