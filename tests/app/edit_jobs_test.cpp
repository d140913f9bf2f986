// Edits that take long are made by a worker: the window never waits, and no drag loses one.

#include "app/jobs/edit_jobs.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

using SharedObject = std::shared_ptr<const Object>;

/// Gives an object the scale of twice a number, which is doubled by the work.
OperationStep doubled_scale(const SharedObject& object, double factor) {
  const auto known = std::make_shared<std::map<double, double>>();
  OperationStep step;
  step.label = "Scale";
  step.numbers = {{"factor", "Factor", factor, 0.5, 100}};
  step.prepare = [known, object](const Document& document,
                                 std::span<const OperationNumber> numbers) -> std::optional<LongEdit> {
    const double wanted = numbers[0].value;
    const Object* now = document.find(object->id);
    if (known->contains(wanted) && now && now->transform == object->transform) return std::nullopt;
    return LongEdit{"Doubling", object->id, [known, wanted](const CancelToken&, const Progress&) {
                      return LongEdit::Then([known, wanted] { (*known)[wanted] = 2 * wanted; });
                    }};
  };
  step.make = [known, object](const Document& document,
                              std::span<const OperationNumber> numbers) -> Result<OperationResult> {
    Similarity placed = object->transform;
    placed.scale = known->at(numbers[0].value);
    auto done = set_transform(document, object->id, placed);
    if (!done) return done.error();
    OperationResult out{std::move(done).value(), object->id};
    out.keeps_selection = true;
    return out;
  };
  return step;
}

struct EditRig {
  Editor editor;
  BackgroundWork edits{editor, {}};
  EditJobs jobs{editor, edits};

  EditRig() {
    editor.on_long_edit = [this](const LongEdit& edit) { jobs.make(edit); };
    const auto cube = [] { return as_new(PolyhedronSource::from_mesh(test::cube()).value()); };
    editor.open(add_object(add_object({}, "A", cube())->document, "B", cube())->document, {});
  }
  SharedObject object(std::size_t index = 0) const { return editor.history.current().objects[index]; }
  double scale(std::size_t index = 0) const { return object(index)->transform.scale; }
  bool run(double factor, std::size_t index = 0) {
    return editor.last_operation.run(editor, doubled_scale(object(index), factor));
  }
  Result<Document> moved(std::size_t index = 0) const {
    Similarity placed = object(index)->transform;
    placed.translation.x() += 1;
    return set_transform(editor.history.current(), object(index)->id, placed);
  }
  /// Until no edit is being made.
  void finish() {
    do {
      edits.wait();
      edits.publish();
      jobs.settle();
    } while (!edits.idle());
  }
};

TEST(EditJobs, AnEditIsOneStepWhenItIsThereAndCanBeAdjusted) {
  EditRig rig;
  EXPECT_TRUE(rig.run(3));
  EXPECT_EQ(rig.scale(), 1) << "the worker makes it";
  ASSERT_EQ(rig.editor.jobs.size(), 1U);
  EXPECT_TRUE(rig.editor.jobs[0]->can_be_cancelled);
  EXPECT_EQ(rig.editor.jobs[0]->text, "Doubling");
  rig.finish();
  EXPECT_TRUE(rig.editor.jobs.empty());
  EXPECT_EQ(rig.scale(), 6);
  EXPECT_EQ(rig.editor.history.position(), 1U);
  EXPECT_EQ(rig.editor.history.undo_label(), "Scale");

  LastOperation& last = rig.editor.last_operation;
  ASSERT_TRUE(last.can_adjust(rig.editor));
  EXPECT_TRUE(last.adjust(rig.editor, 0, 5));
  EXPECT_EQ(rig.scale(), 6) << "until the worker is ready";
  rig.finish();
  EXPECT_EQ(rig.scale(), 10);
  EXPECT_EQ(last.numbers()[0].value, 5);
  EXPECT_EQ(rig.editor.history.position(), 1U) << "in the place of the first";
  // Values made before need no worker.
  EXPECT_TRUE(last.adjust(rig.editor, 0, 3));
  EXPECT_EQ(rig.scale(), 6);
  rig.editor.undo();
  EXPECT_EQ(rig.scale(), 1);
  EXPECT_TRUE(rig.editor.notices().empty());
}

TEST(EditJobs, WithoutAWorkerTheEditIsMadeAtOnce) {
  EditRig rig;
  rig.editor.on_long_edit = {};
  EXPECT_TRUE(rig.run(3));
  EXPECT_EQ(rig.scale(), 6);
  EXPECT_TRUE(rig.editor.last_operation.adjust(rig.editor, 0, 4));
  EXPECT_EQ(rig.scale(), 8);
  EXPECT_EQ(rig.editor.history.position(), 1U);
  // A refusal is told to who asked.
  ASSERT_TRUE(rig.editor.commit(set_locked(rig.editor.history.current(), rig.object()->id, true), "Lock"));
  EXPECT_FALSE(rig.run(2));
  EXPECT_EQ(rig.scale(), 8);
}

TEST(EditJobs, AnObjectThatWasChangedMeanwhileStays) {
  EditRig rig;
  rig.run(3);
  ASSERT_TRUE(rig.editor.commit(rig.moved(), "Move"));
  rig.finish();
  EXPECT_EQ(rig.scale(), 1);
  ASSERT_EQ(rig.editor.notices().size(), 1U);
  EXPECT_EQ(rig.editor.notices()[0].kind, Notice::Kind::warning);
  EXPECT_NE(rig.editor.notices()[0].text.find("Scale"), std::string::npos) << rig.editor.notices()[0].text;
  // Changes of others do not matter.
  rig.editor.notices().clear();
  rig.run(3);
  ASSERT_TRUE(rig.editor.commit(rig.moved(1), "Move"));
  rig.finish();
  EXPECT_EQ(rig.scale(), 6);
  EXPECT_TRUE(rig.editor.notices().empty());
  // An edit of an object that is gone ends without a word.
  rig.run(2);
  rig.editor.open({}, {});
  rig.finish();
  EXPECT_TRUE(rig.editor.history.current().objects.empty());
  EXPECT_TRUE(rig.editor.notices().empty());
}

TEST(EditJobs, NumbersOfAStepThatIsNotTheLastAnyMoreAreNotAdjusted) {
  EditRig rig;
  rig.run(3);
  rig.finish();
  EXPECT_TRUE(rig.editor.last_operation.adjust(rig.editor, 0, 5));
  ASSERT_TRUE(rig.editor.commit(rig.moved(1), "Move"));
  rig.finish();
  EXPECT_EQ(rig.scale(), 6);
  EXPECT_EQ(rig.editor.history.position(), 2U);
  ASSERT_EQ(rig.editor.notices().size(), 1U);
  EXPECT_EQ(rig.editor.notices()[0].kind, Notice::Kind::warning);
}

TEST(EditJobs, ACancelledEditLeavesEverythingAsItIs) {
  EditRig rig;
  rig.run(3);
  ASSERT_NE(rig.editor.cancellable_job(), nullptr);
  rig.editor.cancellable_job()->cancel.cancel();
  rig.finish();
  EXPECT_EQ(rig.scale(), 1);
  EXPECT_EQ(rig.editor.history.position(), 0U);
  EXPECT_TRUE(rig.editor.notices().empty());
}

TEST(EditJobs, AnEditWaitsForTheEndOfADrag) {
  EditRig rig;
  rig.run(3);
  rig.editor.preview(rig.moved());
  rig.finish();
  EXPECT_TRUE(rig.editor.history.in_gesture()) << "the drag was ended";
  EXPECT_EQ(rig.scale(), 1);
  rig.editor.cancel_preview();
  rig.finish();
  EXPECT_EQ(rig.scale(), 6);
}

TEST(EditJobs, OfOneObjectTheLastEditCounts) {
  EditRig rig;
  rig.run(3);
  rig.run(7, 1);
  rig.run(4);
  rig.finish();
  EXPECT_EQ(rig.scale(), 8);
  EXPECT_EQ(rig.scale(1), 14);
  EXPECT_EQ(rig.editor.history.position(), 2U);
  EXPECT_TRUE(rig.editor.notices().empty());
}

}  // namespace
}  // namespace hariko
