#include "ui/shell/context_menu.hpp"

#include <imgui_internal.h>

#include <cmath>
#include <string_view>

#include "ui/editor/command_host.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/view/tool.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"

namespace hariko {

namespace {

Context context_of(const Editor& editor, const std::optional<ElementRef>& element) {
  if (!element) return Context::empty;
  if (editor.mode == ElementMode::object) return Context::object;
  switch (element->element.kind) {
    case Element::Kind::vertex:
      return Context::vertex;
    case Element::Kind::edge:
      return Context::edge;
    case Element::Kind::face:
      return Context::face;
    default:
      return Context::object;
  }
}

/// "Vertex 12 · Car body", or what the view shows.
std::string title_of(const PanelContext& context, const std::optional<ElementRef>& element) {
  const Language& tr = context.tr;
  const Object* object = element ? context.editor.document().find(element->object) : nullptr;
  if (!object) return element ? std::string() : context.editor.title();
  const std::string& name = object->name;
  if (context.editor.mode == ElementMode::object || element->element.kind == Element::Kind::none) return name;
  std::string text = object_kind(*object).title(element->element, tr);
  const ElementSelection& selection = context.editor.selection.of(element->object);
  if (selection.size() > 1 && context.editor.selection.contains(*element))
    text = describe_in(object, selection, tr);
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text + "  \u00b7  " + name;
}

bool pointer_in_viewport(const PanelRect& rect) {
  const ImGuiWindow* window = GImGui->HoveredWindow;
  return window && std::string_view(window->RootWindow->Name).starts_with("Viewport") &&
         ImGui::IsMouseHoveringRect(rect.min, rect.max, false);
}

}  // namespace

void ContextMenu::watch(Editor& editor, const PanelRect& viewport, const std::optional<ElementRef>& hovered,
                        bool tool_ran) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    armed_ = !tool_ran && pointer_in_viewport(viewport) && !io.KeyShift && !io.KeyCtrl && !io.KeyAlt;
    pressed_ = hovered;
    at_ = io.MousePos;
  }
  if (!armed_) return;
  const ImVec2 by(io.MousePos.x - at_.x, io.MousePos.y - at_.y);
  const double threshold = drag_threshold * editor.pixel_scale / double(io.DisplayFramebufferScale.x);
  if (std::hypot(double(by.x), double(by.y)) > threshold || ImGui::IsMouseDown(ImGuiMouseButton_Left))
    armed_ = false;  // it moves the view
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Right)) return;
  if (armed_) {
    about_ = pressed_;
    wanted_ = true;
    if (about_ && !editor.selection.contains(*about_)) {
      editor.selection.select(*about_, Selection::How::replace);
      // The document may have changed since the press.
      editor.selection.prune(editor.history.current());
    }
  }
  armed_ = false;
}

void ContextMenu::open(const Editor& editor) {
  about_ = editor.hovered;
  at_ = ImGui::GetIO().MousePos;
  wanted_ = true;
}

void ContextMenu::draw(PanelContext& context) {
  if (wanted_) ImGui::OpenPopup("###context");
  wanted_ = false;
  if (!ImGui::IsPopupOpen("###context")) return;
  ImGui::SetNextWindowPos(at_, ImGuiCond_Appearing);
  const Metrics& m = context.metrics;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(m.px(10), m.px(8)));
  const OpenScope menu = popup_scope("###context", ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (!menu) return;
  dim_text(title_of(context, about_));
  context.marks.item("context.title");
  ImGui::Separator();
  draw_menu_nodes(context, context_menu_tree(context.commands, context_of(context.editor, about_)),
                  "context.");
}

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
