#include "ui/workbench.hpp"

#include <imgui_internal.h>

#include <GLFW/glfw3.h>

#include <algorithm>

#include "ui/icons.hpp"

namespace hariko {

Workbench::Workbench(Editor& editor, Renderer& renderer, int quick_samples, const Metrics& metrics,
                     FileActions actions)
    : editor_(editor),
      viewport_(editor, renderer, quick_samples),
      metrics_(metrics),
      actions_(std::move(actions)),
      host_{commands_, editor_, viewport_, *this} {
  add_commands();
}

void Workbench::add_commands() {
  // Menus stand in the order of these lines.
  add_file_commands(host_);
  add_edit_commands(host_);
  add_select_commands(host_);
  add_transform_commands(host_);
  add_shape_commands(host_);
  add_view_commands(host_);
  add_language_commands(host_);
  // A tool works on the document that it found: whatever changes it ends the tool first.
  commands_.before_run([this](const Command& command) {
    if (!command.changes_document) return;
    viewport_.cancel_tool();
    if (editor_.history.in_gesture()) editor_.cancel_preview();
  });
}

void Workbench::frame() {
  marks_.clear();
  PanelContext context{editor_,
                       commands_,
                       marks_,
                       metrics_,
                       panel_state_,
                       samples_,
                       [this](const std::filesystem::path& path) { open_guarded(path); },
                       viewport_.hint(),
                       editor_.language,
                       offers_,
                       actions_.recover,
                       actions_.discard_recovery};
  layout(context);
  dialog_.draw(context);
  prompt_.draw(context);
}

void Workbench::layout(PanelContext& context) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float menu = draw_menu_bar(context);
  const float status = metrics_.px(26), tools = metrics_.px(44), line = metrics_.px(1);
  if (!editor_.has_document) {
    const PanelRect all{{0, menu}, screen};
    draw_start_page(context, all);
    draw_notices(context, all);
    return;
  }
  const float side = std::min(metrics_.px(editor_.settings.side_width), screen.x / 2);
  const PanelRect view{{tools, menu}, {screen.x - side - line, screen.y - status}};
  const float objects_height =
      std::clamp(metrics_.px(48 + 32 * static_cast<float>(editor_.document().objects.size())),
                 metrics_.px(96), metrics_.px(240));
  const float right = screen.x - side;
  draw_tool_column(context, {{0, menu}, {tools, screen.y - status}});
  viewport_.draw(context, view);
  draw_objects(context, {{right, menu}, {screen.x, menu + objects_height - line}});
  draw_properties(context, {{right, menu + objects_height}, {screen.x, screen.y - status}});
  context.tool_hint = viewport_.hint();
  draw_status_line(context, {{0, screen.y - status}, screen});
  draw_notices(context, view);

  drag_border({{right - metrics_.px(3), menu}, {right + metrics_.px(2), screen.y - status}});
}

void Workbench::drag_border(const PanelRect& border) {
  if (begin_panel("##border", border, 0, {0, 0}, ImGuiWindowFlags_NoBackground)) {
    ImGui::InvisibleButton("drag", {border.width(), border.height()});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive())
      editor_.settings.side_width = std::clamp(
          editor_.settings.side_width - ImGui::GetIO().MouseDelta.x / metrics_.scale, 260.0F, 480.0F);
  }
  ImGui::End();
}

void Workbench::key(const KeyPress& press) {
  const KeyChord& chord = press.chord;
  if (chord.key == GLFW_KEY_ESCAPE) return escape();
  // While a field takes text or a dialog is open the keys are theirs.
  if (ImGui::GetIO().WantTextInput || dialog_.is_open() || prompt_.is_open()) return;
  // A running tool takes its own keys first: axes, numbers, Enter.
  if (viewport_.tool_key(press)) return;
  const Command* command = commands_.find(chord);
  if (!command) return;
  // In the middle of a drag or a modal tool the view may change, and nothing else.
  if (viewport_.tool_active() && command->menu != "View") return;
  if (editor_.history.in_gesture() && command->changes_document) return;
  const auto outcome = commands_.run(*command);
  if (!outcome.ran) editor_.notify(Notice::Kind::info, editor_.language.phrase(outcome.reason));
}

void Workbench::escape() {
  if (prompt_.is_open()) return prompt_.dismiss();
  if (dialog_.is_open()) return dialog_.close();
  if (viewport_.cancel_tool()) return;
  if (editor_.history.in_gesture()) {
    editor_.cancel_preview();
    ImGui::ClearActiveID();  // the slider lets go
    return;
  }
  if (ImGui::GetIO().WantTextInput) return;  // the field restores its text
  if (!editor_.notices().empty())
    editor_.notices().clear();
  else
    editor_.selection.clear_elements();
}

void Workbench::guarded(std::function<void()> action) {
  if (!editor_.has_document || !editor_.history.dirty()) return action();
  const Language& tr = editor_.language;
  ask({tr("Unsaved changes"),
       fill(tr("{0} has changes that are not saved."), {tr(editor_.title())}),
       {{tr("Save"), "save", [this, action] { save(action); }},
        {tr("Discard"), "discard", action},
        {tr("Cancel"), "cancel", {}}}});
}

void Workbench::open_guarded(const std::filesystem::path& path) {
  guarded([this, path] { actions_.open(path); });
}

void Workbench::save(std::function<void()> then) {
  if (editor_.path)
    actions_.save(*editor_.path, std::move(then));
  else
    save_as(std::move(then));
}

void Workbench::save_as(std::function<void()> then) {
  const std::filesystem::path proposal =
      editor_.path ? *editor_.path : std::filesystem::path("Untitled.hariko");
  dialog_.open({translatable("Save as"),
                translatable("Save"),
                true,
                {".hariko"},
                proposal,
                [this, then = std::move(then)](const auto& path) { actions_.save(path, then); }});
}

void Workbench::show_export_dialog() {
  std::filesystem::path proposal = folder_proposal() / (editor_.path ? editor_.path->stem() : "Untitled");
  proposal += ".obj";
  dialog_.open({translatable("Export the surfaces as triangles"),
                translatable("Export"),
                true,
                {".obj", ".stl", ".ply"},
                proposal,
                [this](const auto& path) { actions_.export_file(path, export_density_); },
                [this] {
                  ImGui::AlignTextToFramePadding();
                  ImGui::TextUnformatted(editor_.language("Density"));
                  ImGui::SameLine(metrics_.px(80));
                  ImGui::SetNextItemWidth(metrics_.px(220));
                  ImGui::SliderInt(editor_.language("intervals a patch side"), &export_density_, 1, 64);
                }});
}

void Workbench::show_open_dialog() {
  dialog_.open({translatable("Open"),
                translatable("Open"),
                false,
                {".hariko", ".obj", ".off", ".ply", ".stl"},
                folder_proposal(),
                [this](const auto& path) { open_guarded(path); }});
}

void Workbench::show_import_dialog() {
  dialog_.open({translatable("Import a mesh"),
                translatable("Import"),
                false,
                {".obj", ".off", ".ply", ".stl"},
                folder_proposal(),
                [this](const auto& path) { actions_.import_file(path); }});
}

void Workbench::close_document() {
  guarded([this] {
    editor_.open({}, {});
    editor_.has_document = false;
  });
}

std::filesystem::path Workbench::folder_proposal() const {
  return editor_.path ? editor_.path->parent_path() : std::filesystem::path();
}

}  // namespace hariko
