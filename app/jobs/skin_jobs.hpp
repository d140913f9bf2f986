#pragma once

// SkinJobs: slow work on skins, off the main thread.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/engines/rebuild_engine.hpp"
#include "app/jobs/background_work.hpp"
#include "core/skinning/edit/skin_edit.hpp"

namespace hariko {

/// Jobs on skins. For the main thread.
class SkinJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `edits`: queue of work that an edit waits for. `log`: receives "section_added".
  SkinJobs(Editor& editor, BackgroundWork& edits, Log log)
      : editor_(editor), edits_(edits), log_(std::move(log)) {}

  /// Requests a section taken from the surface of a skin at a place of its path. Requests are carried out in
  /// order, one undoable step each, by `settle`, which then selects the new points. A skin that changed
  /// meanwhile stays as it is, and a notice says so; cancelling one section cancels those that wait. With
  /// another document open they are dropped.
  void add_section(ObjectId object, double place);
  /// Shows a job while a surface waits for the places of its columns; cancelling it stops the rebuild.
  void follow(RebuildEngine& engine);
  /// Applies a finished section, unless a gesture is in progress. To be called each frame, except while a
  /// button is held: the press may become a drag.
  void settle();

 private:
  struct WantedSection {
    ObjectId object;
    double place;
    std::uint64_t documents;  ///< `Editor::documents` of the document that it is for
  };
  struct MadeSection {
    std::shared_ptr<const Object> object;  ///< as when the section was taken
    Result<SkinEdit> edit;
  };
  void make_section();
  /// Present skin, if it is unchanged since the work began; otherwise null, after the notice `changed`.
  const Object* still(const Object& object, const char* changed) const;
  void take(const MadeSection& made);

  Editor& editor_;
  BackgroundWork& edits_;
  Log log_;
  std::shared_ptr<const Job> adding_;   ///< the section being made
  std::deque<WantedSection> wanted_;    ///< requests; the first one is being made
  std::optional<MadeSection> made_;     ///< finished, waits for `settle`
  std::shared_ptr<const Job> placing_;  ///< shown among the editor's jobs
};

}  // namespace hariko
