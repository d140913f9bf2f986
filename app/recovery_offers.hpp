#pragma once

// RecoveryOffers: unsaved work of earlier sessions, offered to be recovered or discarded.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/jobs/background_work.hpp"
#include "app/persistence/recovery_store.hpp"
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

}  // namespace hariko
