#include "app/engines/rebuild_engine.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "app/engines/surface_builder.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

using namespace std::chrono_literals;

/// Orders to fake builders and counts of what they saw; shared with the worker, hence atomics.
struct Script {
  std::atomic<int> builds = 0, drag_builds = 0, running = 0, most_running = 0;
  std::atomic<bool> fail = false, hold = false, started = false, provisional = false;
  std::atomic<int> builders = 0, last_builder = 0;  ///< number of builders made; the one that dragged last
};

class FakeBuilder final : public ViewBuilder {
 public:
  explicit FakeBuilder(std::shared_ptr<Script> script)
      : script_(std::move(script)), number_(++script_->builders) {}
  SurfaceView build(const std::shared_ptr<const Object>& object, const ObjectPointers&,
                    const MapSurroundings&, Quality quality, const CancelToken& cancel) override {
    Script& script = *script_;
    script.most_running = std::max<int>(script.most_running, ++script.running);
    ++script.builds;
    if (quality == Quality::drag) ++script.drag_builds, script.last_builder = number_;
    script.started = true;
    while (script.hold && !cancel.cancelled()) std::this_thread::sleep_for(1ms);
    --script.running;
    SurfaceView view;
    view.object = object;
    view.quality = quality;
    view.provisional = script.provisional && quality == Quality::drag;
    view.milliseconds = object->polyhedron()->polyhedron.position(0).x();  // tells views apart
    if (script.fail) view.error = make_error(Code{"E_FAKE"}, "It failed.");
    return view;
  }
  ContinuityReport measure(const Surface&, const CancelToken&) override {
    ContinuityReport report;
    report.largest_normal_jump = 0.25;
    return report;
  }

 private:
  std::shared_ptr<Script> script_;
  int number_;
};

Document triangle_document() {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_face({0, 1, 2});
  auto document = test::must(document_from_mesh(mesh, "triangle"));
  return document.value();
}

Document moved(const Document& document, double x) {
  const VertexId vertex{0};
  const Vector3 position(x, 0, 0);
  auto result = test::must(move_vertices(document, document.objects[0]->id, {&vertex, 1}, {&position, 1}));
  return result.value();
}

struct EngineRig {
  std::shared_ptr<Script> script = std::make_shared<Script>();
  std::vector<std::pair<double, Quality>> published;
  RebuildEngine engine{
      [this] { return std::make_unique<FakeBuilder>(script); },
      {},
      [this](ObjectId, const SurfaceView& view) { published.emplace_back(view.milliseconds, view.quality); }};
  /// First surface of a document, then a frame of a gesture that is provisional.
  void begin_provisional(const Document& document, const Document& dragged) {
    script->provisional = true;
    engine.sync(document, false, 0);
    settle();
    engine.sync(dragged, true, 1);
    settle();
    published.clear();
  }
  /// Syncs a gesture that rests, and holds the surface that is begun beside it.
  void hold_ahead(const Document& dragged) {
    script->hold = true;
    script->started = false;
    engine.sync(dragged, true, 1.1);
    while (!script->started) std::this_thread::sleep_for(1ms);
  }
  void settle() {
    for (int i = 0; i < 3; ++i) {
      engine.wait();
      engine.publish();
    }
  }
};

TEST(RebuildEngine, BuildsOnceAndOnlyWhatChanged) {
  EngineRig rig;
  Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  EXPECT_TRUE(rig.engine.any_pending());
  rig.settle();
  EXPECT_FALSE(rig.engine.any_pending());
  for (int i = 0; i < 5; ++i) rig.engine.sync(document, false, i);
  document = rename_object(document, document.objects[0]->id, "other").value();
  document = set_transform(document, document.objects[0]->id, Similarity{{1, 0, 0, 0}, 2, {1, 2, 3}}).value();
  rig.engine.sync(document, false, 6);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 1);
  rig.engine.sync(moved(document, -1), false, 7);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 2);
  ASSERT_EQ(rig.engine.views().size(), 1U);
  EXPECT_EQ(rig.engine.views().begin()->second.largest_normal_jump, 0.25);
}

TEST(RebuildEngine, DragsAtDragQualityAndFinishesAtFinal) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  rig.settle();
  rig.published.clear();
  rig.script->hold = true;
  rig.script->started = false;
  rig.engine.sync(moved(document, 1), true, 1.00);
  while (!rig.script->started) std::this_thread::sleep_for(1ms);
  for (int i = 2; i <= 9; ++i) rig.engine.sync(moved(document, i), true, 1.0 + 0.01 * i);
  rig.script->hold = false;
  rig.settle();
  // The first was running and is shown; of those that waited only the latest ran.
  ASSERT_EQ(rig.published.size(), 2U);
  EXPECT_EQ(rig.published[0], std::pair(1.0, Quality::drag));
  EXPECT_EQ(rig.published[1], std::pair(9.0, Quality::drag));
  rig.engine.sync(moved(document, 9), false, 2);
  rig.settle();
  ASSERT_EQ(rig.published.size(), 3U);
  EXPECT_EQ(rig.published[2], std::pair(9.0, Quality::final));
  EXPECT_EQ(rig.script->most_running, 1);
}

TEST(RebuildEngine, RestingGestureIsRefinedAndCancelsForTheNextMove) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  rig.settle();
  const Document dragged = moved(document, 3);
  rig.engine.sync(dragged, true, 1);
  rig.settle();
  rig.engine.sync(dragged, true, 1.1);
  EXPECT_FALSE(rig.engine.any_pending());
  rig.published.clear();
  rig.script->hold = true;
  rig.script->started = false;
  rig.engine.sync(dragged, true, 1 + RebuildEngine::rest_seconds + 0.01);
  EXPECT_TRUE(rig.engine.any_pending());
  while (!rig.script->started) std::this_thread::sleep_for(1ms);
  rig.engine.sync(moved(document, 4), true, 2);  // cancels the held final job: only that lets it end
  for (int i = 0; i < 2000 && rig.script->drag_builds < 2; ++i) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(rig.script->drag_builds, 2);
  rig.script->hold = false;
  rig.settle();
  ASSERT_EQ(rig.published.size(), 1U);
  EXPECT_EQ(rig.published[0], std::pair(4.0, Quality::drag));
}

TEST(RebuildEngine, ProvisionalSurfacesAreFinishedWhileTheGestureRests) {
  EngineRig rig;
  rig.script->provisional = true;
  const Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  rig.settle();
  rig.published.clear();
  const Document dragged = moved(document, 3);
  rig.engine.sync(dragged, true, 1);
  rig.settle();
  rig.engine.sync(dragged, true, 1.1);  // long before `rest_seconds`
  rig.settle();
  ASSERT_EQ(rig.published.size(), 2U);
  EXPECT_EQ(rig.published[0], std::pair(3.0, Quality::drag));
  EXPECT_EQ(rig.published[1], std::pair(3.0, Quality::final));
  for (const double now : {1.2, 2.0, 3.0}) {
    rig.engine.sync(dragged, now < 3, now);
    rig.settle();
  }
  EXPECT_EQ(rig.published.size(), 2U) << "the final surface is made once";
}

TEST(RebuildEngine, SurfacesMadeBesideAGestureCarryItOn) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.begin_provisional(document, moved(document, 1));
  EXPECT_EQ(rig.script->last_builder, 1);
  rig.hold_ahead(moved(document, 1));
  rig.engine.sync(moved(document, 2), true, 1.2);
  rig.script->hold = false;
  rig.settle();
  // The surface made beside is of an earlier place, and never shown.
  ASSERT_EQ(rig.published.size(), 1U);
  EXPECT_EQ(rig.published[0], std::pair(2.0, Quality::drag));
  rig.engine.sync(moved(document, 3), true, 1.2005);
  rig.settle();
  EXPECT_EQ(rig.published.back(), std::pair(3.0, Quality::drag));
  EXPECT_EQ(rig.script->last_builder, 2) << "its builder makes what follows";
}

TEST(RebuildEngine, TheEndOfAGestureWaitsForTheSurfaceInTheMaking) {
  EngineRig rig;
  const Document document = triangle_document(), dragged = moved(document, 3);
  rig.begin_provisional(document, dragged);
  rig.hold_ahead(dragged);
  const int builds = rig.script->builds;
  rig.engine.sync(dragged, false, 1.2);
  EXPECT_TRUE(rig.engine.any_pending());
  rig.script->hold = false;
  rig.settle();
  EXPECT_FALSE(rig.engine.any_pending());
  EXPECT_EQ(rig.script->builds, builds);
  ASSERT_EQ(rig.published.size(), 1U);
  EXPECT_EQ(rig.published[0], std::pair(3.0, Quality::final));
}

TEST(RebuildEngine, AGestureTakenBackDropsTheSurfaceInTheMaking) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.begin_provisional(document, moved(document, 3));
  rig.hold_ahead(moved(document, 3));
  rig.engine.sync(document, false, 1.2);
  rig.script->hold = false;
  rig.settle();
  ASSERT_EQ(rig.published.size(), 1U);
  EXPECT_EQ(rig.published[0],
            std::pair(document.objects[0]->polyhedron()->polyhedron.position(0).x(), Quality::final));
}

/// Largest distance between points of the same parameters, relative to the size.
double apart(const Surface& a, const Surface& b) {
  Eigen::AlignedBox3d box;
  double out = 0;
  constexpr int steps = 6;
  for (Index p = 0; p < a.patch_count(); ++p)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Vector2 at(i / double(steps), j / double(steps));
        const Vector3 point = a.patches().evaluate(p, at, Order::first).position;
        box.extend(point);
        out = std::max(out, (point - b.patches().evaluate(p, at, Order::first).position).norm());
      }
  return out / box.diagonal().norm();
}

/// Distance between the surface of the last drag frame and the final one, relative to the size, after a
/// vertex of a torus was moved by a tenth of the size in `steps` steps; the pointer rests at each for `rest`
/// seconds.
double end_of_drag(Mode mode, int columns, int rows, int steps, double rest) {
  auto made = test::must(document_from_mesh(test::torus(columns, rows), "torus"));
  Document document = made.value();
  const ObjectId id = document.objects[0]->id;
  document = set_mode(set_frames(document, id, Frames::metric).value(), id, mode).value();
  RebuildEngine engine([] { return std::make_unique<SurfaceBuilder>(); }, {});
  const auto settle = [&] {
    do engine.wait();
    while (engine.publish() > 0);
  };
  double now = 0;
  engine.sync(document, false, now);
  settle();
  const VertexId vertex{0};
  const Vector3 from = document.objects[0]->polyhedron()->polyhedron.position(0);
  for (int k = 1; k <= steps; ++k) {
    const Vector3 to = from + 0.6 * double(k) / steps * Vector3(0.8, 0, 0.6);
    document = move_vertices(document, id, {&vertex, 1}, {&to, 1}).value();
    engine.sync(document, true, now += 1);
    settle();
    if (k == steps) break;
    engine.sync(document, true, now += rest);
    settle();
  }
  EXPECT_EQ(engine.views().at(id).quality, Quality::drag);
  const Surface dragged = engine.views().at(id).surface;
  engine.sync(document, false, now += 0.001);
  settle();
  EXPECT_EQ(engine.views().at(id).quality, Quality::final);
  return apart(dragged, engine.views().at(id).surface);
}

TEST(RebuildEngine, DragsEndNearTheFinalSurface) {
  for (const auto& [mode, columns, rows] : {std::tuple(Mode::fair, 24, 12), std::tuple(Mode::g2, 12, 8)}) {
    const double followed = end_of_drag(mode, columns, rows, 20, 0.1);
    const double without = end_of_drag(mode, columns, rows, 1, 0);
    RecordProperty(std::string("of_mode_") + std::to_string(int(mode)), std::to_string(followed));
    EXPECT_LT(followed, 0.002) << "for " << without << " in one step";
    EXPECT_LT(followed, without);
  }
}

TEST(RebuildEngine, FailureKeepsTheLastGoodSurfaceAndSaysWhy) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  rig.settle();
  rig.script->fail = true;
  rig.engine.sync(moved(document, 5), false, 1);
  rig.settle();
  const SurfaceView& view = rig.engine.views().begin()->second;
  ASSERT_TRUE(view.error.has_value());
  EXPECT_EQ(view.error->code.name, "E_FAKE");
  EXPECT_FALSE(rig.engine.any_pending());
  rig.script->fail = false;
  rig.engine.sync(document, false, 2);
  rig.settle();
  EXPECT_FALSE(rig.engine.views().begin()->second.error.has_value());
}

TEST(RebuildEngine, ResetDropsWhatRunsAndWhatIsShown) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  rig.settle();
  rig.published.clear();
  rig.script->hold = true;
  rig.script->started = false;
  rig.engine.sync(moved(document, 1), true, 1);
  while (!rig.script->started) std::this_thread::sleep_for(1ms);
  rig.engine.reset();
  EXPECT_TRUE(rig.engine.views().empty());
  rig.script->hold = false;
  rig.engine.sync(moved(document, 2), false, 2);  // the same id in another document
  rig.settle();
  ASSERT_EQ(rig.published.size(), 1U);
  EXPECT_EQ(rig.published[0], std::pair(2.0, Quality::final));
}

TEST(RebuildEngine, DeletedAndHiddenObjectsArePublishedNoMore) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.script->hold = true;
  rig.engine.sync(document, false, 0);
  while (!rig.script->started) std::this_thread::sleep_for(1ms);
  const ObjectId id = document.objects[0]->id;
  rig.engine.sync(delete_objects(document, {&id, 1}).value(), false, 1);
  rig.settle();
  EXPECT_TRUE(rig.published.empty());
  EXPECT_TRUE(rig.engine.views().empty());
  rig.script->hold = false;
  EngineRig other;
  other.engine.sync(set_visible(document, id, false).value(), false, 0);
  other.settle();
  EXPECT_EQ(other.script->builds, 0);
}

TEST(RebuildEngine, PolicyLetsChangesWait) {
  EngineRig rig;
  Document document = triangle_document();
  rig.engine.sync(document, false, 0, RecomputePolicy::manual);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 1) << "the first surface does not wait";
  document = moved(document, 1);
  rig.engine.sync(document, true, 1, RecomputePolicy::on_release);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 1);
  EXPECT_EQ(rig.engine.outdated().size(), 1U);
  rig.engine.sync(document, false, 2, RecomputePolicy::on_release);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 2);
  EXPECT_TRUE(rig.engine.outdated().empty());
  document = moved(document, 2);
  rig.engine.sync(document, false, 3, RecomputePolicy::manual);
  rig.engine.sync(document, false, 30, RecomputePolicy::manual);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 2);
  EXPECT_FALSE(rig.engine.any_pending());
  rig.engine.recompute_outdated();
  rig.engine.sync(document, false, 31, RecomputePolicy::manual);
  rig.settle();
  EXPECT_EQ(rig.script->builds, 3);
  EXPECT_TRUE(rig.engine.outdated().empty());
}

TEST(RebuildEngine, CancelKeepsTheLastSurfaceUntilAskedAgain) {
  EngineRig rig;
  const Document document = triangle_document();
  rig.engine.sync(document, false, 0);
  rig.settle();
  rig.published.clear();
  rig.script->hold = true;
  rig.script->started = false;
  const Document changed = moved(document, 4);
  rig.engine.sync(changed, false, 1);
  while (!rig.script->started) std::this_thread::sleep_for(1ms);
  rig.engine.cancel_all();
  EXPECT_FALSE(rig.engine.any_pending());
  EXPECT_EQ(rig.engine.outdated().size(), 1U);
  rig.script->hold = false;
  rig.settle();
  rig.engine.sync(changed, false, 2);
  rig.settle();
  EXPECT_TRUE(rig.published.empty()) << "what was cancelled neither shows nor starts again";
  rig.engine.recompute_outdated();
  rig.engine.sync(changed, false, 3);
  rig.settle();
  ASSERT_EQ(rig.published.size(), 1U);
  EXPECT_EQ(rig.published[0].second, Quality::final);
  EXPECT_TRUE(rig.engine.outdated().empty());
}

}  // namespace
}  // namespace hariko
