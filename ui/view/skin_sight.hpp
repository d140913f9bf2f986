#pragma once

// What of the active skin's marks can be seen, and so be taken hold of.

#include <cstdint>
#include <set>
#include <vector>

#include "render/surface_occlusion.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

/// Surfaces hide what lies behind them. Points of paths and places on them are never hidden: paths run inside
/// of tubes.
class SkinSight {
 public:
  SkinSight(const Editor& editor, const Projector& projector, const SkinView& view, const Object& object);

  /// Of a point in the object's space.
  bool hides(const Vector3& point) const;
  bool hides_handle(std::size_t index) const { return hidden_[index] != 0; }
  /// Hidden points are shown (palely) and can be taken hold of: x-ray, or selecting through.
  bool through() const { return through_; }
  /// Section points that cannot be taken hold of; none where hidden ones can.
  std::set<std::uint32_t> hidden_points() const;
  /// `skin_hit` of what can be taken hold of.
  SkinHit hit(const Projector& projector, const Vector2& pixel, double pixel_scale) const;

 private:
  const SkinView& view_;
  const Object& object_;
  bool through_;
  SurfaceOcclusion occlusion_;
  std::vector<char> hidden_;  ///< of the handles
};

}  // namespace hariko
