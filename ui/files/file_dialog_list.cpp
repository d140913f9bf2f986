// The list of files of FileDialog.

#include <imgui.h>

#include <utility>

#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/files/export_text.hpp"
#include "ui/files/file_dialog.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/overlay_window.hpp"

namespace hariko {

/// Dates go first where names would have no room, then sizes.
FileDialog::Columns FileDialog::columns(const Metrics& metrics, float width) {
  const float least_name = metrics.px(140), size = metrics.px(76);
  const float date = ImGui::CalcTextSize("0000-00-00 00:00").x + metrics.px(24);
  Columns out;
  out.name_end = width - metrics.px(8);
  if (width - date - size >= least_name) out.name_end = out.date_at = width - date;
  if (out.name_end - size >= least_name) out.name_end = out.size_at = out.name_end - size;
  return out;
}

/// Names of the columns; a click sorts by one, a second click the other way round.
void FileDialog::draw_header(PanelContext& context, const Columns& places) {
  const auto column = [&](const char* name, const char* mark, FolderOrder order, float at) {
    ImGui::SameLine(at);
    const bool on = order_ == order;
    const TextColour colour(on ? palette().text : palette().dim_text);
    const std::string label = std::string(context.tr(name)) + (on ? descending_ ? " \u2193" : " \u2191" : "");
    if (selectable_row(context.marks, std::string("dialog.sort.") + mark, label, false,
                       {ImGui::CalcTextSize(label.c_str()).x, 0})) {
      // Largest and latest first: what one looks for.
      descending_ = on ? !descending_ : order != FolderOrder::name;
      order_ = order;
      sort_entries(entries_, order_, descending_);
      at_.reset();
    }
  };
  ImGui::NewLine();
  column("Name", "name", FolderOrder::name, context.metrics.px(34));
  if (places.size_at > 0) column("Size", "size", FolderOrder::size, places.size_at);
  if (places.date_at > 0) column("Modified", "modified", FolderOrder::modified, places.date_at);
}

void FileDialog::draw_entry(PanelContext& context, std::size_t number, const Columns& places) {
  const FolderEntry& entry = entries_[number];
  const Metrics& m = context.metrics;
  context.editor.show_text(entry.name);
  ImGui::PushID(static_cast<int>(number));
  if (selectable_row(context.marks, "entry." + entry.name, "",
                     (!entry.folder && entry.name == name_) || at_ == number, {0, 0},
                     ImGuiSelectableFlags_AllowDoubleClick)) {
    focus_name_ = true;
    at_ = number;
    const bool twice = ImGui::IsMouseDoubleClicked(0);
    if (!entry.folder) {
      name_ = entry.name;
      ask_overwrite_ = false;
    }
    if (twice && entry.folder) name_ = entry.name;
    if (twice) submit(false);
  }
  const bool shown = number < entries_.size() && &entries_[number] == &entry;
  if (shown && open_) {
    if (at_ == number && std::exchange(scroll_, false)) ImGui::SetScrollHereY();
    ImGui::SameLine(m.px(10));
    coloured_text(entry.folder ? palette().secondary : palette().dim_text,
                  entry.folder ? icon::folder : icon::file);
    ImGui::SameLine(m.px(34));
    plain_text(elided(entry.name, places.name_end - m.px(42)));
    if (!entry.folder && places.size_at > 0) {
      ImGui::SameLine(places.size_at);
      dim_text(file_size_text(entry.size));
    }
    if (entry.modified != 0 && places.date_at > 0) {
      ImGui::SameLine(places.date_at);
      dim_text(local_time_text(entry.modified));
    }
  }
  ImGui::PopID();
}

void FileDialog::draw_list(PanelContext& context, const Fit& room) {
  const Metrics& m = context.metrics;
  ImGui::BeginGroup();
  const Columns places = columns(m, ImGui::GetContentRegionAvail().x);
  if (room.header) {
    ImGui::BeginChild("header", {0, ImGui::GetFrameHeight()}, false, ImGuiWindowFlags_NavFlattened);
    draw_header(context, places);
    ImGui::EndChild();
  }
  const float height = room.header ? room.height - ImGui::GetFrameHeightWithSpacing() : room.height;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding.x, room.header ? padding.y : m.px(4)));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().panel);
  ImGui::BeginChild("files", {0, height}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
  ImGui::PopStyleVar();
  context.marks.window("dialog.files");
  const std::filesystem::path shown = folder_;
  ImGuiListClipper clipper;
  // Nothing may be drawn when a click has closed the dialog: the clipper cannot measure a row then.
  clipper.Begin(static_cast<int>(entries_.size()), ImGui::GetTextLineHeightWithSpacing());
  if (scroll_ && at_)
    ImGui::SetScrollY(static_cast<float>(*at_) * ImGui::GetTextLineHeightWithSpacing() -
                      ImGui::GetWindowHeight() / 2);
  scroll_ = false;
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd && folder_ == shown && open_; ++i)
      draw_entry(context, static_cast<std::size_t>(i), places);
  if (entries_.empty()) {
    ImGui::SetCursorPos({m.px(10), m.px(8)});
    dim_text(request_.saving ? context.tr("No files of this kind here yet.")
                             : context.tr("Nothing here that can be opened."));
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::EndGroup();
}

}  // namespace hariko
