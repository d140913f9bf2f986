// Sections are taken from a skin's surface by a worker: the window never waits, and no drag loses one.

#include "app/jobs/skin_jobs.hpp"

#include <gtest/gtest.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/engines/surface_builder.hpp"
#include "core/document/edits/edit_skin.hpp"
#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/edit/add_section.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/skin_messages.hpp"
#include "ui/base/job.hpp"

namespace hariko {
namespace {

struct JobsRig {
  Editor editor;
  BackgroundWork files{editor, {}}, edits{editor, {}};
  int added = 0;
  SkinJobs jobs{editor, edits,
                [this](const char* what, const auto&) { added += std::string(what) == "section_added"; }};

  JobsRig() {
    editor.open(add_object({}, "Arch", Source(SkinSource{arched_skin(6, 4, 1, 7), {}}), {}).value().document,
                {});
    editor.selection.active = object().id;
  }
  const Object& object() const { return *editor.history.current().objects[0]; }
  const Skin& skin() const { return *object().skin()->skin; }
  /// Until no section is being made.
  void finish() {
    do {
      edits.wait();
      edits.publish();
      jobs.settle();
    } while (!edits.idle());
  }
};

TEST(SkinJobs, ASectionIsOneStepWhenItIsThere) {
  JobsRig rig;
  const Skin before = rig.skin();
  rig.jobs.add_section(rig.object().id, 0.5);
  EXPECT_EQ(rig.skin(), before) << "the worker makes it";
  ASSERT_EQ(rig.editor.jobs.size(), 1U);
  EXPECT_TRUE(rig.editor.jobs[0]->can_be_cancelled);
  EXPECT_EQ(rig.editor.jobs[0]->text, "Adding a section to Arch");
  rig.finish();
  EXPECT_TRUE(rig.editor.jobs.empty());
  EXPECT_EQ(rig.added, 1);
  EXPECT_EQ(rig.skin(), add_section(before, 0.5)->skin);
  EXPECT_EQ(rig.editor.history.undo_label(), "Add section");
  EXPECT_EQ(rig.editor.history.position(), 1U);
  // The new points are chosen.
  const auto& chosen = rig.editor.selection.of(rig.object().id).vertices;
  ASSERT_EQ(chosen.size(), 7U);
  for (const SectionPoint& p : rig.skin().sections[1].points) EXPECT_TRUE(chosen.contains(VertexId{p.id}));
}

TEST(SkinJobs, SectionsAreAddedOneAfterTheOther) {
  JobsRig rig;
  // The third is that of a double click.
  for (const double v : {0.6, 0.2, 0.2, 0.4}) rig.jobs.add_section(rig.object().id, v);
  EXPECT_EQ(rig.editor.jobs.size(), 1U);
  rig.finish();
  EXPECT_EQ(rig.added, 3);
  ASSERT_EQ(rig.skin().section_count(), 5);
  for (int k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(rig.skin().sections[std::size_t(k) + 1].v, 0.2 * (k + 1));
  EXPECT_EQ(rig.editor.history.position(), 3U);
  EXPECT_TRUE(rig.editor.notices().empty());
}

TEST(SkinJobs, NothingLandsInADocumentThatWasOpenedMeanwhile) {
  JobsRig rig;
  const Skin before = rig.skin();
  for (const double v : {0.6, 0.2}) rig.jobs.add_section(rig.object().id, v);
  const Document same = rig.editor.history.current();
  rig.editor.open(same, {});
  rig.finish();
  EXPECT_EQ(rig.skin(), before);
  EXPECT_EQ(rig.added, 0);
  EXPECT_TRUE(rig.editor.notices().empty());
  rig.jobs.add_section(rig.object().id, 0.5);
  rig.finish();
  EXPECT_EQ(rig.added, 1);
}

TEST(SkinJobs, ASectionWaitsForTheEndOfADrag) {
  JobsRig rig;
  const Skin before = rig.skin();
  rig.jobs.add_section(rig.object().id, 0.5);
  Skin dragged = before;
  dragged.sections[0].points[3].position.z() += 0.25;
  rig.editor.preview(set_skin(rig.editor.history.current(), rig.object().id, dragged));
  rig.finish();
  EXPECT_TRUE(rig.editor.history.in_gesture()) << "the drag was ended";
  EXPECT_EQ(rig.skin(), before);
  rig.editor.cancel_preview();
  rig.finish();
  EXPECT_EQ(rig.skin().section_count(), 3);
}

TEST(SkinJobs, ACancelledSectionLeavesEverythingAsItIs) {
  JobsRig rig;
  const Skin before = rig.skin();
  for (const double v : {0.5, 0.7}) rig.jobs.add_section(rig.object().id, v);
  ASSERT_NE(rig.editor.cancellable_job(), nullptr);
  rig.editor.cancellable_job()->cancel.cancel();
  rig.finish();
  EXPECT_EQ(rig.skin(), before);
  EXPECT_EQ(rig.editor.history.position(), 0U);
  EXPECT_TRUE(rig.editor.notices().empty()) << rig.editor.notices().front().text;
}

TEST(SkinJobs, ASkinThatWasChangedMeanwhileStays) {
  JobsRig rig;
  rig.jobs.add_section(rig.object().id, 0.5);
  Skin changed = rig.skin();
  changed.sections[0].points[3].position.z() += 0.25;
  ASSERT_TRUE(rig.editor.commit(set_skin(rig.editor.history.current(), rig.object().id, changed), "Move"));
  rig.finish();
  EXPECT_EQ(rig.skin(), changed);
  ASSERT_EQ(rig.editor.notices().size(), 1U);
  EXPECT_EQ(rig.editor.notices()[0].kind, Notice::Kind::warning);
  // A job of an object that is gone ends without a word.
  rig.editor.notices().clear();
  rig.jobs.add_section(rig.object().id, 0.5);
  rig.editor.open({}, {});
  rig.finish();
  EXPECT_TRUE(rig.editor.history.current().objects.empty());
  EXPECT_TRUE(rig.editor.notices().empty());
  EXPECT_EQ(rig.added, 0);
}

TEST(SkinJobs, WhatIsRefusedIsSaid) {
  JobsRig rig;
  rig.jobs.add_section(rig.object().id, 0);
  rig.finish();
  ASSERT_EQ(rig.editor.notices().size(), 1U);
  EXPECT_EQ(rig.editor.notices()[0].kind, Notice::Kind::error);
  EXPECT_EQ(rig.skin().section_count(), 2);
}

TEST(SkinJobs, ASectionDoesNotWaitForFiles) {
  JobsRig rig;
  std::mutex mutex;
  std::condition_variable changed;
  bool free = false;
  rig.files.run(
      "Exporting",
      [&](const CancelToken&) {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return free; });
        return true;
      },
      [](bool) {});
  rig.jobs.add_section(rig.object().id, 0.5);
  rig.finish();
  EXPECT_EQ(rig.skin().section_count(), 3);
  {
    const std::lock_guard lock(mutex);
    free = true;
  }
  changed.notify_all();
  rig.files.wait();
  rig.files.publish();
}

/// A surface whose columns are being placed until it is cancelled.
class PlacingBuilder : public ViewBuilder {
 public:
  SurfaceView build(const std::shared_ptr<const Object>& object, const ObjectPointers&,
                    const MapSurroundings&, Quality, const CancelToken& cancel) override {
    while (!cancel.cancelled()) std::this_thread::yield();
    SurfaceView view;
    view.object = object;
    return view;
  }
  ContinuityReport measure(const Surface&, const CancelToken&) override { return {}; }
  double progress() const override { return 0.4; }
};

TEST(SkinJobs, PlacingColumnsIsAJobThatCanBeCancelled) {
  JobsRig rig;
  RebuildEngine engine([] { return std::make_unique<PlacingBuilder>(); }, [] {});
  const ObjectId id = rig.object().id;
  engine.sync(rig.editor.history.current(), false, 0);
  rig.editor.stale_since[id] = 0;
  rig.editor.now = 0.1;
  rig.jobs.follow(engine);
  EXPECT_TRUE(rig.editor.jobs.empty()) << "what is short is not worth a word";
  rig.editor.now = 1;
  rig.jobs.follow(engine);
  ASSERT_EQ(rig.editor.jobs.size(), 1U);
  EXPECT_EQ(rig.editor.jobs[0]->kind, Job::Kind::placing_columns);
  EXPECT_EQ(percent_of(*rig.editor.jobs[0]), 40);
  ASSERT_NE(rig.editor.cancellable_job(), nullptr);
  rig.editor.cancellable_job()->cancel.cancel();
  rig.jobs.follow(engine);
  EXPECT_TRUE(rig.editor.jobs.empty());
  EXPECT_TRUE(engine.outdated().contains(id));
  engine.wait();
}

TEST(SkinErrors, ThePreviousSurfaceStays) {
  const JobsRig rig;
  RebuildEngine engine([] { return std::make_unique<SurfaceBuilder>(); }, [] {});
  const auto rebuilt = [&](const Document& document, double now) {
    engine.sync(document, false, now);
    for (int i = 0; i < 3; ++i) {
      engine.wait();
      engine.publish();
    }
    return engine.views().at(rig.object().id);
  };
  const Document& document = rig.editor.history.current();
  const SurfaceView good = rebuilt(document, 0);
  ASSERT_FALSE(good.error.has_value());
  ASSERT_GT(good.surface.patch_count(), 0U);
  // A file may have sections that do not reach the ends of the path.
  Skin broken = rig.skin();
  broken.sections[0].v = 0.2;
  const SurfaceView kept = rebuilt(set_skin(document, rig.object().id, broken).value(), 1);
  ASSERT_TRUE(kept.error.has_value());
  EXPECT_EQ(kept.error->code, e_section_range);
  EXPECT_EQ(kept.error->element, element_of(VertexId{broken.sections[0].points[0].id}));
  EXPECT_EQ(kept.mesh, good.mesh) << "the previous surface is gone";
  const SurfaceView mended = rebuilt(set_skin(document, rig.object().id, trim_path(broken)->skin).value(), 2);
  EXPECT_FALSE(mended.error.has_value());
}

TEST(AddSection, IsCancelled) {
  SkinWork work;
  work.cancel = CancelToken::make();
  work.progress = Progress::make();
  const Skin skin = arched_skin(6, 4, 1, 7);
  EXPECT_TRUE(add_section(skin, 0.5, work).ok());
  EXPECT_GT(work.progress.fraction(), 0.5);
  work.cancel.cancel();
  EXPECT_EQ(add_section(skin, 0.5, work).error().code, e_cancelled);
}

}  // namespace
}  // namespace hariko
