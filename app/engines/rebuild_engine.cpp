#include "app/engines/rebuild_engine.hpp"

#include "core/document/object_shape.hpp"

#include <algorithm>
#include <utility>

namespace hariko {

namespace {

WorkLane::Key surface_key(ObjectId id) {
  return id.value;
}
WorkLane::Key measure_key(ObjectId id) {
  return id.value | (WorkLane::Key{1} << 32);
}

/// Whether two objects need the same view; their names and transforms do not matter.
bool same_view(const Object& a, const Object& b) {
  const DisplaySettings &p = a.display, &q = b.display;
  return a.source == b.source && p.map == q.map && p.density == q.density && p.ranges == q.ranges &&
         p.combs.shown == q.combs.shown && (!p.combs.shown || p.combs.density == q.combs.density);
}

/// Whether the neighbours of an object are unchanged relative to the object.
bool same_neighbours(const Object& a, const ObjectPointers& of_a, const Object& b,
                     const ObjectPointers& of_b) {
  const auto same = [](const auto& x, const auto& y) {
    return x == y || (x->id == y->id && x->source == y->source && x->transform == y->transform);
  };
  return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), same) &&
         (of_a.empty() || a.transform == b.transform);
}

/// Whether a map has the same values and the same colours.
bool same_map(const MapSurroundings& a, const MapSurroundings& b) {
  return a.limit == b.limit && same_values(a, b);
}

/// Whether a view's values are shown in the range of the one before it: ranges stay fixed during gestures.
bool keeps_range(const SurfaceView& shown, const SurfaceView& next) {
  return shown.mesh && shown.object->display.map == next.object->display.map &&
         shown.object->display.ranges == next.object->display.ranges &&
         shown.range.centre == next.range.centre && shown.histogram.empty() == next.histogram.empty();
}

/// Whether an object is drawn; facets of reference meshes are drawn like surfaces.
bool is_drawn(const Object& object) {
  return has_shape(object);
}

}  // namespace

RebuildEngine::RebuildEngine(MakeBuilder make_builder, std::function<void()> wake, OnPublished on_published)
    : make_builder_(std::move(make_builder)),
      on_published_(std::move(on_published)),
      lane_(wake),
      ahead_lane_(std::move(wake)) {}

/// Whether both ask for the same view.
bool RebuildEngine::same(const Request& a, const Request& b) {
  return (a.object == b.object || same_view(*a.object, *b.object)) &&
         same_neighbours(*a.object, a.neighbours, *b.object, b.neighbours) &&
         same_map(a.surroundings, b.surroundings);
}

/// Object with the view's map; the same pointer as long as neither changes.
std::shared_ptr<const Object> RebuildEngine::with_map(Track& track,
                                                      const std::shared_ptr<const Object>& object,
                                                      const ViewMap& map) {
  if (!follows_view(map, *object)) return object;
  const DisplaySettings display = shown_display(map, *object);
  if (track.given == object && track.looked_at && track.looked_at->display == display) return track.looked_at;
  auto shown = std::make_shared<Object>(*object);
  shown->display = display;
  track.given = object;
  track.looked_at = std::move(shown);
  return track.looked_at;
}

void RebuildEngine::sync(const Document& document, bool in_gesture, double now, RecomputePolicy policy,
                         const ViewMap& map) {
  now_ = now;
  const bool paused =
      policy == RecomputePolicy::manual || (policy == RecomputePolicy::on_release && in_gesture);
  for (const auto& given : document.objects) {
    if (!given->visible || !is_drawn(*given)) continue;
    Track& track = tracks_[given->id];
    Request wanted{with_map(track, given, map), neighbours_of(document, given->id), {}};
    wanted.surroundings =
        surroundings_of(document, *wanted.object, [this](ObjectId id) { return shown_surface(id); });
    const bool first = !track.requested.object, changed = first || !same(track.requested, wanted);
    if (changed && paused && !first && !track.forced) {
      track.outdated = true;
    } else if (changed || track.forced) {
      // The first surface of an object is final even within a gesture.
      request(track, std::move(wanted), in_gesture && !first ? Quality::drag : Quality::final, now);
    } else {
      track.requested = std::move(wanted);
      if (track.quality == Quality::drag) finish_drag(track, in_gesture, now);
    }
    if (in_gesture && track.quality == Quality::drag) look_ahead(track, now);
  }
  for (auto it = tracks_.begin(); it != tracks_.end();) {
    if (document.find(it->first)) {
      ++it;
      continue;
    }
    lane_.cancel(surface_key(it->first));
    lane_.cancel(measure_key(it->first));
    drop_ahead(it->first, it->second);
    views_.erase(it->first);
    it = tracks_.erase(it);
  }
}

void RebuildEngine::cancel_all() {
  for (auto& [id, track] : tracks_) {
    drop_ahead(id, track);
    if (!track.pending) continue;
    lane_.cancel(surface_key(id));
    track.pending = false;
    track.outdated = true;
    track.quality = Quality::final;  // prevents an automatic final surface
  }
}

void RebuildEngine::recompute_outdated() {
  for (auto& [id, track] : tracks_) track.forced = track.forced || track.outdated;
}

std::set<ObjectId> RebuildEngine::outdated() const {
  std::set<ObjectId> out;
  for (const auto& [id, track] : tracks_)
    if (track.outdated && !track.forced) out.insert(id);
  return out;
}

void RebuildEngine::reset() {
  for (auto& [id, track] : tracks_) {
    lane_.cancel(surface_key(id));
    lane_.cancel(measure_key(id));
    drop_ahead(id, track);
  }
  tracks_.clear();
  views_.clear();
}

bool RebuildEngine::shows_provisional(ObjectId id) const {
  const auto view = views_.find(id);
  return view != views_.end() && view->second.provisional;
}

const Surface* RebuildEngine::shown_surface(ObjectId id) const {
  const auto view = views_.find(id);
  return view != views_.end() && view->second.mesh ? &view->second.surface : nullptr;
}

/// Requests the final surface of an object that is not dragged any more, or rests, unless the second worker
/// makes it.
void RebuildEngine::finish_drag(Track& track, bool in_gesture, double now) {
  const ObjectId id = track.requested.object->id;
  if (!in_gesture) {
    if (!track.ahead || !same(*track.ahead, track.requested))
      return request(track, track.requested, Quality::final, now);
    lane_.cancel(surface_key(id));
    if (!track.pending) track.stale_since = now;
    track.pending = true;
    return;
  }
  const bool comes_ahead =
      shows_provisional(id) && !(track.made_ahead && same(*track.made_ahead, track.requested));
  if (now - track.requested_at > rest_seconds && !track.ahead && !comes_ahead)
    request(track, track.requested, Quality::final, now);
}

/// Begins the next final surface beside a gesture whose surfaces are provisional. While the pointer moves,
/// the second worker rests as long as it worked, so that two cores are enough for gesture and display.
void RebuildEngine::look_ahead(Track& track, double now) {
  constexpr double still_seconds = 0.05;
  const ObjectId id = track.requested.object->id;
  const bool moves = now - track.requested_at < still_seconds;
  if (track.ahead || !shows_provisional(id) || (moves && now < track.ahead_again_at)) return;
  if (track.made_ahead && same(*track.made_ahead, track.requested)) return;
  track.ahead = track.requested;
  ahead_lane_.submit(
      surface_key(id),
      [this, id, wanted = track.requested, builder = std::shared_ptr<ViewBuilder>(make_builder_())](
          const CancelToken& cancel) -> WorkLane::Publication {
        auto view = std::make_shared<SurfaceView>(
            builder->build(wanted.object, wanted.neighbours, wanted.surroundings, Quality::final, cancel));
        if (cancel.cancelled()) return {};
        return [this, id, builder, view] { take_ahead(id, builder, std::move(*view)); };
      },
      WorkLane::Running::cancel);
}

void RebuildEngine::drop_ahead(ObjectId id, Track& track) {
  if (track.ahead) ahead_lane_.cancel(surface_key(id));
  track.ahead.reset();
  track.made_ahead.reset();
}

/// Takes over a final surface made beside a gesture: its builder makes the gesture's next surfaces, and it is
/// shown where nothing has moved since.
void RebuildEngine::take_ahead(ObjectId id, std::shared_ptr<ViewBuilder> builder, SurfaceView view) {
  const auto found = tracks_.find(id);
  if (found == tracks_.end() || !found->second.ahead) return;
  Track& track = found->second;
  track.made_ahead = std::exchange(track.ahead, std::nullopt);
  track.ahead_again_at = now_ + view.milliseconds / 1000;
  const bool latest = track.quality == Quality::drag && same(*track.made_ahead, track.requested);
  if (view.error) {
    if (latest && track.pending) request(track, track.requested, Quality::final, now_);
    return;
  }
  track.builder = std::move(builder);
  if (!latest) return;
  lane_.cancel(surface_key(id));
  track.quality = Quality::final;
  take(id, std::move(view));
}

void RebuildEngine::request(Track& track, Request wanted, Quality quality, double now) {
  // Drag jobs are short and their results worth showing; outdated final jobs only delay the next one.
  const auto running =
      track.quality == Quality::final ? WorkLane::Running::cancel : WorkLane::Running::finish;
  const ObjectId id = wanted.object->id;
  if (quality == Quality::final) drop_ahead(id, track);
  if (!track.builder) track.builder = make_builder_();
  if (!track.pending) track.stale_since = now;
  track.requested = wanted;
  track.quality = quality;
  track.requested_at = now;
  track.pending = true;
  track.outdated = track.forced = false;
  lane_.cancel(measure_key(id));
  lane_.submit(
      surface_key(id),
      [this, id, wanted = std::move(wanted), quality,
       builder = track.builder](const CancelToken& cancel) -> WorkLane::Publication {
        auto view = std::make_shared<SurfaceView>(
            builder->build(wanted.object, wanted.neighbours, wanted.surroundings, quality, cancel));
        if (cancel.cancelled()) return {};
        return [this, id, view] { take(id, std::move(*view)); };
      },
      running);
}

void RebuildEngine::take(ObjectId id, SurfaceView view) {
  const auto track = tracks_.find(id);
  if (track == tracks_.end()) return;
  track->second.pending = lane_.busy(surface_key(id));
  SurfaceView& shown = views_[id];
  if (view.error) {
    // The last good surface stays, with the error beside it.
    shown.object = view.object;
    shown.error = view.error;
    shown.warnings = std::move(view.warnings);
    shown.milliseconds = view.milliseconds;
    shown.quality = view.quality;
    shown.largest_normal_jump.reset();
  } else {
    if (view.quality == Quality::drag) {
      // Warnings are found at quality `final` only; a map's range stays fixed during a gesture, so that
      // colours remain comparable.
      view.warnings = std::move(shown.warnings);
      if (keeps_range(shown, view)) {
        view.range = shown.range;
        view.histogram = std::move(shown.histogram);
      }
      if (shown.mesh && shown.surface.patch_count() > 0 && view.surface.same_adjacency(shown.surface))
        view.continuity = std::move(shown.continuity);
    }
    shown = std::move(view);
  }
  if (on_published_) on_published_(id, shown);
  if (shown.quality == Quality::final && !shown.error && !track->second.pending) measure(id);
}

void RebuildEngine::measure(ObjectId id) {
  lane_.submit(
      measure_key(id),
      [this, id, surface = views_[id].surface,
       builder = tracks_[id].builder](const CancelToken& cancel) -> WorkLane::Publication {
        auto report = std::make_shared<const ContinuityReport>(builder->measure(surface, cancel));
        if (cancel.cancelled()) return {};
        return [this, id, report] {
          const auto view = views_.find(id);
          if (view == views_.end()) return;
          view->second.largest_normal_jump = report->largest_normal_jump.value_or(0);
          view->second.continuity = report;
        };
      },
      WorkLane::Running::cancel);
}

bool RebuildEngine::pending(ObjectId id) const {
  const auto track = tracks_.find(id);
  return track != tracks_.end() && track->second.pending;
}

double RebuildEngine::pending_since(ObjectId id) const {
  const auto track = tracks_.find(id);
  return track == tracks_.end() ? 0 : track->second.stale_since;
}

double RebuildEngine::progress(ObjectId id) const {
  const auto track = tracks_.find(id);
  return track != tracks_.end() && track->second.pending ? track->second.builder->progress() : -1;
}

bool RebuildEngine::any_pending() const {
  for (const auto& [id, track] : tracks_)
    if (track.pending) return true;
  return false;
}

}  // namespace hariko
