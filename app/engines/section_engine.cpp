#include "app/engines/section_engine.hpp"

#include <utility>

namespace hariko {

namespace {

constexpr WorkLane::Key only_sections = 0;

}  // namespace

SectionEngine::SectionEngine(const Editor& editor, SectionCurves& curves, std::function<void()> wake)
    : editor_(editor), curves_(curves), lane_(std::move(wake)) {}

SectionEngine::Request SectionEngine::wanted() const {
  Request out{{}, curves_.planes, curves_.combs};
  for (const auto& object : editor_.document().objects) {
    const SurfaceView* view =
        object->visible && object->display.surface && editor_.views ? editor_.view_of(object->id) : nullptr;
    if (!view || !view->mesh) continue;
    for (const Similarity& place : places_of(*object)) out.surfaces.emplace_back(view->mesh, place);
  }
  return out;
}

void SectionEngine::sync() {
  if (!curves_.shown || !editor_.has_document) {
    if (!requested_) return;
    lane_.cancel(only_sections);
    requested_.reset();
    curves_.forget();
    return;
  }
  Request request = wanted();
  if (requested_ == request) return;
  requested_ = std::move(request);
  lane_.submit(
      only_sections,
      [this, surfaces = surfaces_to_cut(editor_), planes = curves_.planes,
       combs = curves_.combs](const CancelToken& cancel) -> WorkLane::Publication {
        const Result<SectionSet> made = section_set(surfaces, planes, cancel);
        if (!made.ok())
          return [this, error = made.error()] {
            curves_.forget();
            if (error.code != e_cancelled) curves_.error = error;
          };
        const auto set = std::make_shared<const SectionSet>(*made);
        return [this, set, lines = drawn_section_lines(*set), teeth = drawn_section_teeth(*set, combs)] {
          curves_.error.reset();
          curves_.set = set;
          curves_.lines = lines;
          curves_.teeth = teeth;
        };
      },
      WorkLane::Running::finish);
}

}  // namespace hariko
