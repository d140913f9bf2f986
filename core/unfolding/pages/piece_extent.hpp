#pragma once

// PieceExtent: widths of a set of points in 18 directions, to test whether a piece fits on a page in some
// rotation.

#include <array>
#include <limits>

#include "core/base/vector.hpp"
#include "core/document/paper_settings.hpp"
#include "core/unfolding/cuts/facet_layout.hpp"

namespace hariko {

/// Support interval of a set of points in each of the directions.
class PieceExtent {
 public:
  static constexpr std::size_t directions = 18;  ///< every 10 degrees of a half turn

  /// Extends the intervals by a facet.
  void add(const FacetCorners& corners);
  /// Whether the points fit the room in one of the directions.
  bool fits(const PaperSize& room) const;

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  static std::array<double, directions> all(double value) {
    std::array<double, directions> out;
    out.fill(value);
    return out;
  }
  std::array<double, directions> low_ = all(far), high_ = all(-far);
};

}  // namespace hariko
