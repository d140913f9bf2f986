#include "app/input/space_mouse.hpp"

#include <utility>

#ifdef HARIKO_SPACENAV
#include <poll.h>
#include <spnav.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#endif

namespace hariko {

InputEvent cap_event(const std::array<int, 3>& push, const std::array<int, 3>& turn, unsigned period) {
  constexpr double full = 350;
  InputEvent event{.kind = InputEvent::Kind::cap};
  event.cap = {push[0] / full,  push[1] / full,  -push[2] / full,
               -turn[0] / full, -turn[1] / full, turn[2] / full};
  event.seconds = period / 1000.0;
  return event;
}

#ifdef HARIKO_SPACENAV

namespace {

/// Whether the daemon answers: the library's own attempt prints what fails.
bool daemon_answers() {
  const char* named = std::getenv("SPNAV_SOCKET");
  const std::string path = named ? named : "/var/run/spnav.sock";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int trial = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (trial < 0) return false;
  const bool answers = connect(trial, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(trial);
  return answers;
}

std::optional<InputEvent> event_of_daemon(const spnav_event& told) {
  if (told.type == SPNAV_EVENT_MOTION) {
    const spnav_event_motion& motion = told.motion;
    return cap_event({motion.x, motion.y, motion.z}, {motion.rx, motion.ry, motion.rz}, motion.period);
  }
  if (told.type != SPNAV_EVENT_BUTTON) return std::nullopt;
  InputEvent event{.kind = InputEvent::Kind::cap_button, .code = told.button.bnum};
  event.down = told.button.press != 0;
  return event;
}

}  // namespace

/// The thread, and what it has heard. The library is used by the thread alone once it runs.
class SpaceMouse::Listener {
 public:
  /// Takes up an open connection.
  explicit Listener(std::function<void()> wake) : wake_(std::move(wake)) {
    if (pipe(end_.data()) != 0) {
      end_ = {-1, -1};
      return;
    }
    thread_ = std::thread([this] { listen(); });
  }
  ~Listener() {
    if (thread_.joinable()) {
      close(end_[1]);  // ends the wait for the pipe
      thread_.join();
      close(end_[0]);
    }
    spnav_close();
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::vector<InputEvent> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(heard_, {});
  }

 private:
  void listen() {
    std::array<pollfd, 2> waits{pollfd{spnav_fd(), POLLIN, 0}, pollfd{end_[0], POLLIN, 0}};
    for (;;) {
      if (poll(waits.data(), waits.size(), -1) < 0) {
        if (errno == EINTR) continue;
        return;
      }
      if (waits[1].revents != 0) return;
      spnav_event told;
      while (spnav_poll_event(&told) != 0) {
        const auto event = event_of_daemon(told);
        if (!event) continue;
        const std::lock_guard lock(mutex_);
        heard_.push_back(*event);
      }
      wake_();
      if ((waits[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) return;  // the daemon has ended
    }
  }

  std::function<void()> wake_;
  std::array<int, 2> end_{-1, -1};  ///< a pipe that is closed to end the thread
  std::mutex mutex_;
  std::vector<InputEvent> heard_;
  std::thread thread_;
};

SpaceMouse::SpaceMouse(std::function<void()> wake) {
  if (daemon_answers() && spnav_open() == 0) listener_ = std::make_unique<Listener>(std::move(wake));
}

#else

/// Nothing to listen to: the library was not there when the program was built.
class SpaceMouse::Listener {
 public:
  std::vector<InputEvent> take() { return {}; }
};

SpaceMouse::SpaceMouse(std::function<void()> /*wake*/) {}

#endif

SpaceMouse::~SpaceMouse() = default;

std::vector<InputEvent> SpaceMouse::take() {
  return listener_ ? listener_->take() : std::vector<InputEvent>();
}

}  // namespace hariko
