#include "core/cad/kernel/opencascade/isolated.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <new>
#include <string_view>

namespace hariko {

namespace {

constexpr int look_milliseconds = 50;  ///< interval between checks for cancellation

/// Progress fraction in memory shared by both processes.
class SharedFraction {
 public:
  SharedFraction()
      : memory_(::mmap(nullptr, sizeof(std::atomic<double>), PROT_READ | PROT_WRITE,
                       MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ != MAP_FAILED) fraction_ = new (memory_) std::atomic<double>(0);
  }
  ~SharedFraction() {
    if (fraction_) ::munmap(memory_, sizeof(std::atomic<double>));
  }
  SharedFraction(const SharedFraction&) = delete;
  SharedFraction& operator=(const SharedFraction&) = delete;
  std::atomic<double>* get() const { return fraction_; }

 private:
  void* memory_;
  std::atomic<double>* fraction_ = nullptr;
};

/// Runs the work and ends the child process. Never returns: exit handlers are the parent's business.
[[noreturn]] void work_and_end(const std::function<std::string(const std::function<void(double)>&)>& work,
                               double most_seconds, std::atomic<double>& fraction, int out) {
  const auto seconds = static_cast<rlim_t>(std::ceil(most_seconds));
  const rlimit limit{seconds, seconds + 1};
  ::setrlimit(RLIMIT_CPU, &limit);
  // A crash is an expected outcome here, not to be reported.
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE, SIGXCPU})
    ::signal(signal, SIG_DFL);
  bool whole = false;
  try {
    whole = write_all(out, work([&](double value) { fraction.store(value, std::memory_order_relaxed); }));
  } catch (...) {
  }
  ::_exit(whole ? 0 : 1);
}

double seconds_of(clockid_t clock) {
  timespec time{};
  return ::clock_gettime(clock, &time) == 0 ? double(time.tv_sec) + 1e-9 * double(time.tv_nsec) : 0;
}

/// Detects a process that is stuck: one that uses no processor time.
class Watch {
 public:
  Watch(pid_t process, double most_waiting) : most_waiting_(most_waiting) {
    known_ = ::clock_getcpuclockid(process, &clock_) == 0;
    since_ = seconds_of(CLOCK_MONOTONIC);
  }
  bool stuck() {
    if (!known_) return false;
    const double used = seconds_of(clock_), now = seconds_of(CLOCK_MONOTONIC);
    constexpr double least = 1e-3;
    if (used > used_ + least) {
      used_ = used;
      since_ = now;
    }
    return now - since_ > most_waiting_;
  }

 private:
  double most_waiting_, used_ = 0, since_ = 0;
  clockid_t clock_{};
  bool known_ = false;
};

/// Reads until the other end is closed; false where the work was cancelled or is stuck.
bool read_all(int descriptor, std::string& bytes, const SharedFraction& fraction, Watch watch,
              const CancelToken& cancel, const Progress& progress) {
  std::array<char, 65536> part{};
  for (;;) {
    if (cancel.cancelled() || watch.stuck()) return false;
    progress.report(fraction.get()->load(std::memory_order_relaxed));
    pollfd waiting{descriptor, POLLIN, 0};
    if (::poll(&waiting, 1, look_milliseconds) <= 0) continue;
    const ssize_t got = ::read(descriptor, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got == 0;
    bytes.append(part.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::optional<std::string> isolated(
    const std::function<std::string(const std::function<void(double)>& report)>& work,
    const Patience& patience, const CancelToken& cancel, const Progress& progress) {
  const SharedFraction fraction;
  std::array<int, 2> ends{};
  if (!fraction.get() || ::pipe(ends.data()) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    work_and_end(work, patience.working, *fraction.get(), ends[1]);
  }
  ::close(ends[1]);
  std::string bytes;
  const bool whole =
      child > 0 && read_all(ends[0], bytes, fraction, Watch(child, patience.waiting), cancel, progress);
  ::close(ends[0]);
  if (child < 0) return {};
  if (!whole) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!whole || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
  return bytes;
}

}  // namespace hariko
