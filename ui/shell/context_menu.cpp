#include "ui/shell/context_menu.hpp"

#include <imgui_internal.h>

#include <cctype>
#include <cmath>
#include <string_view>

#include "ui/editor/selection_text.hpp"
#include "ui/view/tool.hpp"
#include "ui/widgets/command_menu.hpp"

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
  if (!element) return context.editor.title();
  const Object* object = context.editor.document().find(element->object);
  const std::string name = object ? object->name : std::string();
  if (context.editor.mode == ElementMode::object || element->element.kind == Element::Kind::none) return name;
  std::string text = to_string(element->element);
  const std::size_t space = text.find(' ');
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));  // as the catalogue has it
  text = tr(text.substr(0, space)) + text.substr(space);
  if (object && object->solids()) text = fill(tr("Solid {0}"), {std::to_string(element->element.id)});
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
  const bool drawn =
      ImGui::BeginPopup("###context", ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (!drawn) return;
  ImGui::TextDisabled("%s", title_of(context, about_).c_str());
  context.marks.item("context.title");
  ImGui::Separator();
  draw_menu_nodes(context, context_menu_tree(context.commands, context_of(context.editor, about_)),
                  "context.");
  ImGui::EndPopup();
}

}  // namespace hariko
