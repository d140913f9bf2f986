// A program that is killed while it saves: the file is the old or the new version, never a mixture.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "core/document/file.hpp"
#include "core/document/source.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko::test {
namespace {

TEST(Kill, WhileSavingLeavesTheOldOrTheNewDocument) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.hariko";
  const Document small = document_from_mesh(cube(), "small").value();
  const Document large = document_from_mesh(torus(40, 30), "large").value();
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(save_document(large, path));
  const auto saving =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start);
  ASSERT_TRUE(save_document(small, path));
  // Long enough that many saves of the large one end before the kill, on slow machines and builds, too.
  const int longest_wait = std::max(20'000, static_cast<int>(4 * saving.count()));

  std::mt19937_64 rng(random_seed(51));
  SCOPED_TRACE("HARIKO_SEED=" + std::to_string(random_seed(51)));
  int large_found = 0;
  const int kills = repetitions(200);
  for (int i = 0; i < kills; ++i) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      while (save_document(large, path).ok() && save_document(small, path).ok()) {
      }
      _exit(1);
    }
    usleep(static_cast<useconds_t>(uniform_int(rng, 100, longest_wait)));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "saving failed before the kill";
    const auto found = must(load_document(path));
    ASSERT_TRUE(*found == small || *found == large);
    large_found += *found == large;
  }
  EXPECT_GT(large_found, 0);
  EXPECT_LT(large_found, kills);
}

}  // namespace
}  // namespace hariko::test
