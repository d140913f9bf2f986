#pragma once

// RebuildEngine: keeps a surface for every visible polyhedron of the document, off the main thread.

#include <functional>
#include <map>
#include <memory>
#include <set>

#include "app/engines/work_lane.hpp"
#include "core/modeling/attached.hpp"
#include "ui/base/recompute.hpp"
#include "ui/editor/surface_view.hpp"
#include "ui/editor/view_map.hpp"

namespace hariko {

/// Makes views of one object. One instance per object, called by one thread at a time: may keep what helps
/// next time.
class ViewBuilder {
 public:
  virtual ~ViewBuilder() = default;
  /// A view of an object that has a surface or facets. `neighbours`: what it is attached to
  /// (`neighbours_of`). A view without mesh and with `error` says why there is none.
  virtual SurfaceView build(const std::shared_ptr<const Object>& object, const ObjectPointers& neighbours,
                            Quality quality, const CancelToken& cancel) = 0;
  /// How well the patches of a surface meet; without seams when cancelled.
  virtual ContinuityReport measure(const Surface& surface, const CancelToken& cancel) = 0;
  /// How far the part is that takes long, 0 .. 1; negative where nothing is known. For any thread.
  virtual double progress() const { return -1; }
};

/// Everything here runs on the main thread; the builders run on the worker.
class RebuildEngine {
 public:
  using MakeBuilder = std::function<std::unique_ptr<ViewBuilder>()>;
  using OnPublished = std::function<void(ObjectId, const SurfaceView&)>;

  RebuildEngine(MakeBuilder make_builder, std::function<void()> wake, OnPublished on_published = {});

  /// Asks for what changed since the last call. In a gesture objects are rebuilt at quality `drag`; `final`
  /// follows when the gesture ends or rests for `rest_seconds`. `now` is any steady clock in seconds.
  /// The policy may let changes wait; the first surface of an object never does. The view's map is computed
  /// as if it were each object's own: `SurfaceView::object` has it then.
  void sync(const Document& document, bool in_gesture, double now,
            RecomputePolicy policy = RecomputePolicy::live, const ViewMap& map = {});
  static constexpr double rest_seconds = 0.4;

  /// Stops rebuilding what is on its way; the last surfaces stay, and count as outdated until the object
  /// changes or `recompute_outdated`.
  void cancel_all();
  /// What is outdated is rebuilt at the next sync.
  void recompute_outdated();

  /// Forgets everything: another document is opened, whose objects may have the same ids.
  void reset();

  /// Takes over finished views. Call at the start of a frame. Returns how many there were.
  std::size_t publish() { return lane_.publish(); }

  const std::map<ObjectId, SurfaceView>& views() const { return views_; }
  /// Whether the view shown is older than the document, and since when.
  bool pending(ObjectId id) const;
  double pending_since(ObjectId id) const;
  bool any_pending() const;
  /// Of the rebuilding of an object: see `ViewBuilder::progress`; negative when it is not pending.
  double progress(ObjectId id) const;
  /// Objects whose surface is older than the document and not being rebuilt.
  std::set<ObjectId> outdated() const;

  /// Waits for the worker; for tests and for shutting down.
  void wait() { lane_.wait(); }

 private:
  struct Track {
    std::shared_ptr<ViewBuilder> builder;
    std::shared_ptr<const Object> requested;
    std::shared_ptr<const Object> given, looked_at;  ///< of the document, and with the view's map
    ObjectPointers neighbours;
    Quality quality = Quality::final;
    double requested_at = 0, stale_since = 0;
    bool pending = false, outdated = false, forced = false;
  };
  static std::shared_ptr<const Object> with_map(Track& track, const std::shared_ptr<const Object>& object,
                                                const ViewMap& map);
  void request(Track& track, const std::shared_ptr<const Object>& object, ObjectPointers neighbours,
               Quality quality, double now);
  void take(ObjectId id, SurfaceView view);
  void measure(ObjectId id);

  MakeBuilder make_builder_;
  OnPublished on_published_;
  std::map<ObjectId, Track> tracks_;
  std::map<ObjectId, SurfaceView> views_;
  WorkLane lane_;  ///< last: its thread stops before what its publications touch goes
};

}  // namespace hariko
