#include "ui/view/view_pictures.hpp"

#include <algorithm>
#include <chrono>

namespace hariko {

namespace {

/// Adds the time of a picture; nothing remains where one is not known or had other samples. Begins with no
/// samples.
void add_time(std::optional<PictureTime>& sum, const std::optional<PictureTime>& one) {
  if (!sum) return;
  if (!one || (sum->samples > 0 && sum->samples != one->samples)) return sum.reset();
  *sum = {sum->milliseconds + one->milliseconds, one->samples};
}

}  // namespace

void ViewPictures::update(Editor& editor, const SceneBuilder& scene, std::span<const Shown> shown, bool busy,
                          std::uint64_t jumps) {
  statistics_ = {};
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t before = drawn_;
  for (int view = 0; view < ViewLayout::count; ++view) {
    State& state = states_[static_cast<std::size_t>(view)];
    const bool shows = std::ranges::any_of(shown, [&](const Shown& s) { return s.view == view; });
    if (shows || !state.exists) continue;
    renderer_.forget(view);
    state = {};
  }
  const bool slow = motion_.samples() < full_samples;
  std::optional<PictureTime> time = PictureTime{};  // the time of all pictures drawn here
  bool other_drawn = false;
  next_other_ = (next_other_ + 1) % ViewLayout::count;
  // The active view first, then the others in turn.
  std::vector<Shown> order(shown.begin(), shown.end());
  const auto rank = [&](const Shown& s) {
    return s.view == editor.layout.active() ? -1
                                            : (s.view - next_other_ + ViewLayout::count) % ViewLayout::count;
  };
  std::sort(order.begin(), order.end(), [&](const Shown& a, const Shown& b) { return rank(a) < rank(b); });
  for (const Shown& s : order) {
    State& state = states_[static_cast<std::size_t>(s.view)];
    const View& view = editor.layout.views[static_cast<std::size_t>(s.view)];
    const bool changed = !state.exists || state.version != scene.version() || state.size != s.size ||
                         !(state.camera == view.camera(editor.now));
    if (changed) state.changed_at = editor.now;
    const bool moving = busy || view.flying(editor.now) || editor.now - state.changed_at < rest_seconds;
    const int samples = moving && state.exists ? motion_.samples() : full_samples;
    const bool wanted = changed || samples > state.samples || state.unfinished;
    const bool waits = slow && wanted && state.exists && s.view != editor.layout.active() && other_drawn;
    state.stale = changed && waits;
    if (!wanted || waits) continue;
    // Replays show the same pictures at any speed.
    if (state.jumps != jumps && state.exists && state.size == s.size && !editor.recording &&
        renderer_.keep(s.view))
      state.fades_from = editor.now;
    state.jumps = jumps;
    add_time(time, draw(editor, scene, s, samples));
    other_drawn = other_drawn || s.view != editor.layout.active() || samples == full_samples;
  }
  if (time && time->samples > 0) motion_.measured(time->samples, time->milliseconds);
  milliseconds_ = 0;
  if (!editor.frame_times.visible || drawn_ == before) return;
  renderer_.finish();
  milliseconds_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::optional<PictureTime> ViewPictures::draw(Editor& editor, const SceneBuilder& scene, const Shown& shown,
                                              int samples) {
  State& state = states_[static_cast<std::size_t>(shown.view)];
  const Camera camera = editor.layout.views[static_cast<std::size_t>(shown.view)].camera(editor.now);
  const auto done = renderer_.draw(scene.scene_of(shown.view), camera,
                                   {shown.size, samples, shown.view, upload_bytes, motion_.chooses()});
  if (!done.ok()) editor.notify(done.error());
  if (state.size != shown.size) state.fades_from = -1;
  state.exists = true;
  state.stale = false;
  state.version = scene.version();
  state.camera = camera;
  state.size = shown.size;
  state.samples = samples;
  const FrameStatistics& now = renderer_.statistics();
  state.unfinished = now.unfinished;
  statistics_.uploaded_bytes += now.uploaded_bytes;
  statistics_.triangles += now.triangles;
  statistics_.draw_calls += now.draw_calls;
  ++drawn_;
  return now.time;
}

double ViewPictures::shown_share(int view, double now) const {
  const State& state = states_[static_cast<std::size_t>(view)];
  if (state.fades_from < 0 || now >= state.fades_from + fade_seconds) return 1;
  const double left = 1 - std::max(0.0, now - state.fades_from) / fade_seconds;
  return 1 - left * left;
}

double ViewPictures::next_frame_in(const Editor& editor, bool busy) const {
  double next = -1;
  for (const State& state : states_) {
    if (state.stale || state.unfinished ||
        shown_share(static_cast<int>(&state - states_.data()), editor.now) < 1)
      return 0;
    if (!wants_rest(state) || busy) continue;
    const double in = std::max(0.0, state.changed_at + rest_seconds - editor.now);
    next = next < 0 ? in : std::min(next, in);
  }
  return next;
}

}  // namespace hariko
