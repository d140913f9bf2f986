#pragma once

// SkinJobs: work on skins that takes long, off the main thread.

#include <filesystem>
#include <functional>

#include "app/background_work.hpp"
#include "app/rebuild_engine.hpp"
#include "core/modeling/skin_polyhedron.hpp"

namespace hariko {

/// For the main thread.
class SkinJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: told when something is done, "control_exported", "converted" or "export_failed".
  SkinJobs(Editor& editor, BackgroundWork& work, Log log)
      : editor_(editor), work_(work), log_(std::move(log)) {}

  /// Makes a polyhedron of a skin as it is now; a conversion that is on its way is cancelled. One step at the
  /// end: the polyhedron comes and the skin is hidden. A skin that was changed meanwhile stays as it is, and
  /// a notice says so.
  void convert(ObjectId object);
  /// Writes the control meshes of the visible skins.
  void export_control(const std::filesystem::path& path);
  /// Shows a job while a surface waits for the places of its columns; cancelling it stops the rebuilding.
  void follow(RebuildEngine& engine);

 private:
  void take(const std::shared_ptr<const Object>& object, const Result<SkinPolyhedron>& made);

  Editor& editor_;
  BackgroundWork& work_;
  Log log_;
  std::shared_ptr<const Job> converting_;
  int conversions_ = 0;                 ///< asked for
  std::shared_ptr<const Job> placing_;  ///< among the editor's jobs
};

}  // namespace hariko
