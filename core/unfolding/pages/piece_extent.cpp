#include "core/unfolding/pages/piece_extent.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hariko {

namespace {

std::array<Vector2, PieceExtent::directions> make_directions() {
  std::array<Vector2, PieceExtent::directions> out;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(out.size());
    out[k] = {std::cos(angle), std::sin(angle)};
  }
  return out;
}

}  // namespace

void PieceExtent::add(const FacetCorners& corners) {
  static const std::array<Vector2, directions> axes = make_directions();
  for (const Vector2& corner : corners)
    for (std::size_t k = 0; k < directions; ++k) {
      const double along = axes[k].x() * corner.x() + axes[k].y() * corner.y();
      low_[k] = std::min(low_[k], along);
      high_[k] = std::max(high_[k], along);
    }
}

bool PieceExtent::fits(const PaperSize& room) const {
  for (std::size_t k = 0; k < directions; ++k) {
    const std::size_t across = (k + directions / 2) % directions;
    if (high_[k] - low_[k] <= room.width && high_[across] - low_[across] <= room.height) return true;
  }
  return false;
}

}  // namespace hariko
