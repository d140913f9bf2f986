#include "app/engines/gauss_engine.hpp"

#include <algorithm>

namespace hariko {

namespace {

constexpr WorkLane::Key only_gauss_map = 0;

std::shared_ptr<const Object> active_outline_of(const Editor& editor) {
  if (!editor.has_document) return nullptr;
  const auto& objects = editor.document().objects;
  const auto found = std::ranges::find_if(objects, [&](const auto& object) {
    return object->id == editor.selection.active && object->outline();
  });
  return found == objects.end() ? nullptr : *found;
}

}  // namespace

GaussEngine::GaussEngine(const Editor& editor, GaussView& view, std::function<void()> wake)
    : editor_(editor), view_(view), lane_(std::move(wake)) {}

void GaussEngine::forget() {
  lane_.cancel(only_gauss_map);
  object_.reset();
  step_.reset();
  view_.step.reset();
  view_.forget();
}

void GaussEngine::sync() {
  const auto object = view_.shown ? active_outline_of(editor_) : nullptr;
  if (!object) {
    if (object_) forget();
    return;
  }
  if (object_ && object_->id != object->id) forget();
  if (object == object_ && view_.step == step_) return;
  object_ = object;
  step_ = view_.step;
  lane_.submit(
      only_gauss_map,
      [this, object, step = step_](const CancelToken& cancel) -> WorkLane::Publication {
        const OutlineSource& source = *object->outline();
        auto sphere =
            std::make_shared<const GaussSphere>(gauss_sphere(*source.outline, source.settings, step, cancel));
        return [this, object, step, sphere] {
          // Deselects sites that no longer exist.
          const bool fewer =
              !view_.has(view_.selected) || !sphere->mesh || *view_.selected >= sphere->mesh->site_count();
          if (fewer) view_.selected.reset();
          view_.sphere = sphere;
          view_.object = object;
          view_.made_step = step && *step < sphere->inserted ? step : std::nullopt;
        };
      },
      WorkLane::Running::finish);
}

}  // namespace hariko
