#pragma once

// EditJobs: edits that take long, made off the main thread.

#include <memory>
#include <vector>

#include "app/jobs/background_work.hpp"
#include "ui/editor/last_operation.hpp"

namespace hariko {

/// Edits for the main thread.
class EditJobs {
 public:
  /// `edits`: queue of work that an edit waits for.
  EditJobs(Editor& editor, BackgroundWork& edits) : editor_(editor), edits_(edits) {}

  /// Begins an edit; one of the same object that is not made yet is cancelled, as it would be refused.
  void make(const LongEdit& edit);
  /// Makes the steps of finished edits, unless a gesture is in progress. To be called each frame, except
  /// while a button is held: the press may become a drag, which continues from the document that it began
  /// with.
  void settle();

 private:
  struct Begun {
    ObjectId object;
    std::shared_ptr<const Job> job;
    LongEdit::Then then;  ///< empty until the work is done
  };

  Editor& editor_;
  BackgroundWork& edits_;
  std::vector<std::shared_ptr<Begun>> begun_;  ///< oldest first
};

}  // namespace hariko
