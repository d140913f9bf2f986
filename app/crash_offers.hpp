#pragma once

// CrashOffers: notice of an earlier session's crash, with the data for a report.

#include <filesystem>
#include <functional>

#include "app/persistence/crash_reports.hpp"
#include "app/persistence/run_log.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Crash offers of the workbench. For the main thread.
class CrashOffers {
 public:
  using ShowFolder = std::function<bool(const std::filesystem::path&)>;

  /// Takes the folder with the reports; borrows the other arguments.
  CrashOffers(Editor& editor, Workbench& workbench, std::filesystem::path folder, const RunLog& log);
  /// Constructor with another way to show a folder, for tests; it returns false where it cannot be shown.
  CrashOffers(Editor& editor, Workbench& workbench, std::filesystem::path folder, const RunLog& log,
              ShowFolder show);

  /// Looks for reports and updates the workbench's offers.
  void find();
  /// Dismisses the reports and updates the workbench's offers.
  void dismiss();
  /// Shows the folder in the file manager; without one a notice gives its path.
  void show_folder();

 private:
  Editor& editor_;
  Workbench& workbench_;
  std::filesystem::path folder_;
  const RunLog& log_;
  CrashReports reports_;
  ShowFolder show_;
};

}  // namespace hariko
