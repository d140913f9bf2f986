#pragma once

// Options of STEP and IGES export, as rows in the file dialog, with what they make of the surfaces.

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/cad/cad_totals.hpp"
#include "ui/base/quantity.hpp"
#include "ui/files/export_settings.hpp"
#include "ui/files/wall_options.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class CadOptions {
 public:
  /// For the document in the editor: a tolerance in proportion to what is visible, the first time or when the
  /// one chosen before does not suit it.
  void begin(const Editor& editor);
  /// Draws the rows for a file of this name. True when the faces are others than before, and what is known
  /// has to be found anew.
  bool draw(PanelContext& context, const std::filesystem::path& name);
  /// Takes what was found of the faces of these settings.
  void take(const CadSettings& settings, const Result<CadTotals>& count);

  const CadSettings& settings() const { return settings_; }
  void remember(const CadChoices& choices) { settings_.choices = choices; }

 private:
  void quality_row(PanelContext& context);
  void tolerance_row(PanelContext& context);
  void unit_row(PanelContext& context);
  void add_schema(PanelContext& context, const std::filesystem::path& name);
  void result_rows(PanelContext& context) const;
  /// Size of what is visible, as it is written.
  double size() const { return settings_.choices.scale * size_; }
  /// Distance of a quality, in the document's unit.
  double tolerance_of(CadQuality quality, Unit unit) const;
  void take_quality(CadQuality quality, Unit unit);

  CadSettings settings_;
  WallOptions wall_options_;
  double size_ = 0;  ///< diagonal of what is visible
  std::string tolerance_text_, angle_text_, scale_text_;
  std::optional<Result<CadTotals>> count_;  ///< totals for `settings_`; nothing while they are being found
};

}  // namespace hariko
