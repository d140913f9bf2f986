#pragma once

// GaussEngine: computes the displayed Gauss sphere, off the main thread.

#include "app/engines/work_lane.hpp"
#include "core/gaussmap/sphere/gauss_sphere.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/gauss_view.hpp"

namespace hariko {

/// Keeps the Gauss sphere of the active outline up to date. For the main thread.
class GaussEngine {
 public:
  GaussEngine(const Editor& editor, GaussView& view, std::function<void()> wake);

  /// Requests the sphere of the active outline where the outline or the step has changed. During gestures the
  /// latest finished state is shown.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }

 private:
  void forget();

  const Editor& editor_;
  GaussView& view_;
  std::shared_ptr<const Object> object_;  ///< object of the last request
  std::optional<Index> step_;
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko
