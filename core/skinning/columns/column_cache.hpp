#pragma once

// ColumnCache: cache of optimised column parameters, valid while the sections stay unchanged.

#include <cstdint>
#include <map>
#include <vector>

#include "core/skinning/columns/skin_context.hpp"
#include "core/subdivision/subdivision_curve.hpp"

namespace hariko {

/// Cache of column parameters. Calls must not overlap.
class ColumnCache {
 public:
  /// Curves that share their parameters, counted from the start of each, and the key of the cache entry.
  struct Search {
    std::uint32_t key = 0;
    std::vector<SubdivisionCurve> curves;
    std::vector<double> starts = {};  ///< one per curve; empty: 0
  };
  /// Returns `optimised_parameters` of each search, from the cache where the curves and the number of columns
  /// are those of the last call; when `work.moving` also where the curves have changed since. The others are
  /// computed in parallel on all threads. Without `moving` the result is a function of the searches alone.
  /// Results of cancelled searches are not stored, and entries that are not used again are dropped.
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
