// A session that is killed while it edits, autosaves and saves: nothing that was written is lost, and nothing
// that is found is a mixture.

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>

#include "app/persistence/autosaver.hpp"
#include "core/document/file.hpp"
#include "tests/persistence/numbers.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

/// Documents of very different length, so that a mixture would show.
Document numbered_model(std::uint64_t number) {
  static const Document small = document_from_mesh(test::cube(), "0").value();
  static const Document large = document_from_mesh(test::torus(30, 20), "0").value();
  Document document = number % 2 == 0 ? small : large;
  Object object = *document.objects[0];
  object.name = std::to_string(number);
  document.objects[0] = std::make_shared<const Object>(std::move(object));
  return document;
}

/// Promises of the session to its parent; they survive the kill.
struct Promises {
  std::atomic<std::uint64_t> kept = 0;  ///< number of the last document that was written, to whatever place
  std::atomic<std::uint64_t> autosaves = 0, saves = 0;
};

/// Edits, autosaves and saves until it is killed.
void session(const fs::path& state, const fs::path& original, std::uint64_t first, std::uint64_t seed,
             Promises& said) {
  std::mt19937_64 rng(seed);
  Autosaver saver{RecoveryStore(state)};
  auto stamp = stamp_of(original);
  for (std::uint64_t i = first;; ++i) {
    saver.set_work({numbered_model(i), {1, i}, {original, stamp, 0}});
    if (!saver.write(0).ok()) ::_exit(1);
    said.kept = i;
    ++said.autosaves;
    if (!test::chance(rng, 0.3)) continue;
    if (!save_document(numbered_model(i), original).ok()) ::_exit(1);
    stamp = stamp_of(original);
    ++said.saves;
    saver.set_nothing();
    if (!saver.write(0).ok()) ::_exit(1);
  }
}

TEST(Kill, InTheMiddleOfASessionLosesNothingThatWasWritten) {
  const test::TemporaryFolder folder;
  const fs::path state = folder.path() / "recovery", original = folder.path() / "model.hariko";
  void* memory = ::mmap(nullptr, sizeof(Promises), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  Promises& said = *new (memory) Promises;
  ASSERT_TRUE(save_document(numbered_model(0), original));

  const std::uint64_t seed = test::random_seed(71);
  SCOPED_TRACE("HARIKO_SEED=" + std::to_string(seed));
  std::mt19937_64 rng(seed);
  const RecoveryStore store(state);
  SystemFileLayer layer;
  int offered = 0;
  const int kills = test::repetitions(200);
  for (int i = 0; i < kills; ++i) {
    SCOPED_TRACE("kill " + std::to_string(i));
    const std::uint64_t first = said.kept + 1, child_seed = rng();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) session(state, original, first, child_seed, said);
    ::usleep(static_cast<useconds_t>(test::uniform_int(rng, 100, 70'000)));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "writing failed before the kill";

    const auto saved = test::must(load_document(original));
    ASSERT_TRUE(*saved == numbered_model(test::number_of(*saved)));
    std::uint64_t best = test::number_of(*saved);
    const auto leftovers = store.leftovers(0);
    ASSERT_LE(leftovers.size(), 1U);
    for (const Leftover& leftover : leftovers) {
      ++offered;
      ASSERT_FALSE(leftover.damaged);
      auto slot = store.adopt(leftover.id, 0).value();
      const Document found = read_recovery(slot.folder())->document;
      ASSERT_TRUE(found == numbered_model(test::number_of(found)));
      ASSERT_EQ(leftover.note.original, original);
      // An older copy than the file is never offered without saying so.
      if (test::number_of(found) < test::number_of(*saved)) {
        ASSERT_TRUE(leftover.file_changed);
      }
      best = std::max(best, test::number_of(found));
      // The designer recovers what is newer, saves it, and works on from there.
      if (test::number_of(found) > test::number_of(*saved)) {
        ASSERT_TRUE(save_document(found, original));
      }
      ASSERT_TRUE(slot.clear(layer));
    }
    ASSERT_GE(best, said.kept) << "written work was lost";
    said.kept = best;
  }
  EXPECT_GT(offered, kills / 10) << "the kills must hit sessions with unsaved work";
  EXPECT_GT(said.autosaves, 0U);
  EXPECT_GT(said.saves, 0U);
  std::cout << kills << " kills: " << said.autosaves << " autosaves, " << said.saves << " saves, " << offered
            << " offers\n";
  ::munmap(memory, sizeof(Promises));
}

}  // namespace
}  // namespace hariko
