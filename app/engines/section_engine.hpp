#pragma once

// SectionEngine: computes the displayed section curves, off the main thread.

#include <vector>

#include "app/engines/work_lane.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Keeps the section curves of the visible surfaces up to date. For the main thread.
class SectionEngine {
 public:
  SectionEngine(const Editor& editor, SectionCurves& curves, std::function<void()> wake);

  /// Requests curves where surfaces, planes or combs have changed. During gestures the latest finished state
  /// is shown.
  void sync();
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  /// Waits for the job, for tests.
  void wait() { lane_.wait(); }

 private:
  /// State that the curves depend on. Meshes stand for surfaces, which have no identity.
  struct Request {
    std::vector<std::pair<std::shared_ptr<const DisplayMesh>, Similarity>> surfaces;
    SectionPlanes planes;
    SectionCombs combs;
    friend bool operator==(const Request&, const Request&) = default;
  };
  Request wanted() const;

  const Editor& editor_;
  SectionCurves& curves_;
  std::optional<Request> requested_;
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko
