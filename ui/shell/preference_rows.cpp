#include "ui/shell/preference_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <type_traits>

#include "ui/base/fonts.hpp"
#include "ui/base/settings_members.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/shell/navigation_rows.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float label_column = 190, narrow_column = 8, least_field = 170;
constexpr std::array interface_scales{0.75F, 1.0F, 1.25F, 1.5F, 1.75F, 2.0F, 2.5F};

using Page = Preferences::Page;
constexpr const char* speed_format = "%.2f \u00d7";
constexpr std::array rows_of_preferences{
    PreferenceRow{"theme", Page::interface, translatable("Theme")},
    PreferenceRow{"interface_scale", Page::interface, translatable("Scale"),
                  translatable("On top of the scale of the monitor.")},
    PreferenceRow{"language", Page::interface, translatable("Language")},
    PreferenceRow{"navigation", Page::navigation, translatable("Mouse buttons as in")},
    PreferenceRow{.member = "trackball",
                  .page = Page::navigation,
                  .label = translatable("Turning"),
                  .off = {"turntable", translatable("Turntable"), translatable("The horizon stays level.")},
                  .on = {"trackball", translatable("Trackball"), translatable("The view rolls freely.")}},
    PreferenceRow{"zoom_to_cursor", Page::navigation, translatable("Zoom towards the pointer")},
    PreferenceRow{"invert_wheel", Page::navigation, translatable("Turn the wheel the other way")},
    PreferenceRow{"orbit_selection", Page::navigation, translatable("Orbit about the selection")},
    PreferenceRow{.member = "orbit_speed",
                  .page = Page::navigation,
                  .label = translatable("Orbit speed"),
                  .low = 0.25,
                  .high = 4,
                  .format = speed_format,
                  .logarithmic = true},
    PreferenceRow{.member = "zoom_speed",
                  .page = Page::navigation,
                  .label = translatable("Zoom speed"),
                  .low = 0.25,
                  .high = 4,
                  .format = speed_format,
                  .logarithmic = true},
    PreferenceRow{"unit", Page::units, translatable("Unit of new documents"),
                  translatable("A document keeps its own unit; it is in its properties.")},
    PreferenceRow{
        .member = "autosave_seconds",
        .page = Page::files,
        .label = translatable("Save a copy for recovery every"),
        .note = translatable(
            "After a crash the next start offers the copy. Your file is written only when you save."),
        .low = 1,
        .high = Settings::most_autosave_seconds,
        .format = "%.0f s"},
    PreferenceRow{"colour_blind_maps", Page::colours, translatable("Maps for colour-blind eyes")},
    PreferenceRow{"keys", Page::keys, translatable("Keys")},
};

/// Row of a member on a page; null where the page does not show it.
const PreferenceRow* preference_row(std::string_view member, Page page) {
  for (const PreferenceRow& row : rows_of_preferences)
    if (row.member == member && row.page == page) return &row;
  return nullptr;
}

/// Draws the members that have a row on the page, and changes them.
class PreferenceFields {
 public:
  PreferenceFields(PanelContext& context, Page page) : context_(context), page_(page) {}

  template <class Enum>
  void choice(const char* member, Enum& value) {
    const PreferenceRow* row = begin(member);
    if (!row) return;
    for (const Enum each : enum_values<Enum>()) {
      const std::string mark = std::string(member) + "." + std::string(enum_word(each));
      if (button(context_.tr(enum_choice(each).label), mark, value == each, why_not(each))) value = each;
    }
    ImGui::NewLine();
    if constexpr (std::is_same_v<Enum, NavigationPreset>) navigation_table(value);
    if constexpr (std::is_same_v<Enum, LanguageId>)
      if (!japanese_font_installed()) note(no_japanese_font);
    note(row->note);
  }

  void flag(const char* member, bool& value) {
    const PreferenceRow* row = begin(member);
    if (!row) return;
    if (!*row->on.mark) {
      ImGui::Checkbox((std::string("###") + member).c_str(), &value);
      context_.marks.item(std::string("preferences.") + member);
      return note(row->note);
    }
    for (const bool each : {false, true}) {
      const PreferenceEnd& end = each ? row->on : row->off;
      if (button(context_.tr(end.label), end.mark, value == each)) value = each;
    }
    ImGui::NewLine();
    note(value ? row->on.note : row->off.note);
  }

  void number(const char* member, double least, double most, double& value) {
    const PreferenceRow* row = begin(member);
    if (!row) return;
    const double low = std::max(least, row->low), high = std::min(most, row->high);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;
    if (row->logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    number_slider((std::string("###") + member).c_str(), {low, high, row->format, flags}, value,
                  std::min(context_.metrics.px(270), ImGui::GetContentRegionAvail().x));
    context_.marks.item(std::string("preferences.") + member);
    note(row->note);
  }

  /// The scale of the interface; other sizes of the interface have no row.
  void number(const char* member, double, double, float& value) {
    const PreferenceRow* row = begin(member);
    if (!row) return;
    for (const float scale : interface_scales) {
      const std::string percent = std::to_string(static_cast<int>(std::lround(scale * 100)));
      if (button((percent + " %").c_str(), "scale." + percent, std::abs(value - scale) < 1e-3F))
        value = scale;
    }
    ImGui::NewLine();
    note(row->note);
  }

  /// Files are chosen where they are used.
  void text(const char*, std::string&) {}

  /// Keys have a page of their own making.
  void texts(const char*, std::map<std::string, std::string>&) {}

 private:
  /// Left edge of fields: right of their names, or below them where a page is narrow.
  float column() const {
    const float beside = context_.metrics.px(label_column), least = context_.metrics.px(least_field);
    return ImGui::GetWindowContentRegionMax().x >= beside + least ? beside
                                                                  : context_.metrics.px(narrow_column);
  }

  /// The name of a row; what follows stands in the right column.
  const PreferenceRow* begin(const char* member) {
    const PreferenceRow* row = preference_row(member, page_);
    if (!row) return nullptr;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(context_.tr(row->label));
    const float at = column();
    if (at >= context_.metrics.px(label_column))
      ImGui::SameLine(at);
    else
      ImGui::SetCursorPosX(at);
    return row;
  }

  /// A sentence below a row.
  void note(const char* text) {
    if (!*text) return;
    ImGui::SetCursorPosX(column());
    const TextColour dim(palette().dim_text);
    text_in_lines(context_.tr(text));
  }

  /// One of several choices side by side. True when it was chosen now.
  bool button(const char* label, const std::string& mark, bool on, const char* why_not = nullptr) {
    if (on) {
      ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(palette().accent, 0.28F));
      ImGui::PushStyleColor(ImGuiCol_Text, palette().accent);
    }
    const float width = ImGui::CalcTextSize(label).x + ImGui::GetStyle().FramePadding.x * 2;
    if (ImGui::GetCursorPosX() + width > ImGui::GetWindowContentRegionMax().x) {
      ImGui::NewLine();
      ImGui::SetCursorPosX(column());
    }
    bool chosen = false;
    {
      const Disabled disabled(why_not != nullptr);
      chosen = ImGui::Button((std::string(label) + "###" + mark).c_str());
      context_.marks.item("preferences." + mark);
    }
    if (on) ImGui::PopStyleColor(2);
    if (why_not && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) show_tip(context_.tr(why_not));
    ImGui::SameLine(0, context_.metrics.px(4));
    return chosen && !on;
  }

  template <class Enum>
  static const char* why_not(Enum value) {
    if constexpr (std::is_same_v<Enum, LanguageId>)
      if (value == LanguageId::japanese && !japanese_font_installed()) return no_japanese_font;
    return nullptr;
  }

  /// Drags that orbit, pan and zoom, one line each.
  void navigation_table(NavigationPreset preset) {
    for (const auto& [motion, drags] : navigation_rows(context_.tr, preset)) {
      const float at = column();
      ImGui::SetCursorPosX(at);
      ImGui::TextUnformatted(motion.c_str());
      ImGui::SameLine(at + context_.metrics.px(80));
      const TextColour dim(palette().dim_text);
      text_in_lines(drags);
    }
  }

  PanelContext& context_;
  Page page_;
};

/// Visits the settings beside fresh ones.
class PreferenceReset {
 public:
  explicit PreferenceReset(Page page) : page_(page) {}
  template <class Value>
  void choice(const char* member, Value& value, const Value& fresh) {
    if (preference_row(member, page_)) value = fresh;
  }
  void flag(const char* member, bool& value, bool fresh) { choice(member, value, fresh); }
  template <class Value>
  void number(const char* member, double, double, Value& value, const Value& fresh) {
    choice(member, value, fresh);
  }
  void text(const char* member, std::string& value, const std::string& fresh) {
    choice(member, value, fresh);
  }
  template <class Value>
  void texts(const char* member, Value& value, const Value& fresh) {
    choice(member, value, fresh);
  }

 private:
  Page page_;
};

}  // namespace

std::span<const PreferenceRow> preference_rows() {
  return rows_of_preferences;
}

void draw_preference_rows(PanelContext& context, Page page) {
  PreferenceFields fields(context, page);
  visit_settings(fields, context.editor.settings);
}

void reset_preferences(Settings& settings, Page page) {
  const Settings fresh;
  PreferenceReset reset(page);
  visit_settings(reset, settings, fresh);
}

}  // namespace hariko
