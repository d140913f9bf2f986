#pragma once

// RecentOffers: files that were opened or saved last, offered to be opened again.

#include <filesystem>
#include <vector>

#include "app/jobs/background_work.hpp"
#include "app/persistence/recent_files.hpp"
#include "app/pictures/pictures.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

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

}  // namespace hariko
