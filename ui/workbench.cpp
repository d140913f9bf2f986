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
      actions_(std::move(actions)) {
  add_file_commands();
  add_edit_commands();
  add_select_commands();
  add_shape_commands();
  add_view_commands();
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
                       viewport_.hint()};
  layout(context);
  dialog_.draw(context);
  draw_unsaved_prompt();
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
  const float side = std::min(metrics_.px(side_width_), screen.x / 2);
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

  // The border of the side panel can be dragged.
  const PanelRect border{{right - metrics_.px(3), menu}, {right + metrics_.px(2), screen.y - status}};
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);
  if (begin_panel("##border", border, 0, {0, 0}, ImGuiWindowFlags_NoBackground)) {
    ImGui::InvisibleButton("drag", {border.width(), border.height()});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive())
      side_width_ = std::clamp(side_width_ - ImGui::GetIO().MouseDelta.x / metrics_.scale, 260.0F, 480.0F);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void Workbench::key(const KeyChord& chord) {
  if (chord.key == GLFW_KEY_ESCAPE) return escape();
  // While a field takes text or a dialog is open the keys are theirs.
  if (ImGui::GetIO().WantTextInput || dialog_.is_open() || unsaved_action_) return;
  const Command* command = commands_.find(chord);
  if (!command) return;
  // In the middle of a drag nothing else may change the document.
  if (editor_.history.in_gesture() && command->changes_document) return;
  const auto outcome = commands_.run(*command);
  if (!outcome.ran) editor_.notify(Notice::Kind::info, outcome.reason);
}

void Workbench::escape() {
  if (unsaved_action_) {
    unsaved_action_ = nullptr;
    return;
  }
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
  if (editor_.has_document && editor_.history.dirty())
    unsaved_action_ = std::move(action);
  else
    action();
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

void Workbench::draw_unsaved_prompt() {
  constexpr const char* id = "Unsaved changes";
  const bool shown = ImGui::IsPopupOpen(id);
  if (!unsaved_action_ && !shown) return;
  if (!shown) ImGui::OpenPopup(id);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  if (!ImGui::BeginPopupModal(id, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
    return;
  ImGui::Text("%s has changes that are not saved.", editor_.title().c_str());
  ImGui::Dummy({0, metrics_.px(8)});
  const ImVec2 button(metrics_.px(110), 0);
  const bool save_it = ImGui::Button("Save", button);
  marks_.item("prompt.save");
  ImGui::SameLine();
  const bool discard = ImGui::Button("Discard", button);
  marks_.item("prompt.discard");
  ImGui::SameLine();
  const bool cancel = ImGui::Button("Cancel", button);
  marks_.item("prompt.cancel");
  if (!unsaved_action_) ImGui::CloseCurrentPopup();  // Esc
  if (unsaved_action_ && (save_it || discard || cancel)) {
    ImGui::CloseCurrentPopup();
    const auto action = std::move(unsaved_action_);
    unsaved_action_ = nullptr;
    if (save_it) save(action);
    if (discard) action();
  }
  ImGui::EndPopup();
}

std::optional<std::string> Workbench::needs_document() const {
  if (editor_.has_document) return {};
  return "Nothing is open. Open a file or a sample first.";
}

std::optional<std::string> Workbench::needs_object() const {
  if (auto reason = needs_document()) return reason;
  if (editor_.active_object()) return {};
  return "No object is chosen. Choose one in the list of objects.";
}

std::filesystem::path Workbench::folder_proposal() const {
  return editor_.path ? editor_.path->parent_path() : std::filesystem::path();
}

}  // namespace hariko
