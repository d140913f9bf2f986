#include "ui/shell/preferences.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/base/fonts.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/shell/navigation_rows.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float label_column = 190, narrow_column = 8, least_field = 170, pages_width = 150;
constexpr std::array scales{0.75F, 1.0F, 1.25F, 1.5F, 1.75F, 2.0F, 2.5F};

/// Left edge of fields: right of their names, or below them where a page is narrow.
float column_of_fields(const PanelContext& context) {
  const float beside = context.metrics.px(label_column), least = context.metrics.px(least_field);
  return ImGui::GetWindowContentRegionMax().x >= beside + least ? beside : context.metrics.px(narrow_column);
}

/// A row's name; what follows stands in the right column.
void row(const PanelContext& context, const char* label) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(context.tr(label));
  const float column = column_of_fields(context);
  if (column >= context.metrics.px(label_column))
    ImGui::SameLine(column);
  else
    ImGui::SetCursorPosX(column);
}

/// A sentence below a row.
void note(const PanelContext& context, const char* text) {
  ImGui::SetCursorPosX(column_of_fields(context));
  const TextColour dim(palette().dim_text);
  text_in_lines(context.tr(text));
}

/// One of several choices side by side. True when it was chosen now.
bool choice(PanelContext& context, const char* label, const std::string& mark, bool on,
            const char* why_not = nullptr) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(palette().accent, 0.28F));
    ImGui::PushStyleColor(ImGuiCol_Text, palette().accent);
  }
  const float width = ImGui::CalcTextSize(label).x + ImGui::GetStyle().FramePadding.x * 2;
  if (ImGui::GetCursorPosX() + width > ImGui::GetWindowContentRegionMax().x) {
    ImGui::NewLine();
    ImGui::SetCursorPosX(column_of_fields(context));
  }
  bool chosen = false;
  {
    const Disabled disabled(why_not != nullptr);
    chosen = ImGui::Button((std::string(label) + "###" + mark).c_str());
    context.marks.item("preferences." + mark);
  }
  if (on) ImGui::PopStyleColor(2);
  if (why_not && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) show_tip(context.tr(why_not));
  ImGui::SameLine(0, context.metrics.px(4));
  return chosen && !on;
}

void end_choices() {
  ImGui::NewLine();
}

void check(PanelContext& context, const char* label, const char* mark, bool& value) {
  row(context, label);
  ImGui::Checkbox((std::string("###") + mark).c_str(), &value);
  context.marks.item(std::string("preferences.") + mark);
}

void slider(PanelContext& context, const char* label, const char* mark, double& value, double low,
            double high, const char* format, bool logarithmic) {
  row(context, label);
  const float number = ImGui::CalcTextSize("3600 s").x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(std::min(context.metrics.px(220), ImGui::GetContentRegionAvail().x - number));
  float shown = static_cast<float>(value);
  // The number stands beside: the handle would hide it.
  if (ImGui::SliderFloat((std::string("###") + mark).c_str(), &shown, static_cast<float>(low),
                         static_cast<float>(high), "",
                         ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0)))
    value = static_cast<double>(shown);
  context.marks.item(std::string("preferences.") + mark);
  ImGui::SameLine();
  ImGui::Text(format, value);
}

/// Which drags orbit, pan and zoom, one line each.
void navigation_table(PanelContext& context) {
  for (const auto& [motion, drags] : navigation_rows(context.tr, context.editor.settings.navigation)) {
    const float column = column_of_fields(context);
    ImGui::SetCursorPosX(column);
    ImGui::TextUnformatted(motion.c_str());
    ImGui::SameLine(column + context.metrics.px(80));
    const TextColour dim(palette().dim_text);
    text_in_lines(drags);
  }
}

void interface_page(PanelContext& context) {
  Settings& settings = context.editor.settings;
  const Language& tr = context.tr;
  row(context, "Theme");
  if (choice(context, tr("Dark"), "theme.dark", settings.theme == ThemeId::dark))
    settings.theme = ThemeId::dark;
  if (choice(context, tr("Light"), "theme.light", settings.theme == ThemeId::light))
    settings.theme = ThemeId::light;
  end_choices();
  row(context, "Scale");
  for (const float scale : scales) {
    const std::string percent = std::to_string(static_cast<int>(std::lround(scale * 100)));
    if (choice(context, (percent + " %").c_str(), "scale." + percent,
               std::abs(settings.interface_scale - scale) < 1e-3F))
      settings.interface_scale = scale;
  }
  end_choices();
  note(context, translatable("On top of the scale of the monitor."));
  row(context, "Language");
  if (choice(context, "English", "language.english", settings.language == LanguageId::english))
    settings.language = LanguageId::english;
  if (choice(context, japanese_in_japanese, "language.japanese", settings.language == LanguageId::japanese,
             japanese_font_installed() ? nullptr : no_japanese_font))
    settings.language = LanguageId::japanese;
  end_choices();
  if (!japanese_font_installed()) note(context, no_japanese_font);
}

void navigation_page(PanelContext& context) {
  Settings& settings = context.editor.settings;
  const Language& tr = context.tr;
  row(context, "Mouse buttons as in");
  const std::array<std::pair<NavigationPreset, const char*>, 5> presets{{
      {NavigationPreset::hariko, "Hariko"},
      {NavigationPreset::blender, "Blender"},
      {NavigationPreset::maya, "Maya"},
      {NavigationPreset::rhino, "Rhino"},
      {NavigationPreset::trackpad, translatable("Trackpad")},
  }};
  for (const auto& [preset, name] : presets)
    if (choice(context, tr(name), std::string("navigation.") + name, settings.navigation == preset))
      settings.navigation = preset;
  end_choices();
  navigation_table(context);
  row(context, "Turning");
  if (choice(context, tr("Turntable"), "turntable", !settings.trackball)) settings.trackball = false;
  if (choice(context, tr("Trackball"), "trackball", settings.trackball)) settings.trackball = true;
  end_choices();
  note(context, settings.trackball ? translatable("The view rolls freely.")
                                   : translatable("The horizon stays level."));
  check(context, translatable("Zoom towards the pointer"), "zoom_to_cursor", settings.zoom_to_cursor);
  check(context, translatable("Turn the wheel the other way"), "invert_wheel", settings.invert_wheel);
  check(context, translatable("Orbit about the selection"), "orbit_selection", settings.orbit_selection);
  slider(context, translatable("Orbit speed"), "orbit_speed", settings.orbit_speed, 0.25, 4, "%.2f \u00d7",
         true);
  slider(context, translatable("Zoom speed"), "zoom_speed", settings.zoom_speed, 0.25, 4, "%.2f \u00d7",
         true);
}

void units_page(PanelContext& context) {
  Settings& settings = context.editor.settings;
  row(context, "Unit of new documents");
  for (const Unit unit : {Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch}) {
    const std::string name(to_string(unit));
    if (choice(context, name.c_str(), "unit." + name, settings.unit == unit)) settings.unit = unit;
  }
  end_choices();
  note(context, translatable("A document keeps its own unit; it is in its properties."));
}

/// Round the cross of the window, which Dear ImGui leaves without the ring of the keyboard.
void ring_of_cross() {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const ImGuiID cross = window->GetID("#CLOSE");
  if (GImGui->NavId == cross)
    ImGui::RenderNavHighlight(ImGui::WindowRectRelToAbs(window, window->NavRectRel[GImGui->NavLayer]), cross);
}

void files_page(PanelContext& context) {
  slider(context, translatable("Save a copy for recovery every"), "autosave_seconds",
         context.editor.settings.autosave_seconds, 1, Settings::most_autosave_seconds, "%.0f s", false);
  note(
      context,
      translatable("After a crash the next start offers the copy. Your file is written only when you save."));
}

}  // namespace

void Preferences::close() {
  open_ = false;
  keys_.stop();
}

void Preferences::reset_page(Settings& settings) const {
  const Settings fresh;
  switch (page_) {
    case Page::interface:
      settings.theme = fresh.theme;
      settings.interface_scale = fresh.interface_scale;
      settings.language = fresh.language;
      break;
    case Page::navigation:
      settings.navigation = fresh.navigation;
      settings.trackball = fresh.trackball;
      settings.zoom_to_cursor = fresh.zoom_to_cursor;
      settings.invert_wheel = fresh.invert_wheel;
      settings.orbit_selection = fresh.orbit_selection;
      settings.orbit_speed = fresh.orbit_speed;
      settings.zoom_speed = fresh.zoom_speed;
      break;
    case Page::units:
      settings.unit = fresh.unit;
      break;
    case Page::files:
      settings.autosave_seconds = fresh.autosave_seconds;
      break;
    case Page::colours:
      settings.colour_blind_maps = fresh.colour_blind_maps;
      break;
    case Page::keys:
      settings.keys.clear();
      break;
  }
}

void Preferences::draw(PanelContext& context, float top) {
  if (!open_) return;
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(m.px(760), screen.x - m.px(32)), std::min(m.px(520), screen.y - top - m.px(32)));
  const ImVec2 most(screen.x - size.x, screen.y - size.y);
  ImGui::SetNextWindowSize(size);
  const std::string name = std::string(context.tr("Preferences")) + "###preferences";
  // The place where it was put, as far as that is inside of the window, which may have become smaller, or the
  // interface larger.
  const ImGuiWindow* window = ImGui::FindWindowByName(name.c_str());
  if (window && window->WasActive)
    ImGui::SetNextWindowPos({std::clamp(window->Pos.x, 0.0F, std::max(0.0F, most.x)),
                             std::clamp(window->Pos.y, top, std::max(top, most.y))});
  else
    ImGui::SetNextWindowPos({most.x / 2, (most.y + top) / 2});
  if (focus_) ImGui::SetNextWindowFocus();
  focus_ = false;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, m.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, m.px(1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().popup);
  bool stays = true;
  const bool drawn = ImGui::Begin(name.c_str(), &stays,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar |
                                      ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  context.marks.window("preferences");
  ring_of_cross();
  if (drawn) {
    constexpr float share_of_pages = 0.38F;
    if (ImGui::BeginChild("pages", {std::min(m.px(pages_width), share_of_pages * size.x), 0}, false,
                          ImGuiWindowFlags_NavFlattened))
      draw_pages(context);
    ImGui::EndChild();
    ImGui::SameLine(0, m.px(16));
    if (ImGui::BeginChild("page", {0, 0}, false, ImGuiWindowFlags_NavFlattened)) draw_page(context);
    ImGui::EndChild();
  }
  ImGui::End();
  if (!stays) close();
}

void Preferences::draw_pages(PanelContext& context) {
  const std::array<std::tuple<Page, const char*, const char*>, 6> pages{{
      {Page::interface, translatable("Interface"), "interface"},
      {Page::navigation, translatable("Navigation"), "navigation"},
      {Page::units, translatable("Units"), "units"},
      {Page::files, translatable("Files"), "files"},
      {Page::colours, translatable("Colours"), "colours"},
      {Page::keys, translatable("Keys"), "keys"},
  }};
  const float height = context.metrics.px(30);
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5F));
  for (const auto& [page, name, mark] : pages) {
    const std::string label = std::string("  ") + context.tr(name) + "###" + mark;
    if (ImGui::Selectable(label.c_str(), page == page_, 0, {0, height})) {
      page_ = page;
      keys_.stop();
    }
    context.marks.item(std::string("preferences.page.") + mark);
  }
  ImGui::PopStyleVar();
  const char* reset = context.tr(page_ == Page::keys ? "Reset all keys" : "Reset this page");
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ImGui::GetFrameHeight());
  if (ImGui::Button((std::string(reset) + "###reset").c_str(), {-1, 0})) {
    reset_page(context.editor.settings);
    keys_.stop();
  }
  context.marks.item("preferences.reset");
}

void Preferences::draw_page(PanelContext& context) {
  switch (page_) {
    case Page::interface:
      return interface_page(context);
    case Page::navigation:
      return navigation_page(context);
    case Page::units:
      return units_page(context);
    case Page::files:
      return files_page(context);
    case Page::colours: {
      check(context, translatable("Maps for colour-blind eyes"), "colour_blind_maps",
            context.editor.settings.colour_blind_maps);
      return;
    }
    case Page::keys:
      return keys_.draw(context);
  }
}

}  // namespace hariko
