#pragma once

// RebuildEngine: computes the surfaces of the document's visible objects, off the main thread.

#include <functional>
#include <map>
#include <memory>
#include <set>

#include "app/engines/map_surroundings.hpp"
#include "app/engines/work_lane.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "ui/base/recompute.hpp"
#include "ui/editor/surface_view.hpp"
#include "ui/editor/view_map.hpp"

namespace hariko {

/// Computes views of one object; one instance for each object, called by one thread at a time, which may
/// cache intermediate results.
class ViewBuilder {
 public:
  virtual ~ViewBuilder() = default;
  /// View of an object that has a surface or facets. `neighbours`: objects that it is attached to
  /// (`neighbours_of`). `surroundings`: what its map depends on besides. A view without mesh has an `error`
  /// with the reason.
  virtual SurfaceView build(const std::shared_ptr<const Object>& object, const ObjectPointers& neighbours,
                            const MapSurroundings& surroundings, Quality quality,
                            const CancelToken& cancel) = 0;
  /// Continuity between the patches of a surface; without seams where cancelled.
  virtual ContinuityReport measure(const Surface& surface, const CancelToken& cancel) = 0;
  /// Progress of the slow part, 0 .. 1; negative where unknown. From any thread.
  virtual double progress() const { return -1; }
};

/// Keeps the surfaces up to date. All calls from the main thread; the builders run on two workers.
///
/// While a gesture's surfaces are provisional, final ones are computed beside it by a second builder, of
/// whatever was dragged last when the one before was finished. The builder of the latest final surface makes
/// the next surfaces of the gesture, which therefore differ from final ones only by what the move since then
/// changes.
class RebuildEngine {
 public:
  using MakeBuilder = std::function<std::unique_ptr<ViewBuilder>()>;
  using OnPublished = std::function<void(ObjectId, const SurfaceView&)>;

  RebuildEngine(MakeBuilder make_builder, std::function<void()> wake, OnPublished on_published = {});

  /// Requests surfaces of objects that changed since the last call. During a gesture objects are rebuilt at
  /// quality `drag`; `final` follows when the gesture ends or rests for `rest_seconds`, sooner where surfaces
  /// are provisional. `now` is any steady clock in seconds. The policy may postpone changes, but never the
  /// first surface of an object. The view's map is computed as if it were each object's own;
  /// `SurfaceView::object` then has it.
  void sync(const Document& document, bool in_gesture, double now,
            RecomputePolicy policy = RecomputePolicy::live, const ViewMap& map = {});
  static constexpr double rest_seconds = 0.4;

  /// Stops all running rebuilds. The last surfaces stay and count as outdated until the object changes or
  /// `recompute_outdated` is called.
  void cancel_all();
  /// Requests rebuilding of all outdated surfaces at the next sync.
  void recompute_outdated();

  /// Forgets all objects: another document is opened, whose objects may have the same ids.
  void reset();

  /// Takes over finished views, at the start of a frame; returns their number.
  std::size_t publish() { return lane_.publish() + ahead_lane_.publish(); }

  const std::map<ObjectId, SurfaceView>& views() const { return views_; }
  /// Whether the displayed view is older than the document.
  bool pending(ObjectId id) const;
  /// Time since when the displayed view is outdated, by the clock of `sync`.
  double pending_since(ObjectId id) const;
  bool any_pending() const;
  bool idle() const { return !any_pending(); }
  /// Progress of rebuilding an object, see `ViewBuilder::progress`; negative where it is not pending.
  double progress(ObjectId id) const;
  /// Objects whose surface is older than the document and not being rebuilt.
  std::set<ObjectId> outdated() const;

  /// Waits for both workers, for tests and for shutting down.
  void wait() { lane_.wait(), ahead_lane_.wait(); }

 private:
  /// Input of a view.
  struct Request {
    std::shared_ptr<const Object> object;
    ObjectPointers neighbours;
    MapSurroundings surroundings;
  };
  static bool same(const Request& a, const Request& b);
  struct Track {
    std::shared_ptr<ViewBuilder> builder;
    Request requested;  ///< latest request; without object before the first
    /// Object of the document, and the same with the view's map.
    std::shared_ptr<const Object> given, looked_at;
    Quality quality = Quality::final;
    double requested_at = 0, stale_since = 0;
    bool pending = false, outdated = false, forced = false;
    /// Input of the final surface being made beside a gesture, and of the last one made.
    std::optional<Request> ahead, made_ahead;
    double ahead_again_at = 0;  ///< time until when the second worker rests while the pointer moves
  };
  static std::shared_ptr<const Object> with_map(Track& track, const std::shared_ptr<const Object>& object,
                                                const ViewMap& map);
  void request(Track& track, Request wanted, Quality quality, double now);
  void finish_drag(Track& track, bool in_gesture, double now);
  void look_ahead(Track& track, double now);
  void drop_ahead(ObjectId id, Track& track);
  bool shows_provisional(ObjectId id) const;
  const Surface* shown_surface(ObjectId id) const;
  void take(ObjectId id, SurfaceView view);
  void take_ahead(ObjectId id, std::shared_ptr<ViewBuilder> builder, SurfaceView view);
  void measure(ObjectId id);

  MakeBuilder make_builder_;
  OnPublished on_published_;
  std::map<ObjectId, Track> tracks_;
  std::map<ObjectId, SurfaceView> views_;
  double now_ = 0;  ///< time of the last sync
  // Last: their threads stop before the members that their publications use are destroyed.
  WorkLane lane_, ahead_lane_;
};

}  // namespace hariko
