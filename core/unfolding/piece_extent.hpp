#pragma once

// PieceExtent: how much room a set of points takes in each of 18 directions, to tell whether a piece fits on
// a page when it is turned.

#include <array>
#include <limits>

#include "core/base/vector.hpp"
#include "core/document/paper_settings.hpp"
#include "core/unfolding/facet_layout.hpp"

namespace hariko {

class PieceExtent {
 public:
  static constexpr std::size_t directions = 18;  ///< every 10 degrees of a half turn

  void add(const FacetCorners& corners);
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
