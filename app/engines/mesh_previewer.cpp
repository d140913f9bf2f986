#include "app/engines/mesh_previewer.hpp"

#include "app/engines/mesh_preview.hpp"

namespace hariko {

namespace {

constexpr WorkLane::Key only_mesh = 0;

}  // namespace

MeshPreviewer::MeshPreviewer(Editor& editor, std::function<void()> wake, std::function<void()> published)
    : editor_(editor), published_(std::move(published)), lane_(std::move(wake)) {}

void MeshPreviewer::forget() {
  lane_.cancel(only_mesh);
  object_.reset();
  editor_.meshing.job.reset();
  editor_.meshing.result.reset();
  editor_.meshing.stopped = false;
}

void MeshPreviewer::sync() {
  Meshing& meshing = editor_.meshing;
  if (!meshing.open || !editor_.has_document) {
    if (object_ || meshing.result) forget();
    return;
  }
  if (meshing.stopped && meshing.job) {
    lane_.cancel(only_mesh);
    meshing.job.reset();
  }
  // Lengths are chosen when the panel is drawn for the first time.
  if (meshing.stopped || meshing.size == 0 || editor_.history.in_gesture()) return;
  const auto object = meshed_object(editor_.document(), editor_.selection.active);
  if (!object) return forget();
  if (object == object_ && meshing.settings == settings_) return;
  object_ = object;
  settings_ = meshing.settings;
  const auto job = std::make_shared<const Job>(Job{"", true, CancelToken::make(), Progress::make()});
  meshing.job = job;
  lane_.submit(
      only_mesh,
      [this, job, object, settings = settings_,
       document = editor_.document()](const CancelToken& cancel) -> WorkLane::Publication {
        auto result = std::make_shared<const MeshingResult>(
            preview_mesh(document, object, settings, cancel, job->progress));
        return [this, job, result] {
          if (editor_.meshing.job == job) editor_.meshing.job.reset();
          editor_.meshing.result = result;
          published_();
        };
      },
      WorkLane::Running::cancel);
}

}  // namespace hariko
