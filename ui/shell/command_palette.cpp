#include "ui/shell/command_palette.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/base/fuzzy.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_search.hpp"
#include "ui/editor/saved_views.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/overlay_window.hpp"

namespace hariko {

namespace {

constexpr int rows_shown = 9, page = 8;
constexpr float palette_row = 44, palette_width = 620;
constexpr std::size_t recent_kept = 12;

}  // namespace

void CommandPalette::open() {
  open_ = focus_ = true;
  accept_ = false;
  text_.clear();
  selected_ = step_ = 0;
  row_count_ = rows_shown;
}

void CommandPalette::key(const KeyChord& chord) {
  if (chord.key == Key::up) step_ = -1;
  if (chord.key == Key::down) step_ = 1;
  if (chord.key == Key::page_up) step_ = -page;
  if (chord.key == Key::page_down) step_ = page;
  if (chord.key == Key::enter) accept_ = true;
}

std::vector<CommandPalette::Row> CommandPalette::rows(const PanelContext& context) const {
  std::vector<Row> out;
  const Language& tr = context.tr;
  for (const Command* command : search_commands(context.commands, tr, text_, recent_)) {
    Row row;
    row.command = command;
    row.label = tr(command->label);
    row.path = menu_path(tr, *command);
    row.keys = command->keys;
    const auto reason = command->why_not ? command->why_not() : std::nullopt;
    row.refused = reason.has_value();
    row.detail = reason ? tr.phrase(*reason) : tr(command->help);
    out.push_back(std::move(row));
  }
  if (text_.empty() || !context.editor.has_document) return out;
  for (const auto& object : context.editor.document().objects) {
    if (fuzzy_score(text_, object->name) <= 0) continue;
    Row row;
    row.object = object->id;
    row.label = object->name;
    row.path = tr("Objects");
    row.detail = tr("Choose this object and come close to it.");
    out.push_back(std::move(row));
  }
  for (const SavedView& view : *context.editor.document().saved_views) {
    if (fuzzy_score(text_, view.name) <= 0) continue;
    Row row;
    row.view = row.label = view.name;
    row.path = tr("Saved views");
    row.detail = tr("Go to this view.");
    out.push_back(std::move(row));
  }
  return out;
}

void CommandPalette::draw(PanelContext& context, float top) {
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float wide = std::min(m.px(palette_width), screen.x - m.px(32));
  const float field = m.px(52), footer = m.px(8);
  const auto fitting = static_cast<int>((screen.y - top - m.px(32) - field - footer) / m.px(palette_row));
  const int shown = std::clamp(row_count_, 1, std::min(rows_shown, std::max(1, fitting)));
  const float left = (screen.x - wide) / 2,
              height = field + footer + m.px(palette_row) * static_cast<float>(shown);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(m.px(8), m.px(10)));
  const bool drawn =
      begin_overlay("###palette", open_, {{left, top + m.px(12)}, {left + wide, top + m.px(12) + height}}, m);
  ImGui::PopStyleVar();
  if (!drawn) {
    // After the popup is gone: the command may open another one.
    if (const std::string id = std::exchange(pending_, {}); !id.empty()) context.run(id);
    return;
  }
  if (focus_) ImGui::SetKeyboardFocusHere();
  focus_ = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(m.px(10), m.px(8)));
  if (text_field(context.marks, "palette.input", text_, wide - m.px(16),
                 context.tr("Search commands and objects"))) {
    selected_ = 0;
    scroll_ = true;
  }
  ImGui::PopStyleVar();
  // After the text took what was typed: Enter may have come in the same frame.
  const auto found = rows(context);
  row_count_ = static_cast<int>(found.size());
  if (step_ != 0) {
    selected_ += step_;
    scroll_ = true;
  }
  step_ = 0;
  selected_ = std::clamp(selected_, 0, std::max(0, static_cast<int>(found.size()) - 1));
  draw_rows(context, found);
  end_overlay();
}

void CommandPalette::draw_rows(PanelContext& context, const std::vector<Row>& rows) {
  const Metrics& m = context.metrics;
  const Row* chosen = nullptr;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginChild("rows", {0, 0}, false, ImGuiWindowFlags_NoNav)) {
    if (rows.empty()) {
      ImGui::SetCursorPos({m.px(10), m.px(12)});
      dim_text(context.tr("Nothing is called like that."));
    }
    if (scroll_) {
      const float at = m.px(palette_row) * static_cast<float>(selected_);
      const float visible = ImGui::GetWindowHeight();
      if (at < ImGui::GetScrollY()) ImGui::SetScrollY(at);
      if (at + m.px(palette_row) > ImGui::GetScrollY() + visible)
        ImGui::SetScrollY(at + m.px(palette_row) - visible);
    }
    scroll_ = false;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), m.px(palette_row));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        if (draw_row(context, rows[static_cast<std::size_t>(i)], i == selected_)) {
          selected_ = i;
          chosen = &rows[static_cast<std::size_t>(i)];
        }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (accept_ && !rows.empty()) chosen = &rows[static_cast<std::size_t>(selected_)];
  accept_ = false;
  if (!chosen) return;
  // Commands that cannot run stay in view with their reason, and the text stays ready.
  focus_ = true;
  choose(context, *chosen);
}

bool CommandPalette::draw_row(PanelContext& context, const Row& row, bool selected) const {
  const Metrics& m = context.metrics;
  const std::string id = row.command        ? row.command->id
                         : row.view.empty() ? "object:" + std::to_string(row.object.value)
                                            : "view:" + row.view;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, m.px(palette_row));
  const bool clicked = area_button(context.marks, "palette." + id, size);
  if (selected) context.marks.item("palette.selected." + id);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  if (selected) list.AddRectFilled(at, end, with_alpha(palette().accent, 0.22F), m.px(4));
  if (ImGui::IsItemHovered() && !selected)
    list.AddRectFilled(at, end, with_alpha(palette().secondary, 0.16F), m.px(4));
  const float line = ImGui::GetTextLineHeight(), pad = m.px(10);
  const float first = at.y + (size.y - 2 * line - m.px(2)) / 2, second = first + line + m.px(2);
  float right = end.x - pad;
  if (!row.keys.empty()) right = draw_keys(list, m, right, first, row.keys) - m.px(12);
  list.AddText({at.x + pad, first}, row.refused ? palette().dim_text : palette().text,
               elided(row.label, right - at.x - pad).c_str());
  std::string detail = row.path;
  if (!row.detail.empty()) detail += (detail.empty() ? "" : "  \u00b7  ") + row.detail;
  if (row.refused) {
    const std::string before = row.path.empty() ? std::string() : row.path + "  \u00b7  ";
    const float x = at.x + pad + ImGui::CalcTextSize(before.c_str()).x;
    list.AddText({at.x + pad, second}, palette().dim_text, before.c_str());
    list.AddText({x, second}, palette().warning, elided(row.detail, end.x - pad - x).c_str());
  } else {
    list.AddText({at.x + pad, second}, palette().dim_text, elided(detail, size.x - 2 * pad).c_str());
  }
  return clicked;
}

void CommandPalette::choose(PanelContext& context, const Row& row) {
  if (!row.command) {
    close();
    Editor& editor = context.editor;
    if (!row.view.empty()) return void(go_to_view(editor, row.view));
    const Object* object = editor.document().find(row.object);
    if (!object) return;
    editor.selection.clear_elements();
    editor.selection.active = row.object;
    const Box3 box = world_box(*object);
    if (!box.isEmpty()) editor.fly_to(editor.camera().frame(box, editor.viewport));
    return;
  }
  const std::string id = row.command->id;
  if (row.refused) {
    context.commands.run(id);  // says so to whoever listens
    return;
  }
  close();
  std::erase(recent_, id);
  recent_.insert(recent_.begin(), id);
  if (recent_.size() > recent_kept) recent_.pop_back();
  pending_ = id;
}

}  // namespace hariko
