#include "ui/panels.hpp"

#include "ui/icons.hpp"

namespace hariko {

void PanelContext::run(std::string_view id) {
  const auto outcome = commands.run(id);
  if (!outcome.ran) editor.notify(Notice::Kind::info, outcome.reason);
}

bool begin_panel(const char* name, const PanelRect& rect, ImU32 background, ImVec2 padding,
                 ImGuiWindowFlags extra) {
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize({rect.width(), rect.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
  const bool open =
      ImGui::Begin(name, nullptr,
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar |
                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                       ImGuiWindowFlags_NoSavedSettings | extra);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  return open;
}

void heading(const PanelContext& context, const char* text) {
  ImGui::Dummy({0, context.metrics.px(2)});
  const TextColour colour(palette().dim_text);
  ImGui::TextUnformatted(text);
}

bool icon_button(const PanelContext& context, const char* icon, const char* id, const char* tooltip, bool on,
                 float size) {
  const ImVec2 box(context.metrics.px(size), context.metrics.px(size));
  ImGui::PushID(id);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton("button", box);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + box.x, at.y + box.y);
  if (on || hovered)
    draw.AddRectFilled(at, end,
                       on ? (palette().accent & 0x00ffffff) | (0x40u << IM_COL32_A_SHIFT) : palette().field,
                       context.metrics.px(4));
  const ImVec2 text = ImGui::CalcTextSize(icon);
  draw.AddText({at.x + (box.x - text.x) / 2, at.y + (box.y - text.y) / 2},
               on        ? palette().accent
               : hovered ? palette().text
                         : palette().dim_text,
               icon);
  if (hovered && *tooltip) ImGui::SetTooltip("%s", tooltip);
  ImGui::PopID();
  return pressed;
}

float draw_menu_bar(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.metrics.px(10), context.metrics.px(6)));
  const bool open = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!open) return 0;
  for (const std::string& menu : context.commands.menus()) {
    const bool shown = ImGui::BeginMenu(menu.c_str());
    context.marks.item("menu." + menu);
    if (!shown) continue;
    for (const Command& command : context.commands.all()) {
      if (command.menu != menu) continue;
      if (command.separator_before) ImGui::Separator();
      const auto reason = command.why_not ? command.why_not() : std::nullopt;
      const std::string keys = command.keys.substr(0, command.keys.find(" / "));
      if (ImGui::MenuItem(command.label.c_str(), keys.c_str(), command.checked && command.checked(), !reason))
        command.run();
      context.marks.item("command." + command.id);
      if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", reason ? reason->c_str() : command.help.c_str());
    }
    ImGui::EndMenu();
  }
  const Editor& editor = context.editor;
  if (editor.has_document) {
    std::string title = editor.title();
    if (editor.history.dirty()) title += "  \u2022  edited";
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - context.metrics.px(28));
    const TextColour colour(palette().dim_text);
    ImGui::TextUnformatted(title.c_str());
  }
  const float height = ImGui::GetWindowHeight();
  ImGui::EndMainMenuBar();
  return height;
}

namespace {

void command_button(PanelContext& context, const char* id) {
  const Command& command = *context.commands.find(id);
  const auto reason = command.why_not ? command.why_not() : std::nullopt;
  std::string tooltip = command.label;
  if (!command.keys.empty()) tooltip += "   " + command.keys;
  tooltip += "\n" + (reason ? *reason : command.help);
  if (reason) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4F);
  if (icon_button(context, command.icon, id, tooltip.c_str(), command.checked && command.checked(), 36) &&
      !reason)
    command.run();
  if (reason) ImGui::PopStyleVar();
  context.marks.item(std::string("button.") + id);
}

void gap(PanelContext& context) {
  ImGui::Dummy({1, context.metrics.px(8)});
}

}  // namespace

void draw_tool_column(PanelContext& context, const PanelRect& rect) {
  const float pad = context.metrics.px(4);
  if (begin_panel("Tools", rect, palette().window, {pad, context.metrics.px(8)},
                  ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, context.metrics.px(2)));
    for (const char* id : {"select.vertices", "select.edges", "select.faces"}) command_button(context, id);
    gap(context);
    for (const char* id : {"edit.undo", "edit.redo"}) command_button(context, id);
    gap(context);
    for (const char* id : {"view.frame_all", "view.x_ray"}) command_button(context, id);
    ImGui::PopStyleVar();
  }
  ImGui::End();
}

void draw_objects(PanelContext& context, const PanelRect& rect) {
  Editor& editor = context.editor;
  if (begin_panel("Objects", rect, palette().panel, {context.metrics.px(12), context.metrics.px(8)})) {
    heading(context, "Objects");
    const Document document = editor.document();
    for (const auto& object : document.objects) {
      ImGui::PushID(static_cast<int>(object->id.value));
      const bool active = object->id == editor.selection.active;
      const float side = context.metrics.px(26);
      const float row = ImGui::GetContentRegionAvail().x;
      if (ImGui::Selectable("##row", active, ImGuiSelectableFlags_AllowItemOverlap, {0, side})) {
        if (!active) editor.selection.clear_elements();
        editor.selection.active = object->id;
      }
      context.marks.item("object." + std::to_string(object->id.value));
      ImGui::SetItemAllowOverlap();
      ImGui::SameLine(context.metrics.px(18));
      ImGui::AlignTextToFramePadding();
      ImGui::Text("%s  %s", icon::object, object->name.c_str());
      const SurfaceView* view = editor.view_of(object->id);
      const bool failed = view && view->error;
      const bool warned = view && !view->warnings.empty();
      if (failed || warned) {
        ImGui::SameLine(row - side + context.metrics.px(-14));
        const TextColour colour(failed ? palette().error : palette().warning);
        ImGui::TextUnformatted(failed ? icon::error : icon::warning);
        if (ImGui::IsItemHovered())
          ImGui::SetTooltip("%s", failed ? view->error->text.c_str() : view->warnings.front().text.c_str());
      }
      ImGui::SameLine(row - side + context.metrics.px(12));
      if (icon_button(context, object->visible ? icon::shown : icon::hidden, "visible",
                      object->visible ? "Hide" : "Show", false, 26))
        editor.commit(set_visible(editor.history.current(), object->id, !object->visible),
                      object->visible ? "Hide object" : "Show object");
      ImGui::PopID();
    }
    if (document.objects.empty()) ImGui::TextDisabled("No objects. Import a mesh to begin.");
  }
  ImGui::End();
}

void draw_status_line(PanelContext& context, const PanelRect& rect) {
  const Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  if (begin_panel("Status", rect, palette().window, {m.px(12), m.px(5)}, ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    ImGui::TextUnformatted(context.tool_hint.c_str());
    std::string right;
    ImU32 colour = palette().dim_text;
    if (const Object* object = editor.active_object(); object && editor.has_document) {
      if (const PolyhedronSource* source = object->polyhedron()) {
        const Polyhedron& p = source->polyhedron;
        right = std::to_string(p.vertex_count()) + " vertices  " + std::to_string(p.edge_count()) +
                " edges  " + std::to_string(p.face_count()) + " faces";
      }
      const SurfaceView* view = editor.view_of(object->id);
      if (view && view->error) {
        right = view->error->text;
        colour = palette().error;
      } else if (view) {
        right += "   \u00b7   " + format_number(view->milliseconds, 3) + " ms";
        if (view->largest_normal_jump)
          right += *view->largest_normal_jump < 1e-9
                       ? std::string("   \u00b7   tangent-continuous")
                       : "   \u00b7   largest kink " +
                             format_number(*view->largest_normal_jump * 57.29577951, 3) + "\u00b0";
      }
      if (!editor.stale_since.empty()) right = "computing\u2026   " + right;
    }
    if (!editor.job.empty()) right = editor.job + "\u2026   " + right;
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    const float left_end = ImGui::GetItemRectMax().x - rect.min.x + m.px(16);
    ImGui::SameLine(std::max(left_end, rect.width() - width - m.px(12)));
    const TextColour text(colour);
    ImGui::TextUnformatted(right.c_str());
    context.marks.item("status.right");
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace hariko
