#include "app/input/frame_meter.hpp"

#include <algorithm>

namespace hariko {

void FrameMeter::measure(Editor& editor, const Frame& frame, std::span<const InputEvent> input, double now) {
  const double total =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - frame.start).count();
  const double renderer = frame.end.drawing + frame.viewport;
  editor.frame_times.add({std::max(0.0, total - renderer - frame.end.showing), renderer});
  const Object* object = editor.active_object();
  const SurfaceView* shown = object ? editor.view_of(object->id) : nullptr;
  // The surface shown by this frame answers the drag that made its object.
  while (shown && !dragged_.empty()) {
    const auto found =
        std::ranges::find_if(dragged_, [&](const auto& entry) { return entry.first == shown->object; });
    if (found == dragged_.end()) break;
    editor.frame_times.add_latency(1000 * (now - found->second));
    dragged_.erase(dragged_.begin(), found + 1);
  }
  if (!editor.history.in_gesture()) return dragged_.clear();
  if (input.empty() || !object) return;
  for (const auto& candidate : editor.document().objects)
    if (candidate.get() == object) dragged_.emplace_back(candidate, input.front().came_at);
}

}  // namespace hariko
