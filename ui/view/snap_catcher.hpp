#pragma once

// SnapCatcher: what a tool that draws or places catches under the pointer.

#include <memory>
#include <optional>
#include <vector>

#include "ui/view/snapping.hpp"

namespace hariko {

/// A value; copies share the places.
class SnapCatcher {
 public:
  /// Call before anything is caught: collects the places anew where the document, a surface or the kinds are
  /// others.
  void update(const ToolContext& context);
  /// The place under a pixel, of the kinds of the settings; nothing but the grid: see `SnapPlaces`. `from`:
  /// where the gesture began; `normal`: of the plane that is drawn in.
  std::optional<SnapTarget> find(const ToolContext& context, const Vector2& pixel,
                                 const std::optional<Vector3>& from, const Vector3& normal) const;

  /// Collected places; null before the first update.
  const SnapPlaces* places() const { return places_.get(); }

 private:
  std::shared_ptr<const SnapPlaces> places_;
  SnapSettings kinds_;
  // Document and settings that the places were collected from.
  std::uint64_t document_ = 0, serial_ = 0;
  std::vector<std::shared_ptr<const DisplayMesh>> meshes_;
};

/// Draws the mark of what was caught, one shape for each kind, and its name above it.
void draw_snap_target(const ToolContext& context, const ToolOverlay& overlay, const SnapTarget& target,
                      bool warning = false);

}  // namespace hariko
