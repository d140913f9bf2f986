#pragma once

// CrashOffers: shows that an earlier session crashed, and what a report about it needs.

#include <filesystem>
#include <functional>

#include "app/persistence/crash_reports.hpp"
#include "app/persistence/run_log.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// For the main thread.
class CrashOffers {
 public:
  using ShowFolder = std::function<bool(const std::filesystem::path&)>;

  /// Takes the folder with the reports and the log. All but the paths is borrowed.
  CrashOffers(Editor& editor, Workbench& workbench, std::filesystem::path folder, const RunLog& log);
  /// With another way to show a folder, for tests: false where it cannot be shown.
  CrashOffers(Editor& editor, Workbench& workbench, std::filesystem::path folder, const RunLog& log,
              ShowFolder show);

  /// The workbench's offers follow.
  void find();
  void dismiss();
  /// In the file manager; where there is none a notice says where it lies.
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
