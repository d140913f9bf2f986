#include "ui/panels/file_dialog.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/file_ending.hpp"
#include "ui/export_text.hpp"
#include "ui/icons.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

constexpr float label_width = 96;

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

fs::path home() {
  const char* path = std::getenv("HOME");
  return path && *path ? fs::path(path) : fs::path("/");
}

}  // namespace

void FileDialog::open(Request request) {
  request_ = std::move(request);
  std::error_code error;
  fs::path start = request_.proposal;
  name_.clear();
  if (!start.empty() && !fs::is_directory(start, error)) {
    name_ = start.filename().string();
    start = start.parent_path();
  }
  if (!request_.saving) name_.clear();
  if (start.empty() || !fs::is_directory(start, error)) start = fs::current_path(error);
  go_to(start);
  open_ = appearing_ = true;
  ask_overwrite_ = false;
}

bool FileDialog::matches(const fs::path& file) const {
  const std::string extension = lower_ending(file);
  return request_.extensions.empty() || std::find(request_.extensions.begin(), request_.extensions.end(),
                                                  extension) != request_.extensions.end();
}

void FileDialog::go_to(const fs::path& folder) {
  // Not every folder can be read, and none must be able to stop the program.
  std::error_code error;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  if (error) {
    error_ = fill(translatable("The folder {0} cannot be read: {1}."), {folder.string(), error.message()});
    return;
  }
  constexpr std::size_t most = 10'000;
  std::vector<Entry> entries;
  for (; it != fs::directory_iterator() && entries.size() < most; it.increment(error)) {
    if (error) break;
    Entry entry{it->path().filename().string(), it->is_directory(error), 0};
    if (entry.name.starts_with(".")) continue;
    if (!entry.folder && !matches(it->path())) continue;
    if (!entry.folder) entry.size = it->file_size(error);
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
  folder_ = fs::weakly_canonical(folder, error);
  if (error) folder_ = folder;
  entries_ = std::move(entries);
  error_.clear();
}

bool FileDialog::replaces_something(const fs::path& path) {
  std::error_code error;
  std::optional<fs::path> replaced;
  if (request_.replaces)
    replaced = request_.replaces(path);
  else if (fs::exists(path, error))
    replaced = path;
  replaced_ = replaced ? replaced->filename().string() : std::string();
  return replaced.has_value();
}

void FileDialog::submit(bool overwrite) {
  if (name_.empty()) return;
  fs::path path =
      name_.starts_with("~/") ? home() / name_.substr(2) : folder_ / name_;  // absolute names replace
  std::error_code error;
  if (fs::is_directory(path, error)) {
    name_.clear();
    return go_to(path);
  }
  if (request_.saving) {
    if (path.extension().empty() && !request_.extensions.empty()) path += request_.extensions.front();
    if (!matches(path)) {
      std::string endings;
      for (const std::string& extension : request_.extensions) endings += " " + extension;
      error_ = fill(translatable("This ending is not one of those that can be written:{0}"), {endings});
      return;
    }
    if (!overwrite && replaces_something(path)) {
      ask_overwrite_ = true;
      return;
    }
  } else if (!fs::exists(path, error)) {
    error_ = fill(translatable("There is no file {0}."), {path.string()});
    return;
  }
  open_ = false;
  const auto accept = request_.accept;  // which may open the dialog again
  accept(path);
}

void FileDialog::list(PanelContext& context) {
  const float row = ImGui::GetFrameHeight();
  const int options = (request_.options ? request_.option_rows() : 0) + (request_.formats.empty() ? 0 : 1);
  const float below = row * static_cast<float>(options + 2) + context.metrics.px(26) +
                      ImGui::GetStyle().ItemSpacing.y * static_cast<float>(std::max(options - 1, 0)) +
                      (error_.empty() && !ask_overwrite_ ? 0 : row + context.metrics.px(6));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().panel);
  ImGui::BeginChild("files", {0, -below}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()));
  fs::path enter;
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Entry& entry = entries_[static_cast<std::size_t>(i)];
      ImGui::PushID(i);
      if (ImGui::Selectable("##entry", !entry.folder && entry.name == name_,
                            ImGuiSelectableFlags_AllowDoubleClick)) {
        if (entry.folder) {
          if (ImGui::IsMouseDoubleClicked(0)) enter = folder_ / entry.name;
        } else {
          name_ = entry.name;
          ask_overwrite_ = false;
          if (ImGui::IsMouseDoubleClicked(0)) submit(false);
        }
      }
      context.marks.item("entry." + entry.name);
      ImGui::SameLine(context.metrics.px(10));
      {
        const TextColour colour(entry.folder ? palette().secondary : palette().dim_text);
        ImGui::TextUnformatted(entry.folder ? icon::folder : icon::file);
      }
      ImGui::SameLine(context.metrics.px(34));
      ImGui::TextUnformatted(entry.name.c_str());
      if (!entry.folder) {
        const std::string size = file_size_text(entry.size);
        ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::CalcTextSize(size.c_str()).x -
                        context.metrics.px(20));
        ImGui::TextDisabled("%s", size.c_str());
      }
      ImGui::PopID();
    }
  if (entries_.empty()) {
    ImGui::SetCursorPos({context.metrics.px(10), context.metrics.px(8)});
    ImGui::TextDisabled("%s", request_.saving ? context.tr("No files of this kind here yet.")
                                              : context.tr("Nothing here that can be opened."));
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (!enter.empty()) go_to(enter);
}

/// The format is the ending of the name.
void FileDialog::format_row(PanelContext& context) {
  const Metrics& m = context.metrics;
  const fs::path name = name_;
  const auto found = std::find(request_.extensions.begin(), request_.extensions.end(), lower_ending(name));
  const auto now = std::size_t(found - request_.extensions.begin());
  const auto text = [&](std::size_t i) {
    return context.tr(request_.formats[i]) + " (" + request_.extensions[i] + ")";
  };
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(context.tr(translatable("Format")));
  ImGui::SameLine(m.px(label_width));
  ImGui::SetNextItemWidth(m.px(220));
  // A name without an ending gets the first one.
  const std::string shown = now < request_.formats.size() ? text(now)
                            : name.has_extension()        ? std::string()
                                                          : text(0);
  const bool open = ImGui::BeginCombo("##format", shown.c_str());
  context.marks.item("dialog.format");
  if (!open) return;
  for (std::size_t i = 0; i < request_.formats.size(); ++i) {
    if (ImGui::Selectable(text(i).c_str(), i == now)) {
      const bool known = now < request_.formats.size();
      const fs::path base = known          ? fs::path(name).replace_extension()
                            : name.empty() ? request_.proposal.stem()
                                           : name;
      name_ = base.string() + request_.extensions[i];
      ask_overwrite_ = false;
      error_.clear();
    }
    context.marks.item("dialog.format" + request_.extensions[i]);
  }
  ImGui::EndCombo();
}

void FileDialog::footer(PanelContext& context) {
  const Metrics& m = context.metrics;
  if (!request_.formats.empty()) format_row(context);
  if (request_.options) request_.options(name_);
  if (appearing_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint(
      "##name", context.tr(request_.saving ? translatable("File name") : translatable("File name or path")),
      &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemEdited()) ask_overwrite_ = false;
  context.marks.item("dialog.name");
  if (ask_overwrite_) {
    const TextColour colour(palette().warning);
    ImGui::TextUnformatted(
        (icon::warning + ("  " + fill(context.tr("{0} exists already."), {replaced_}))).c_str());
  } else if (!error_.empty()) {
    const TextColour colour(palette().error);
    ImGui::TextUnformatted(context.tr.phrase(error_).c_str());
  }
  const float button = m.px(110);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * button - ImGui::GetStyle().ItemSpacing.x - m.px(12));
  if (ImGui::Button(context.tr("Cancel"), {button, 0})) {
    open_ = false;
  }
  context.marks.item("dialog.cancel");
  ImGui::SameLine();
  const bool pressed =
      main_button(ask_overwrite_ ? context.tr("Replace") : context.tr(request_.action).c_str(), {button, 0});
  context.marks.item("dialog.accept");
  if (open_ && (pressed || entered)) submit(ask_overwrite_);
}

void FileDialog::draw(PanelContext& context) {
  const Metrics& m = context.metrics;
  const std::string id = context.tr(request_.title) + "###file_dialog";
  if (!open_ && !ImGui::IsPopupOpen(id.c_str())) return;
  if (appearing_) ImGui::OpenPopup(id.c_str());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSize(
      {std::min(m.px(720), screen.x - m.px(40)), std::min(m.px(520), screen.y - m.px(40))});
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  if (!ImGui::BeginPopupModal(
          id.c_str(), nullptr,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    if (!appearing_) open_ = false;
    appearing_ = false;
    return;
  }
  if (icon_button(context, icon::up, "up", context.tr("Parent folder"), false, 26))
    go_to(folder_.parent_path());
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(folder_.c_str());
  list(context);
  if (open_) footer(context);
  appearing_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace hariko
