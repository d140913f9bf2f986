// Which commands the context menus show, by what is under the pointer.

#include "ui/commands/command_host.hpp"

namespace hariko {

void fill_context_menus(CommandTable& table) {
  using enum Context;
  table.show_in(vertex | edge, {"shape.reset_tension"});
  table.show_in(vertex, {"shape.corner"});
  table.show_in(edge, {"shape.crease"});
  table.show_in(any_element | object, {"transform.move", "transform.rotate", "transform.scale"});
  table.show_in(any_element, {"select.all", "select.none", "view.frame_selection"});
  table.show_in(object, {"object.duplicate", "object.delete", "view.frame_selection"});
  table.show_in(empty, {"file.import", "edit.undo", "edit.redo", "select.all", "view.frame_all", "view.four",
                        "view.orthographic", "view.x_ray", "view.grid"});
}

}  // namespace hariko
