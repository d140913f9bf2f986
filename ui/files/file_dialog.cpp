#include "ui/files/file_dialog.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/base/files/file_ending.hpp"
#include "ui/base/icons.hpp"
#include "ui/files/export_text.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

/// "Wavefront OBJ" of ".obj", in English, to be translated; the ending itself where it is not known.
const char* format_name(std::string_view ending) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 23> names{{
      {".hariko", translatable("Hariko document")},
      {".obj", "Wavefront OBJ"},
      {".off", "OFF"},
      {".ply", "PLY"},
      {".stl", "STL"},
      {".glb", translatable("glTF, one file")},
      {".gltf", "glTF"},
      {".3mf", "3MF"},
      {".bpt", translatable("Bezier patches")},
      {".json", "JSON"},
      {".step", "STEP"},
      {".stp", "STEP"},
      {".iges", "IGES"},
      {".igs", "IGES"},
      {".png", translatable("PNG picture")},
      {".jpg", translatable("JPEG picture")},
      {".jpeg", translatable("JPEG picture")},
      {".webp", translatable("WebP picture")},
      {".svg", translatable("SVG line drawing")},
      {".pdf", "PDF"},
      {".dxf", "DXF"},
      {".jsonl", translatable("Replay")},
      {"", ""},
  }};
  for (const auto& [known, name] : names)
    if (known == ending) return name;
  return "";
}

constexpr float label_width = 96, places_width = 150;

fs::path folder_of(const char* variable, const fs::path& otherwise) {
  const char* path = std::getenv(variable);
  return path && *path ? fs::path(path) : otherwise;
}

fs::path home() {
  return folder_of("HOME", "/");
}

/// Text of the kernel's list of what is mounted; empty where there is none.
std::string mounts() {
  std::ostringstream text;
  text << std::ifstream("/proc/self/mounts").rdbuf();
  return text.str();
}

/// "Wavefront OBJ (.obj)".
std::string format_text(const Language& tr, const std::string& ending) {
  const std::string name = tr(std::string(format_name(ending)));
  return name.empty() ? ending : name + " (" + ending + ")";
}

}  // namespace

void FileDialog::open(Request request) {
  request_ = std::move(request);
  std::error_code error;
  fs::path start = request_.proposal;
  name_.clear();
  only_.reset();
  new_folder_.reset();
  if (!start.empty() && !fs::is_directory(start, error)) {
    name_ = start.filename().string();
    start = start.parent_path();
  }
  if (!request_.saving) name_.clear();
  if (start.empty() || !fs::is_directory(start, error)) start = chosen_folder_;
  if (start.empty() || !fs::is_directory(start, error)) start = fs::current_path(error);
  go_to(start);
  places_.clear();
  open_ = appearing_ = true;
  ask_overwrite_ = settings_shown_ = false;
  footer_height_ = settings_height_ = 0;
}

bool FileDialog::matches(const fs::path& file) const {
  const std::string extension = lower_ending(file);
  if (only_) return extension == request_.extensions[*only_];
  return request_.extensions.empty() || std::find(request_.extensions.begin(), request_.extensions.end(),
                                                  extension) != request_.extensions.end();
}

void FileDialog::go_to(const fs::path& folder) {
  auto entries = list_folder(
      folder, [this](const fs::path& file) { return matches(file); }, hidden_);
  if (!entries.ok()) {
    error_ = Phrase(translatable("The folder {0} cannot be read."), {folder.string()});
    return;
  }
  std::error_code error;
  folder_ = fs::weakly_canonical(folder, error);
  if (error) folder_ = folder;
  entries_ = std::move(entries).value();
  sort_entries(entries_, order_, descending_);
  at_.reset();
  error_ = {};
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
      error_ = Phrase(translatable("This ending is not one of those that can be written:{0}"), {endings});
      return;
    }
    if (!overwrite && replaces_something(path)) {
      ask_overwrite_ = true;
      return;
    }
  } else if (!fs::exists(path, error)) {
    // The entry that typing went to.
    if (at_ && entries_[*at_].name != name_ && first_beginning_with(entries_, name_) == at_) {
      name_ = entries_[*at_].name;
      return submit(overwrite);
    }
    error_ = Phrase(translatable("There is no file {0}."), {path.string()});
    return;
  }
  open_ = false;
  chosen_folder_ = folder_;
  const auto accept = request_.accept;  // a copy, since it may open the dialog again
  accept(path);
}

void FileDialog::step(int by) {
  if (entries_.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(entries_.size()) - 1;
  const std::ptrdiff_t from = at_ ? static_cast<std::ptrdiff_t>(*at_) : by > 0 ? -1 : last + 1;
  at_ = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(from + by, 0, last));
  name_ = entries_[*at_].name;
  ask_overwrite_ = false;
  scroll_ = true;
}

void FileDialog::follow_typing() {
  at_ = first_beginning_with(entries_, name_);
  scroll_ = at_.has_value();
}

void FileDialog::make_folder(PanelContext& context) {
  const fs::path path = folder_ / *new_folder_;
  std::error_code error;
  if (new_folder_->empty() || *new_folder_ != path.filename().string() ||
      !fs::create_directory(path, error)) {
    const std::string why =
        error ? context.tr(error.message()) : std::string(context.tr("it is there already"));
    error_ = Phrase(translatable("The folder {0} cannot be made: {1}."), {path.string(), why});
    return;
  }
  new_folder_.reset();
  go_to(path);
}

void FileDialog::draw_places(PanelContext& context, float width, float height) {
  if (places_.empty()) {
    std::vector<fs::path> recent;
    for (const RecentFile& file : context.offers.recent) recent.push_back(file.path);
    places_ = usual_places(home(), folder_of("XDG_CONFIG_HOME", home() / ".config"), recent, mounts());
  }
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().panel);
  ImGui::BeginChild("places", {width, height}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
  bool titled = false;
  for (const Place& place : places_) {
    if (place.id.starts_with("recent") && !std::exchange(titled, true)) heading(context, "Recent");
    const char* symbol = place.id == "root" ? icon::object : icon::folder;
    const std::string name = place.id == "home"   ? std::string(context.tr("Home"))
                             : place.id == "root" ? std::string(context.tr("Computer"))
                                                  : place.name;
    context.editor.show_text(name);
    const std::string label = std::string(symbol) + "  " + name;
    const float room = ImGui::GetContentRegionAvail().x;
    if (selectable_row(context.marks, "dialog.place." + place.id, elided(label, room),
                       place.folder == folder_))
      go_to(place.folder);
    if (ImGui::IsItemHovered()) show_tip(place.folder.string());
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

/// The folders down to this one, each of which can be gone to, and making a new one.
void FileDialog::draw_path(PanelContext& context) {
  const Metrics& m = context.metrics;
  if (icon_button(context, icon::up, "dialog.up", "Parent folder", false, 26)) go_to(folder_.parent_path());
  const float button = ImGui::CalcTextSize(context.tr("New folder")).x + m.px(24);
  constexpr float eye = 26;
  const float new_folder_at = ImGui::GetWindowContentRegionMax().x - button;
  const float end = new_folder_at - m.px(eye) - ImGui::GetStyle().ItemSpacing.x;
  std::vector<fs::path> folders;
  for (fs::path at = folder_;; at = at.parent_path()) {
    folders.insert(folders.begin(), at);
    if (at == at.parent_path()) break;
  }
  const auto label = [](const fs::path& at) {
    return at.filename().empty() ? std::string("/") : at.filename().string();
  };
  // As many of the last ones as there is room for.
  float room = end - ImGui::GetCursorPosX() - m.px(60);
  std::size_t first = folders.size();
  while (first > 0 && room > ImGui::CalcTextSize(label(folders[first - 1]).c_str()).x + m.px(26))
    room -= ImGui::CalcTextSize(label(folders[--first]).c_str()).x + m.px(26);
  first = std::min(first, folders.size() - 1);
  fs::path wanted;
  for (std::size_t i = first; i < folders.size(); ++i) {
    ImGui::SameLine(0, m.px(2));
    context.editor.show_text(label(folders[i]));
    const std::string shown = elided(label(folders[i]), end - ImGui::GetCursorPosX() - m.px(30));
    ImGui::PushStyleColor(ImGuiCol_Button, 0);
    if (text_button(context.marks, "dialog.crumb." + std::to_string(folders.size() - 1 - i), shown))
      wanted = folders[i];
    ImGui::PopStyleColor();
  }
  ImGui::SameLine(end);
  if (icon_button(context, hidden_ ? icon::shown : icon::hidden, "dialog.hidden",
                  translatable("Show hidden files"), hidden_, eye)) {
    hidden_ = !hidden_;
    wanted = folder_;
  }
  ImGui::SameLine(new_folder_at);
  if (text_button(context.marks, "dialog.new_folder", context.tr("New folder"), button))
    new_folder_ = new_folder_ ? std::nullopt : std::optional(std::string(context.tr("New folder")));
  if (!wanted.empty()) go_to(wanted);
  if (!new_folder_) return;
  const bool entered = text_field(context.marks, "dialog.new_folder_name", *new_folder_,
                                  -button - ImGui::GetStyle().ItemSpacing.x, "",
                                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::SameLine();
  const bool pressed = text_button(context.marks, "dialog.make_folder", context.tr("Make"), button);
  if (entered || pressed) make_folder(context);
}

/// Puts the format into the name: when saving it is the name's ending.
void FileDialog::choose_format(std::size_t number) {
  const fs::path name = name_;
  const auto found = std::find(request_.extensions.begin(), request_.extensions.end(), lower_ending(name));
  const fs::path base = found != request_.extensions.end() ? fs::path(name).replace_extension()
                        : name.empty()                     ? request_.proposal.stem()
                                                           : name;
  name_ = base.string() + request_.extensions[number];
  ask_overwrite_ = false;
  error_ = {};
}

/// Row of the format: when saving, what is written; when opening, which files are shown.
void FileDialog::draw_format(PanelContext& context) {
  const auto& endings = request_.extensions;
  const Language& tr = context.tr;
  const fs::path name = name_;
  const auto found = std::find(endings.begin(), endings.end(), lower_ending(name));
  const auto now = std::size_t(found - endings.begin());
  aligned_text(tr("Format"));
  ImGui::SameLine(context.metrics.px(label_width));
  // A name without an ending gets the first one.
  const std::string saved = now < endings.size()   ? format_text(tr, endings[now])
                            : name.has_extension() ? std::string()
                                                   : format_text(tr, endings[0]);
  const std::string shown = request_.saving ? saved
                            : only_         ? format_text(tr, endings[*only_])
                                            : std::string(tr("All that can be opened"));
  const float width = std::min(context.metrics.px(220), ImGui::GetContentRegionAvail().x);
  const OpenScope list =
      list_scope(context.marks, "dialog.format", shown, width, ImGuiComboFlags_HeightLarge);
  if (!list) return;
  if (!request_.saving &&
      selectable_row(context.marks, "dialog.format.all", tr("All that can be opened"), !only_)) {
    only_.reset();
    go_to(folder_);
  }
  for (std::size_t i = 0; i < endings.size(); ++i) {
    if (!selectable_row(context.marks, "dialog.format" + endings[i], format_text(tr, endings[i]),
                        request_.saving ? i == now : only_ == i))
      continue;
    if (request_.saving) {
      choose_format(i);
    } else {
      only_ = i;
      go_to(folder_);
    }
  }
}

void FileDialog::draw_name(PanelContext& context) {
  if (appearing_ || std::exchange(focus_name_, false)) ImGui::SetKeyboardFocusHere();
  // Up and down go through the list.
  const auto neighbour = [this](const std::string&, int direction) {
    step(-direction);
    return name_;
  };
  std::string text = name_;
  const bool entered =
      text_field(context.marks, "dialog.name", text, -1,
                 context.tr(request_.saving ? translatable("File name") : translatable("File name or path")),
                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll, neighbour);
  if (ImGui::IsItemEdited()) ask_overwrite_ = false;
  // Keys that go through the list have changed the name, too.
  const bool typed = text != name_;
  name_ = text;
  if (typed && !request_.saving) follow_typing();
  if (entered) {
    submit(ask_overwrite_);
    focus_name_ = open_;  // Enter took the keyboard away
  }
}

bool FileDialog::has_settings() const {
  return request_.extensions.size() > 1 || request_.options;
}

void FileDialog::draw_settings(PanelContext& context) {
  const float top = ImGui::GetCursorPosY();
  if (request_.extensions.size() > 1) draw_format(context);
  if (request_.options) request_.options(context, name_);
  settings_height_ = ImGui::GetCursorPosY() - top;
}

FileDialog::Fit FileDialog::fit() const {
  constexpr float least_entries = 4, fewest_entries = 3;
  const float row = ImGui::GetFrameHeightWithSpacing(), entry = ImGui::GetTextLineHeightWithSpacing();
  const float least = row + least_entries * entry + 2 * ImGui::GetStyle().WindowPadding.y;
  const float room = ImGui::GetContentRegionAvail().y, name_and_buttons = 2 * row;
  // Before they have been drawn once nobody knows how high the settings are; they are no less than this.
  const float fewest_rows = (request_.extensions.size() > 1 ? 1.0F : 0) + (request_.options ? 2.0F : 0);
  const float settings = settings_height_ > 0 ? settings_height_ : fewest_rows * row;
  Fit fit;
  fit.folded = has_settings() && room - name_and_buttons - settings < least;
  const float below = (footer_height_ > 0 ? footer_height_ : name_and_buttons) + (fit.folded ? 0 : settings);
  fit.height = std::max(room - below, fewest_entries * entry);
  fit.header = fit.height >= least;
  return fit;
}

void FileDialog::draw_footer(PanelContext& context, bool folded) {
  const Metrics& m = context.metrics;
  const float top = ImGui::GetCursorPosY();
  draw_name(context);
  if (!open_) return;
  if (ask_overwrite_) {
    coloured_text(palette().warning,
                  (icon::warning + ("  " + fill(context.tr("{0} exists already."), {replaced_}))).c_str());
  } else if (!error_.empty()) {
    coloured_text(palette().error, context.tr(error_).c_str());
  }
  if (folded) {
    if (icon_button(context, icon::settings, "dialog.settings", translatable("Format and settings"),
                    settings_shown_, 26))
      settings_shown_ = !settings_shown_;
    ImGui::SameLine();
  }
  const float button = m.px(110);
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * button - ImGui::GetStyle().ItemSpacing.x);
  if (text_button(context.marks, "dialog.cancel", context.tr("Cancel"), button)) open_ = false;
  ImGui::SameLine();
  const bool pressed =
      main_button(context.marks, "dialog.accept",
                  ask_overwrite_ ? context.tr("Replace") : context.tr(request_.action), button);
  footer_height_ = ImGui::GetCursorPosY() - top;
  if (open_ && pressed) submit(ask_overwrite_);
}

void FileDialog::draw(PanelContext& context) {
  const Metrics& m = context.metrics;
  const std::string id = context.tr(request_.title) + "###file_dialog";
  if (!open_ && !ImGui::IsPopupOpen(id.c_str())) return;
  if (appearing_) ImGui::OpenPopup(id.c_str());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = std::min(m.px(40), screen.y / 20);
  const float height = m.px(has_settings() ? 640 : 560);
  ImGui::SetNextWindowSize({std::min(m.px(860), screen.x - margin), std::min(height, screen.y - margin)});
  const OpenScope dialog = dialog_scope(
      id, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  if (!dialog) {
    if (!appearing_) open_ = false;
    appearing_ = false;
    return;
  }
  draw_path(context);
  const Fit room = fit();
  if (room.folded && settings_shown_) {
    ImGui::BeginChild("settings", {0, room.height}, false, ImGuiWindowFlags_NavFlattened);
    draw_settings(context);
    ImGui::EndChild();
  } else {
    // In a narrow window the files need the room.
    if (const float places = m.px(places_width); ImGui::GetWindowWidth() > 4 * places) {
      draw_places(context, places, room.height);
      ImGui::SameLine();
    }
    draw_list(context, room);
  }
  // A click on nothing leaves the keyboard at the name.
  if (ImGui::IsMouseReleased(0) && !ImGui::IsAnyItemActive() && !ImGui::IsAnyItemHovered())
    focus_name_ = true;
  if (open_ && !room.folded) draw_settings(context);
  if (open_) draw_footer(context, room.folded);
  appearing_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
}

}  // namespace hariko
