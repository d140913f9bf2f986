#pragma once

// How fine exported triangles are, as rows in the file dialog, with how many there will be.

#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "ui/export_settings.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/quantity.hpp"

namespace hariko {

class ExportOptions {
 public:
  static constexpr int rows = 3;

  /// For the document in the editor: a tolerance in proportion to what is visible, the first time or when the
  /// one chosen before does not suit it.
  void begin(const Editor& editor);
  /// Draws the rows; true when the settings have changed, and what is known has to be found anew.
  bool draw(const Editor& editor, Marks& marks, const Metrics& metrics);
  /// What the triangles of these settings are like.
  void take(const ExportSettings& settings, const Result<ExportCount>& count);

  const ExportSettings& settings() const { return settings_; }

 private:
  void tolerance_row(const Editor& editor, Marks& marks, const Metrics& metrics);
  void result_row(const Editor& editor) const;
  /// A number with its unit that may be typed.
  bool field(const char* id, const char* help, Marks& marks, float width, const Quantity& quantity,
             std::string& text, double& value);

  ExportSettings settings_;
  double size_ = 0;  ///< diagonal of what is visible
  std::string distance_text_, angle_text_;
  std::optional<Result<ExportCount>> count_;  ///< of `settings_`; nothing while it is being found
};

}  // namespace hariko
