#pragma once

// ColumnMemory: where columns were found to lie best, for as long as the sections stay as they are.

#include <cstdint>
#include <map>
#include <vector>

#include "core/skinning/skin_work.hpp"
#include "core/skinning/subdivision_curve.hpp"

namespace hariko {

/// Calls must not overlap.
class ColumnMemory {
 public:
  /// Curves that share their parameters, counted from where each begins, and a name by which these are found
  /// again.
  struct Search {
    std::uint32_t key = 0;
    std::vector<SubdivisionCurve> curves;
    std::vector<double> starts = {};  ///< one a curve; empty: 0
  };
  /// `optimised_parameters` of each, from memory where the curves and the number of columns are those of the
  /// last call; when `work.moving` also where the curves have changed since. The others are found at the same
  /// time on all threads. Without `moving` the result is a function of the searches alone. What was cancelled
  /// is not remembered, nor what is not asked for again.
  std::vector<std::vector<double>> parameters(const std::vector<Search>& searches, int columns,
                                              const SkinWork& work);

 private:
  struct Found {
    std::vector<SubdivisionCurve> curves;
    std::vector<double> starts;
    int columns = 0;
    std::vector<double> parameters;
  };
  std::map<std::uint32_t, Found> found_;
};

}  // namespace hariko
