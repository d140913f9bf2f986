// Which commands the context menus show, by what is under the pointer.

#include "ui/editor/command_host.hpp"

namespace hariko {

void fill_context_menus(CommandTable& table) {
  using enum Context;
  // Those of the Mesh menu say themselves where they stand.
  table.show_in(vertex | edge, {"shape.tension", "shape.reset_tension"});
  table.show_in(vertex, {"shape.corner", "shape.smooth_ends"});
  table.show_in(edge, {"shape.crease", "shape.attach", "shape.release_edges", "select.loop", "select.ring",
                       "mesh.extrude"});
  table.show_in(face, {"plane.face"});
  table.show_in(any_element | object, {"transform.move", "transform.rotate", "transform.scale"});
  table.show_in(any_element, {"select.all", "select.none", "select.linked", "view.frame_selection"});
  table.show_in(
      object, {"object.duplicate", "view.frame_selection", "mirror.live_x", "mirror.live_y", "mirror.live_z",
               "mirror.apply", "mirror.object_x", "mirror.object_y", "mirror.object_z"});
  table.show_in(empty, {"file.import", "edit.undo", "edit.redo", "select.all", "view.frame_all", "view.four",
                        "view.orthographic", "view.x_ray", "view.grid"});
}

}  // namespace hariko
