#include "ui/shell/message_list.hpp"

#include <algorithm>

#include "core/patching/joins/join.hpp"
#include "ui/base/icons.hpp"
#include "ui/outline/outline_rows.hpp"
#include "ui/polyhedron/polyhedron_rows.hpp"
#include "ui/skin/skin_properties.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

/// One message with its remedy; true when it was clicked.
bool message_row(PanelContext& context, const Message& message, int number) {
  const bool error = message.severity == Severity::error;
  const bool names_element = message.element.kind != Element::Kind::none;
  const float start = ImGui::GetCursorPosX();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::BeginGroup();
  coloured_text(error ? palette().error : palette().warning, error ? icon::error : icon::warning);
  ImGui::SameLine(start + context.metrics.px(10));
  ImGui::BeginGroup();
  text_in_lines(context.tr.text_of(message));
  if (const std::string remedy = context.tr.remedy_of(message); !remedy.empty())
    coloured_lines(palette().dim_text, remedy);
  ImGui::EndGroup();
  ImGui::EndGroup();
  context.marks.item("message." + std::to_string(number));
  if (!names_element || !ImGui::IsItemHovered()) return false;
  const float right = low.x + ImGui::GetWindowContentRegionMax().x - start;
  ImGui::GetWindowDrawList()->AddRect({low.x - context.metrics.px(4), low.y - context.metrics.px(2)},
                                      {right, ImGui::GetItemRectMax().y + context.metrics.px(2)},
                                      palette().secondary, context.metrics.px(4));
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  show_tip(context.tr("Click to select it and look at it."));
  return ImGui::IsMouseClicked(0);
}

/// Joined patches that do not fit: one of them can follow the surface instead.
void draw_adapt(PanelContext& context, const Message& error) {
  if (!(error.code == e_join_corner) && !(error.code == e_join_twist)) return;
  if (text_button(context.marks, "button.adapt_patch", context.tr("Let the patch adapt"), -1))
    context.run("shape.adapt_patch");
}

}  // namespace

bool show_element(Editor& editor, ObjectId object, const Element& element) {
  if (element.kind == Element::Kind::none || element.kind == Element::Kind::line) return false;
  if (element.kind == Element::Kind::object) {
    editor.selection.active = ObjectId{static_cast<std::uint32_t>(element.id)};
    editor.selection.clear_elements();
  } else {
    editor.selection.select({object, element}, Selection::How::replace);
    editor.selection.prune(editor.document());
    if (element.kind == Element::Kind::vertex) editor.mode = ElementMode::vertex;
    if (element.kind == Element::Kind::edge) editor.mode = ElementMode::edge;
    if (element.kind == Element::Kind::face) editor.mode = ElementMode::face;
  }
  editor.frame_selection();
  return true;
}

void draw_message_list(PanelContext& context, const Object& object) {
  const SurfaceView* view = context.editor.view_of(object.id);
  if (!view || (!view->error && view->warnings.empty())) return;
  const std::size_t count = view->warnings.size() + (view->error ? 1 : 0);
  heading(context, (std::string(context.tr("Messages")) + "  " + std::to_string(count)).c_str());
  // A clicked row changes the selection, not the list; still, act after the loop.
  std::optional<Element> clicked;
  int number = 0;
  const auto row = [&](const Message& message) {
    ImGui::PushID(number);
    if (message_row(context, message, number)) clicked = message.element;
    ImGui::PopID();
    ++number;
  };
  if (view->error) row(*view->error);
  constexpr std::size_t most = 200;  // rows of any height in one frame
  for (std::size_t i = 0; i < std::min(most, view->warnings.size()); ++i) row(view->warnings[i]);
  if (view->warnings.size() > most)
    dim_text(fill(context.tr("and {0} more"), {std::to_string(view->warnings.size() - most)}));
  if (view->error) draw_adapt(context, *view->error);
  if (view->error) draw_outline_fix(context, object, *view->error);
  draw_concave_fix(context, object, view->warnings);
  draw_skin_fix(context, object, *view);
  if (clicked) show_element(context.editor, object.id, *clicked);
}

}  // namespace hariko
