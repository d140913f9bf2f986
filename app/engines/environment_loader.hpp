#pragma once

// EnvironmentLoader: makes or reads the environment that the view shows, off the main thread.

#include <functional>
#include <optional>

#include "app/engines/work_lane.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Keeps `Editor::environment` as the settings say while the view shows one. A file that cannot be read is
/// told once, and the studio stands in its place until another environment is chosen. For the main thread.
class EnvironmentLoader {
 public:
  EnvironmentLoader(Editor& editor, std::function<void()> wake);

  /// Requests the environment where it is another one than before, or `Editor::environment` was emptied.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  /// Waits for the job, for tests.
  void wait() { lane_.wait(); }

 private:
  /// State that levels depend on; turn and exposure are applied when they are drawn.
  struct Request {
    EnvironmentKind kind = EnvironmentKind::studio;
    std::string file;  ///< empty for what is made by formula
    friend bool operator==(const Request&, const Request&) = default;
  };
  Request wanted() const;

  Editor& editor_;
  std::optional<Request> requested_;
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko
