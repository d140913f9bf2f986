#pragma once

// Offers of the workbench: unsaved work of earlier sessions, to be recovered or discarded; files that
// were opened or saved last; notice of an earlier session's crash, with the data for a report.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/jobs/background_work.hpp"
#include "app/persistence/crash_reports.hpp"
#include "app/persistence/recent_files.hpp"
#include "app/persistence/recovery_store.hpp"
#include "app/persistence/run_log.hpp"
#include "app/pictures/pictures.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Recovery offers of the workbench. For the main thread.
class RecoveryOffers {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// Borrows all but `log`, which receives "offers" and "discarded"; `background` must end before this object
  /// does.
  RecoveryOffers(Editor& editor, Workbench& workbench, const RecoveryStore& store, BackgroundWork& background,
                 Log log);

  /// Looks for recovery copies of earlier sessions and updates the workbench's offers.
  void find(Pictures& pictures);
  /// Deletes a recovery copy and its offer, after asking.
  void discard(const std::string& id);
  /// Removes an offer; the copy stays.
  void remove(const std::string& id);

 private:
  void show(const std::vector<Leftover>& leftovers, Pictures& pictures);
  void remove_copy(const std::string& id);

  Editor& editor_;
  Workbench& workbench_;
  const RecoveryStore& store_;
  BackgroundWork& background_;
  Log log_;
};

/// Recent files of the workbench. For the main thread.
class RecentOffers {
 public:
  /// Takes the file of the list. Borrows the other arguments; `background` must end before this object does.
  RecentOffers(Workbench& workbench, BackgroundWork& background, std::filesystem::path list);

  /// Reads the list and updates the workbench's offers, now and after each use.
  void find(Pictures& pictures);
  /// Moves a file to the front of the list.
  void used(const std::filesystem::path& path);

 private:
  void show(const std::vector<RecentEntry>& entries);

  Workbench& workbench_;
  BackgroundWork& background_;
  RecentFiles recent_;
  Pictures* pictures_ = nullptr;
};

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
