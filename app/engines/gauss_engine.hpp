#pragma once

// Keeps the Gauss sphere that is shown up to date, off the main thread.

#include "app/engines/work_lane.hpp"
#include "core/gaussmap/gauss_sphere.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/gauss_view.hpp"

namespace hariko {

/// For the main thread.
class GaussEngine {
 public:
  GaussEngine(const Editor& editor, GaussView& view, std::function<void()> wake);

  /// Asks for the sphere of the active outline where it, or the step, has changed. Follows gestures: the
  /// latest state that is ready shows.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }

 private:
  void forget();

  const Editor& editor_;
  GaussView& view_;
  std::shared_ptr<const Object> object_;  ///< of the last request
  std::optional<Index> step_;
  WorkLane lane_;  ///< last: its thread stops before the rest goes
};

}  // namespace hariko
