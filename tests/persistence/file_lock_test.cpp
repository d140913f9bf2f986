#include "app/persistence/file_lock.hpp"

#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;
using Outcome = FileLock::Attempt::Outcome;

/// A child that takes the lock, says so, and holds it until it is killed.
class HoldingChild {
 public:
  explicit HoldingChild(const fs::path& path) {
    int ends[2];
    if (::pipe(ends) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
      const auto attempt = FileLock::try_lock(path, 77);
      const char said = attempt.outcome == Outcome::acquired ? 'y' : 'n';
      if (::write(ends[1], &said, 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char said = 0;
    holds_ = ::read(ends[0], &said, 1) == 1 && said == 'y';
    ::close(ends[0]);
    ::close(ends[1]);
  }
  ~HoldingChild() { kill(); }
  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = -1;
  }
  bool holds() const { return holds_; }
  pid_t process() const { return process_; }

 private:
  pid_t process_ = -1;
  bool holds_ = false;
};

TEST(FileLock, IsTakenWhileItsHolderLivesAndNamesIt) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "lock";
  HoldingChild child(path);
  ASSERT_TRUE(child.holds());
  const auto attempt = FileLock::try_lock(path, 0);
  ASSERT_EQ(attempt.outcome, Outcome::taken);
  EXPECT_TRUE(attempt.certain);
  ASSERT_TRUE(attempt.owner);
  EXPECT_EQ(attempt.owner->process, child.process());
  EXPECT_EQ(attempt.owner->since, 77);
  EXPECT_EQ(attempt.owner->host, this_process().host);
  EXPECT_TRUE(may_be_alive(*attempt.owner));
  const LockOwner owner = *attempt.owner;
  child.kill();
  EXPECT_TRUE(fs::exists(path)) << "the killed process left its file";
  EXPECT_FALSE(may_be_alive(owner));
  EXPECT_EQ(FileLock::try_lock(path, 0).outcome, Outcome::acquired) << "what a dead process left is stale";
  EXPECT_FALSE(fs::exists(path)) << "the file goes with the lock";
}

TEST(FileLock, IsExclusiveWithinAProcessAndMoves) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "lock";
  auto first = FileLock::try_lock(path, 0);
  ASSERT_EQ(first.outcome, Outcome::acquired);
  EXPECT_EQ(FileLock::try_lock(path, 0).outcome, Outcome::taken);
  FileLock moved = std::move(first.lock);
  EXPECT_FALSE(first.lock.held());
  EXPECT_EQ(FileLock::try_lock(path, 0).outcome, Outcome::taken);
  moved = FileLock();
  EXPECT_EQ(FileLock::try_lock(path, 0).outcome, Outcome::acquired);
}

TEST(FileLock, OneOfManyGetsIt) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "lock";
  std::atomic<int> holders = 0, most = 0, taken_by = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&] {
      // A fixed number of tries says nothing: a holder put to sleep may outlast those of all others.
      while (taken_by < 100) {
        const auto attempt = FileLock::try_lock(path, 0);
        if (attempt.outcome != Outcome::acquired) continue;
        const int now = ++holders;
        ++taken_by;
        int seen = most;
        while (now > seen && !most.compare_exchange_weak(seen, now)) {
        }
        std::this_thread::yield();
        --holders;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
}

TEST(FileLock, WithoutKernelLocksTheLifeOfTheOwnerDecides) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "lock";
  const auto no_locks = [](int, int) {
    errno = ENOLCK;
    return -1;
  };
  {
    const auto first = FileLock::try_lock(path, 5, no_locks);
    ASSERT_EQ(first.outcome, Outcome::acquired);
    EXPECT_FALSE(first.certain);
    const auto second = FileLock::try_lock(path, 6, no_locks);
    ASSERT_EQ(second.outcome, Outcome::taken);
    EXPECT_EQ(second.owner->since, 5);
  }
  EXPECT_FALSE(fs::exists(path));
  // Stale owners: of a process that is gone, of another boot, and nonsense. Of another machine nothing is
  // known.
  LockOwner gone = this_process();
  gone.process_start += 1;
  EXPECT_FALSE(may_be_alive(gone));
  gone = this_process();
  gone.boot = "another";
  EXPECT_FALSE(may_be_alive(gone));
  gone.host = "elsewhere";
  EXPECT_TRUE(may_be_alive(gone));
  for (const char* text : {"", "nonsense", "{}", "{\"host\": 5}"}) {
    test::spill(path, text);
    EXPECT_EQ(FileLock::try_lock(path, 0, no_locks).outcome, Outcome::acquired) << text;
  }
}

TEST(FileLock, SaysWhyItCannotBeMade) {
  const auto attempt = FileLock::try_lock("/proc/nowhere/lock", 0);
  EXPECT_EQ(attempt.outcome, Outcome::unavailable);
  EXPECT_FALSE(attempt.reason.empty());
}

TEST(FileLock, OfADocumentIsOneForAllItsNames) {
  const test::TemporaryFolder folder;
  test::spill(folder.path() / "a.hariko", "x");
  fs::create_symlink("a.hariko", folder.path() / "link.hariko");
  const fs::path lock = lock_path_of(folder.path() / "a.hariko");
  EXPECT_EQ(lock.filename(), ".a.hariko.lock");
  EXPECT_EQ(lock_path_of(folder.path() / "link.hariko"), lock);
  EXPECT_EQ(lock_path_of(folder.path() / "." / "a.hariko"), lock);
  EXPECT_EQ(lock_path_of(folder.path() / "new.hariko").parent_path(), fs::canonical(folder.path()));
}

}  // namespace
}  // namespace hariko
