#pragma once

// Options of exported triangles, how fine they are, as rows in the file dialog, with their number.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.hpp"
#include "core/exchange/mesh_file.hpp"
#include "ui/files/export_settings.hpp"
#include "ui/files/wall_options.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class ExportOptions {
 public:
  /// For the document in the editor and a file of this name: a tolerance in proportion to what is visible,
  /// the first time or when the one chosen before does not suit it.
  void begin(const Editor& editor, const std::filesystem::path& name);
  /// Draws the rows for a file of this name; each format has settings of its own. True when the triangles are
  /// others than before, and what is known has to be found anew.
  bool draw(PanelContext& context, const std::filesystem::path& name);
  /// Takes what was found of the triangles of these settings.
  void take(const ExportSettings& settings, const Result<ExportCount>& count);

  const ExportSettings& settings() const { return settings_; }

  /// Last settings of each format, by its ending.
  const std::map<std::string, ExportSettings>& remembered() const { return remembered_; }
  void remember(std::map<std::string, ExportSettings> formats) { remembered_ = std::move(formats); }

 private:
  /// The settings that the format of this name had last.
  void take_up(const std::filesystem::path& name);
  /// Another tolerance where the one chosen makes no sense for what is visible; texts as the numbers are.
  void suit_size();
  void kind_row(PanelContext& context);
  void file_row(PanelContext& context, const FormatChoices& format);
  void tolerance_row(PanelContext& context);
  void result_row(PanelContext& context) const;

  ExportSettings settings_;
  WallOptions wall_options_;
  std::string extension_;  ///< format whose settings these are
  std::map<std::string, ExportSettings> remembered_;
  double size_ = 0;  ///< diagonal of what is visible
  std::string distance_text_, angle_text_, scale_text_;
  std::optional<Result<ExportCount>> count_;  ///< count for `settings_`; nothing while it is being found
};

}  // namespace hariko
