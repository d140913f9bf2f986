#include "ui/shell/preference_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ui/base/fonts.hpp"
#include "ui/base/settings_members.hpp"
#include "ui/view/navigation.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr std::array motions{std::pair{NavigationAction::orbit, translatable("Orbit")},
                             std::pair{NavigationAction::pan, translatable("Pan")},
                             std::pair{NavigationAction::zoom, translatable("Zoom")}};
constexpr std::array buttons{std::pair{PointerButton::left, translatable("left drag")},
                             std::pair{PointerButton::middle, translatable("middle drag")},
                             std::pair{PointerButton::right, translatable("right drag")}};

/// Rows of navigation by the mouse's buttons: "Orbit" with "Middle drag, Alt + left drag", and so on.
std::vector<std::pair<std::string, std::string>> navigation_rows(const Language& tr,
                                                                 NavigationPreset preset) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [motion, name] : motions) {
    std::string drags;
    const auto add = [&](const std::string& text) { drags += (drags.empty() ? "" : ",  ") + text; };
    for (const auto& [button, drag] : buttons)
      for (int modifiers = 0; modifiers < 8; ++modifiers) {
        PointerEvent press;
        press.kind = PointerEvent::Kind::press;
        press.button = button;
        press.alt = (modifiers & 4) != 0;
        press.control = (modifiers & 2) != 0;
        press.shift = (modifiers & 1) != 0;
        // Alt need not be pressed where it makes no difference.
        PointerEvent plain = press;
        plain.alt = false;
        const auto moves = [&, wanted = motion](bool parallel) {
          const auto action = navigation_action(preset, press, parallel);
          return action == wanted && !(press.alt && navigation_action(preset, plain, parallel) == action);
        };
        const bool perspective = moves(false), parallel = moves(true);
        if (!perspective && !parallel) continue;
        const std::string keys = std::string(press.control ? "Ctrl + " : "") + (press.alt ? "Alt + " : "") +
                                 (press.shift ? "Shift + " : "") + tr(drag);
        add(perspective == parallel
                ? keys
                : fill(tr(perspective ? "{0} (perspective)" : "{0} (parallel views)"), {keys}));
      }
    for (const bool control : {false, true})
      for (const bool shift : {false, true}) {
        const bool plain = wheel_action(preset, false, false) == motion && (control || shift);
        if (wheel_action(preset, shift, control) != motion || plain || (control && shift)) continue;
        add(std::string(control ? "Ctrl + " : "") + (shift ? "Shift + " : "") +
            tr(preset == NavigationPreset::trackpad ? "two fingers" : "wheel"));
      }
    rows.emplace_back(tr(name), drags);
  }
  return rows;
}

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
      if (button(context_.tr(enum_choice(each).label), mark, value == each)) value = each;
    }
    ImGui::NewLine();
    if constexpr (std::is_same_v<Enum, NavigationPreset>) navigation_table(value);
    note(row->note);
  }

  void flag(const char* member, bool& value) {
    const PreferenceRow* row = begin(member);
    if (!row) return;
    if (!*row->on.mark) {
      value = mixed_check(context_.marks, std::string("preferences.") + member, "", value).value_or(value);
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
    number_slider(context_.marks, std::string("preferences.") + member, {low, high, row->format, flags},
                  value, std::min(context_.metrics.px(270), ImGui::GetContentRegionAvail().x));
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

  /// The language; files, which have no row, are chosen where they are used.
  void text(const char* member, std::string& value) {
    const PreferenceRow* row = begin(member);
    if (!row) return;
    const auto language = [&](const std::string& id, const std::string& name) {
      const char* why_not = fonts_can_write(name) ? nullptr : no_japanese_font;
      if (button(name.c_str(), std::string(member) + "." + id, value == id, why_not)) value = id;
      return why_not == nullptr;
    };
    bool all = language(english_id, "English");
    for (const LanguageFile& each : context_.editor.languages) all = language(each.id, each.name) && all;
    ImGui::NewLine();
    note(all ? row->note : no_japanese_font);
  }

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
    aligned_text(context_.tr(row->label));
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
    coloured_lines(palette().dim_text, context_.tr(text));
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
      chosen = text_button(context_.marks, "preferences." + mark, label);
    }
    if (on) ImGui::PopStyleColor(2);
    if (why_not && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) show_tip(context_.tr(why_not));
    ImGui::SameLine(0, context_.metrics.px(4));
    return chosen && !on;
  }

  /// Drags that orbit, pan and zoom, one line each.
  void navigation_table(NavigationPreset preset) {
    for (const auto& [motion, drags] : navigation_rows(context_.tr, preset)) {
      const float at = column();
      ImGui::SetCursorPosX(at);
      plain_text(motion);
      ImGui::SameLine(at + context_.metrics.px(80));
      coloured_lines(palette().dim_text, drags);
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
