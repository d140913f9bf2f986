#pragma once

// Rows of the preferences, as data: each shows a member of the settings by the name that their file has for
// it.

#include <span>

#include "ui/shell/preferences.hpp"

namespace hariko {

/// A flag's two choices where a check box would not say what they are.
struct PreferenceEnd {
  const char *mark = "", *label = "", *note = "";
};

struct PreferenceRow {
  const char* member;
  Preferences::Page page;
  const char* label = "";
  const char* note = "";  ///< a sentence below
  PreferenceEnd off = {}, on = {};
  double low = 0, high = 0;  ///< range of the slider of a number
  const char* format = "";   ///< likewise
  bool logarithmic = false;  ///< likewise
};

std::span<const PreferenceRow> preference_rows();

/// Draws the rows of a page in the order of the members.
void draw_preference_rows(PanelContext& context, Preferences::Page page);

/// Gives the members that a page shows their defaults.
void reset_preferences(Settings& settings, Preferences::Page page);

}  // namespace hariko
