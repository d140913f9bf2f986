#pragma once

// SkinJobs: work on skins that takes long, off the main thread.

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/engines/rebuild_engine.hpp"
#include "app/jobs/background_work.hpp"
#include "core/skinning/skin_edit.hpp"

namespace hariko {

/// For the main thread.
class SkinJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `files`: where exports wait for each other; `edits`: for work that an edit waits for. `log`: told when
  /// something is done, "control_exported", "section_added" or "export_failed".
  SkinJobs(Editor& editor, BackgroundWork& files, BackgroundWork& edits, Log log)
      : editor_(editor), files_(files), edits_(edits), log_(std::move(log)) {}

  /// Takes a section from the surface of a skin, at a place of its path, once those that were asked for
  /// before are there: one step each, by `settle`, after which the new points are selected. A skin that was
  /// changed meanwhile stays as it is, and a notice says so; cancelling one section cancels those that wait.
  void add_section(ObjectId object, double place);
  /// Writes the control meshes of the visible skins.
  void export_control(const std::filesystem::path& path);
  /// Shows a job while a surface waits for the places of its columns; cancelling it stops the rebuilding.
  void follow(RebuildEngine& engine);
  /// Takes a section that is there, unless a gesture goes on. To be called each frame, but not while a button
  /// is held: what is pressed may become a drag.
  void settle();

 private:
  struct WantedSection {
    ObjectId object;
    double place;
  };
  struct MadeSection {
    std::shared_ptr<const Object> object;  ///< as it was when the section was taken
    Result<SkinEdit> edit;
  };
  void make_section();
  /// The skin, if it still is what work began with; else null, after saying `changed`.
  const Object* still(const Object& object, const char* changed) const;
  void take(const MadeSection& made);

  Editor& editor_;
  BackgroundWork &files_, &edits_;
  Log log_;
  std::shared_ptr<const Job> adding_;   ///< the section that is made
  std::deque<WantedSection> wanted_;    ///< the first one is being made
  std::optional<MadeSection> made_;     ///< waits for `settle`
  std::shared_ptr<const Job> placing_;  ///< among the editor's jobs
};

}  // namespace hariko
