#include "app/jobs/edit_jobs.hpp"

#include <algorithm>

namespace hariko {

void EditJobs::make(const LongEdit& edit) {
  for (const auto& other : begun_)
    if (other->object == edit.object) other->job->cancel.cancel();
  const auto begun = std::make_shared<Begun>(Begun{edit.object, {}, {}});
  edits_.run_cancellable(edit.what, edit.work, [begun](const LongEdit::Then& then) { begun->then = then; });
  begun->job = editor_.jobs.back();
  begun_.push_back(begun);
}

void EditJobs::settle() {
  if (editor_.history.in_gesture()) return;
  const auto unfinished = std::stable_partition(begun_.begin(), begun_.end(),
                                                [](const auto& begun) { return begun->then != nullptr; });
  const std::vector<std::shared_ptr<Begun>> finished(begun_.begin(), unfinished);
  begun_.erase(begun_.begin(), unfinished);
  // It may have been finished when it was cancelled.
  for (const auto& begun : finished)
    if (!begun->job->cancel.cancelled()) begun->then();
}

}  // namespace hariko
