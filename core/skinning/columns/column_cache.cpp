#include "core/skinning/columns/column_cache.hpp"

#include <atomic>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/skinning/columns/column_parameters.hpp"

namespace hariko {

std::vector<std::vector<double>> ColumnCache::parameters(const std::vector<Search>& searches, int columns,
                                                         const SkinWork& work) {
  std::vector<std::vector<double>> out(searches.size());
  std::map<std::uint32_t, Found> kept;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const auto known = found_.find(searches[i].key);
    const bool serves = known != found_.end() && known->second.columns == columns &&
                        known->second.curves.front().closed == searches[i].curves.front().closed &&
                        (work.moving || (known->second.curves == searches[i].curves &&
                                         known->second.starts == searches[i].starts));
    if (!serves) {
      open.push_back(i);
      continue;
    }
    out[i] = known->second.parameters;
    kept.insert(*known);
  }
  std::atomic<std::size_t> done = 0;
  const double steps = double(optimiser_seeds * open.size());
  parallel_for(open.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      out[open[k]] = optimised_parameters(
          searches[open[k]].curves, columns, work.cancel,
          [&] { work.progress.report(double(++done) / steps); }, searches[open[k]].starts);
  });
  if (!work.cancel.cancelled())
    for (const std::size_t i : open)
      kept.insert_or_assign(searches[i].key, Found{searches[i].curves, searches[i].starts, columns, out[i]});
  found_ = std::move(kept);
  return out;
}

}  // namespace hariko
