// Undo and redo, against a plain model, and the memory they need.

#include "core/document/history/history.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include "core/base/sanitizer.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/document/random_documents.hpp"

namespace hariko {
namespace {

using test::cube_document;
using test::cube_id;

Document renamed(const Document& document, const std::string& name) {
  return rename_object(document, cube_id, name).value();
}

TEST(History, UndoAndRedoGiveEqualDocuments) {
  const Document start = cube_document();
  History history(start);
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undo_label(), "");
  ASSERT_TRUE(history.push(renamed(start, "A"), "Rename to A"));
  ASSERT_TRUE(history.push(renamed(start, "B"), "Rename to B"));
  EXPECT_EQ(history.labels(), (std::vector<std::string>{"Rename to A", "Rename to B"}));
  EXPECT_EQ(history.undo_label(), "Rename to B");
  ASSERT_TRUE(history.undo());
  EXPECT_TRUE(history.current() == renamed(start, "A"));
  EXPECT_EQ(history.redo_label(), "Rename to B");
  ASSERT_TRUE(history.undo());
  EXPECT_TRUE(history.current() == start);
  ASSERT_TRUE(history.redo());
  ASSERT_TRUE(history.push(renamed(start, "C"), "Rename to C"));
  EXPECT_FALSE(history.can_redo()) << "a new step forgets what could be redone";
  ASSERT_TRUE(history.go_to(0));
  EXPECT_TRUE(history.current() == start);
  EXPECT_FALSE(history.go_to(3));
  ASSERT_TRUE(history.go_to(2));
  EXPECT_TRUE(history.current() == renamed(start, "C"));
}

TEST(History, LabelsAreFilledInEnglishAndKeptAsPhrases) {
  const Document start = cube_document();
  History history(start);
  ASSERT_TRUE(history.push(renamed(start, "A"), Phrase("Import {0}", {"a.obj"})));
  EXPECT_EQ(history.undo_label(), "Import a.obj");
  ASSERT_EQ(history.phrases().size(), 1U);
  EXPECT_EQ(history.phrases()[0].pattern(), "Import {0}");
  EXPECT_EQ(history.phrases()[0].arguments(), std::vector<std::string>{"a.obj"});
}

TEST(History, EqualDocumentsMakeNoStep) {
  History history(cube_document());
  EXPECT_FALSE(history.push(cube_document(), "Nothing"));
  EXPECT_FALSE(history.can_undo());
  history.push(renamed(history.current(), "A"), "A");
  history.undo();
  EXPECT_FALSE(history.push(cube_document(), "Nothing"));
  EXPECT_TRUE(history.can_redo()) << "nothing happened, so nothing is forgotten";
}

TEST(History, GesturesMakeOneStepOrNone) {
  const Document start = cube_document();
  History history(start);
  EXPECT_FALSE(history.commit_preview("Nothing"));
  for (const char* name : {"A", "B", "C"}) history.preview(renamed(start, name));
  EXPECT_TRUE(history.in_gesture());
  EXPECT_TRUE(history.shown() == renamed(start, "C"));
  EXPECT_TRUE(history.current() == start);
  EXPECT_FALSE(history.dirty());
  ASSERT_TRUE(history.commit_preview("Drag"));
  EXPECT_FALSE(history.in_gesture());
  EXPECT_EQ(history.position(), 1U);
  EXPECT_TRUE(history.current() == renamed(start, "C"));

  history.preview(renamed(start, "D"));
  history.cancel_preview();
  EXPECT_TRUE(history.shown() == renamed(start, "C"));
  EXPECT_EQ(history.position(), 1U);

  history.preview(renamed(start, "D"));
  history.preview(renamed(start, "C"));
  EXPECT_FALSE(history.commit_preview("Back where it was"));
  EXPECT_EQ(history.position(), 1U);

  history.preview(renamed(start, "D"));
  EXPECT_TRUE(history.undo()) << "undo cancels the gesture";
  EXPECT_TRUE(history.shown() == start);
}

TEST(History, KnowsWhatIsSaved) {
  const Document start = cube_document();
  History history(start);
  EXPECT_FALSE(history.dirty());
  history.push(renamed(start, "A"), "A");
  EXPECT_TRUE(history.dirty());
  history.undo();
  EXPECT_FALSE(history.dirty());
  history.redo();
  history.mark_saved();
  history.push(renamed(start, "B"), "B");
  EXPECT_TRUE(history.dirty());
  history.undo();
  EXPECT_FALSE(history.dirty());
  history.undo();
  EXPECT_TRUE(history.dirty());
  history.push(renamed(start, "C"), "C");
  EXPECT_TRUE(history.dirty()) << "another branch at the same depth is not what was saved";
  const std::uint64_t serial = history.serial();
  history.push(renamed(start, "D"), "D");
  history.mark_saved(serial);
  EXPECT_TRUE(history.dirty());
  history.undo();
  EXPECT_FALSE(history.dirty());
  history.mark_unsaved();
  EXPECT_TRUE(history.dirty());
}

TEST(History, AgreesWithAPlainModel) {
  test::for_random(11, 60, [](std::mt19937_64& rng) {
    std::vector<Document> states{test::any_document(rng)};
    std::vector<std::string> labels;
    std::size_t position = 0, saved = 0;
    History history(states[0]);
    for (int step = 0; step < 60; ++step) {
      switch (test::uniform_int(rng, 0, 6)) {
        case 0:
        case 1:
        case 2: {
          const bool again = test::chance(rng, 0.2);
          Document next = again ? states[position] : test::any_document(rng);
          const bool changes = !(next == states[position]);
          if (changes) {
            if (saved != std::size_t(-1) && saved > position) saved = std::size_t(-1);
            states.resize(position + 1);
            labels.resize(position);
            states.push_back(next);
            labels.push_back("step " + std::to_string(step));
            ++position;
          }
          if (test::chance(rng, 0.5)) {
            ASSERT_EQ(history.push(next, "step " + std::to_string(step)), changes);
          } else {
            history.preview(test::any_document(rng));
            history.preview(next);
            ASSERT_EQ(history.commit_preview("step " + std::to_string(step)), changes);
          }
          break;
        }
        case 3:
        case 4:
          ASSERT_EQ(history.undo(), position > 0);
          if (position > 0) --position;
          break;
        case 5:
          ASSERT_EQ(history.redo(), position + 1 < states.size());
          if (position + 1 < states.size()) ++position;
          break;
        default:
          history.mark_saved();
          saved = position;
          break;
      }
      ASSERT_TRUE(history.current() == states[position]);
      ASSERT_EQ(history.position(), position);
      ASSERT_EQ(history.labels(), labels);
      ASSERT_EQ(history.can_undo(), position > 0);
      ASSERT_EQ(history.can_redo(), position + 1 < states.size());
      ASSERT_EQ(history.dirty(), saved != position);
    }
    // Memory is what a fresh count of the remaining states gives: nothing leaks from the books.
    SharedMemory fresh;
    History copy = history;
    copy.go_to(0);
    fresh.add(copy.current());
    while (copy.redo()) fresh.add(copy.current());
    ASSERT_EQ(fresh.bytes(), history.bytes());
  });
}

TEST(History, ForgetsTheOldestAboveItsLimit) {
  const Document start = document_from_mesh(test::grid(40, 40), "Grid").value();
  SharedMemory one;
  one.add(start);
  const std::size_t limit = one.bytes() + 200'000;
  History history(start, limit);
  history.mark_saved();
  for (int i = 0; i < 500; ++i) {
    const VertexId id{static_cast<std::uint32_t>(i)};
    history.push(
        move_vertices(history.current(), cube_id, std::vector{id}, std::vector<Vector3>{{0, 0, 1.0 * i}})
            .value(),
        std::to_string(i));
    ASSERT_LE(history.bytes(), limit);
  }
  EXPECT_GT(history.position(), 5U);
  EXPECT_LT(history.position(), 499U);
  EXPECT_EQ(history.undo_label(), "499");
  EXPECT_EQ(history.labels().size(), history.position());
  while (history.undo()) EXPECT_TRUE(history.dirty()) << "the saved state was forgotten";
  // One document above the limit is still kept.
  History tiny(start, 1);
  tiny.push(renamed(start, "A"), "A");
  EXPECT_TRUE(tiny.current() == renamed(start, "A"));
  EXPECT_FALSE(tiny.can_undo());
}

std::size_t heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(History, AThousandMovesOf20000FacesFitIn64Megabytes) {
  const Document start = document_from_mesh(test::grid(200, 100), "Sheet").value();
  ASSERT_EQ(test::polyhedron_of(start).polyhedron.face_count(), 20000U);
  [[maybe_unused]] const std::size_t heap_before = heap_bytes();  // not counted under a sanitizer
  History history(start);
  std::mt19937_64 rng(1);
  const Index count = test::polyhedron_of(start).polyhedron.vertex_count();
  for (int i = 0; i < 1000; ++i) {
    const VertexId id{static_cast<std::uint32_t>(rng() % count)};
    ASSERT_TRUE(history.push(move_vertices(history.current(), cube_id, std::vector{id},
                                           std::vector<Vector3>{test::random_vector(rng)})
                                 .value(),
                             "Move a vertex"));
  }
  EXPECT_EQ(history.position(), 1000U) << "nothing was forgotten";
  EXPECT_LT(history.bytes(), std::size_t(64) << 20);
  RecordProperty("history_bytes", std::to_string(history.bytes()));
#ifndef HARIKO_ADDRESS_SANITIZER  // the sanitizer's allocator does not answer mallinfo2
  const std::size_t heap = heap_bytes() - heap_before;
  RecordProperty("heap_bytes", std::to_string(heap));
  EXPECT_LT(heap, std::size_t(64) << 20);
  SharedMemory first;
  first.add(start);
  const double counted = static_cast<double>(history.bytes() - first.bytes());
  EXPECT_NEAR(counted / static_cast<double>(heap), 1, 0.15) << "counted " << counted << ", heap " << heap;
#endif
  while (history.undo()) {
  }
  EXPECT_TRUE(history.current() == start);
}

/// A document that differs by its name alone.
Document renamed(int number) {
  return document_from_mesh(test::cube(), "Object " + std::to_string(number)).value();
}

TEST(HistoryFork, BeginsAnewAndGoesBackInPlace) {
  test::for_random(9917, 200, [](std::mt19937_64& rng) {
    History whole(renamed(0)), forked(renamed(0));
    int number = 0;
    const auto act = [&](History& history, int what) {
      if (what == 0) return void(history.undo());
      if (what == 1) return void(history.redo());
      if (what == 2) return history.mark_saved();
      history.push(renamed(number), "Step " + std::to_string(number));
    };
    for (int i = test::uniform_int(rng, 0, 12); i > 0; --i) {
      const int what = test::uniform_int(rng, 0, 5);
      ++number;
      act(whole, what);
      act(forked, what);
    }
    const History before = forked;
    History fork = before.fork();
    EXPECT_FALSE(fork.can_undo());
    EXPECT_FALSE(fork.can_redo());
    EXPECT_EQ(fork.dirty(), before.dirty());
    EXPECT_EQ(fork.serial(), before.serial());
    ASSERT_TRUE(fork.current() == before.current());
    // Steps only: an undo beyond the fork would be refused there.
    const int steps = test::uniform_int(rng, 0, 4);
    for (int i = 0; i < steps; ++i) {
      ++number;
      whole.push(renamed(number), "Step " + std::to_string(number));
      fork.push(renamed(number), "Step " + std::to_string(number));
    }
    const bool saved = test::chance(rng, 0.5);
    if (saved) {
      whole.mark_saved();
      fork.mark_saved();
    }
    if (steps > 0 && test::chance(rng, 0.5)) {
      whole.undo();
      fork.undo();
    }
    fork.prepend(before);
    EXPECT_EQ(fork.labels(), whole.labels());
    EXPECT_EQ(fork.position(), whole.position());
    EXPECT_EQ(fork.dirty(), whole.dirty());
    EXPECT_EQ(fork.bytes(), whole.bytes());
    while (whole.undo()) {
      ASSERT_TRUE(fork.undo());
      ASSERT_TRUE(fork.current() == whole.current());
      EXPECT_EQ(fork.serial(), whole.serial());
    }
    EXPECT_FALSE(fork.can_undo());
    while (whole.redo()) {
      ASSERT_TRUE(fork.redo());
      ASSERT_TRUE(fork.current() == whole.current());
      EXPECT_EQ(fork.dirty(), whole.dirty());
    }
    EXPECT_FALSE(fork.can_redo());
  });
}

}  // namespace
}  // namespace hariko
