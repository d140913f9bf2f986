#include "app/jobs/skin_jobs.hpp"

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "core/skinning/edit/add_section.hpp"
#include "ui/base/job.hpp"
#include "ui/editor/skin_edits.hpp"

namespace hariko {

void SkinJobs::add_section(ObjectId id, double place) {
  // Ignores a repeated request, as by two clicks on one spot.
  for (const WantedSection& wanted : wanted_)
    if (wanted.object == id && wanted.place == place && wanted.documents == editor_.documents) return;
  wanted_.push_back({id, place, editor_.documents});
  if (wanted_.size() == 1) make_section();
}

void SkinJobs::make_section() {
  while (!wanted_.empty()) {
    const auto [id, place, documents] = wanted_.front();
    const auto object = editor_.history.current().find_shared(id);
    if (documents != editor_.documents || !object || !object->skin()) {
      wanted_.pop_front();
      continue;
    }
    edits_.run_cancellable(
        Phrase(translatable("Adding a section to {0}"), {object->name}),
        [object, at = place](const CancelToken& cancel, const Progress& progress) {
          SkinWork work;
          work.cancel = cancel;
          work.progress = progress;
          return hariko::add_section(*object->skin()->skin, at, work);
        },
        [this, object](const Result<SkinEdit>& edit) {
          made_ = MadeSection{object, edit};
        });
    adding_ = editor_.jobs.back();
    return;
  }
}

void SkinJobs::settle() {
  // A gesture continues from the skin that it began with: a section added meanwhile would be lost.
  if (!made_ || editor_.history.in_gesture()) return;
  const MadeSection made = *std::move(made_);
  made_.reset();
  const bool here = wanted_.front().documents == editor_.documents;
  wanted_.pop_front();
  // It may have been finished when it was cancelled.
  if (adding_->cancel.cancelled() || (!made.edit.ok() && made.edit.error().code == e_cancelled))
    wanted_.clear();
  else if (here)
    take(made);
  make_section();
}

const Object* SkinJobs::still(const Object& object, const char* changed) const {
  const Object* now = editor_.history.current().find(object.id);
  if (!now || !now->skin()) return nullptr;
  if (now->skin()->skin == object.skin()->skin) return now;
  editor_.warn(changed);
  return nullptr;
}

void SkinJobs::take(const MadeSection& made) {
  const Object& object = *made.object;
  if (!made.edit.ok()) return editor_.notify(made.edit.error());
  if (!still(object, translatable("The skin was changed while the section was taken. Add it again."))) return;
  if (!commit_skin(editor_, object.id, made.edit, translatable("Add section"))) return;
  if (editor_.selection.active == object.id) select_new_points(editor_, *made.edit);
  log_("section_added", {});
}

void SkinJobs::follow(RebuildEngine& engine) {
  constexpr double noticeable = 0.3;  // seconds
  double least = 1;
  for (const auto& [id, since] : editor_.stale_since)
    if (const double share = engine.progress(id); share >= 0 && editor_.now - since > noticeable)
      least = std::min(least, share);
  if (least < 1) {
    if (!placing_) {
      placing_ = std::make_shared<const Job>(Job{translatable("Placing columns"), true, CancelToken::make(),
                                                 Progress::make(), Job::Kind::placing_columns});
      editor_.jobs.insert(editor_.jobs.begin(), placing_);
    }
    placing_->progress.report(least);
  }
  if (!placing_) return;
  if (placing_->cancel.cancelled()) engine.cancel_all();
  if (least < 1 && !placing_->cancel.cancelled()) return;
  std::erase(editor_.jobs, placing_);
  placing_.reset();
}

}  // namespace hariko
