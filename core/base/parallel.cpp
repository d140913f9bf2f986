#include "core/base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/base/assert.hpp"

namespace hariko {

namespace {
std::size_t range_count(std::size_t count, std::size_t grain) {
  return (count + grain - 1) / grain;
}
}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  HARIKO_ASSERT(grain > 0, "grain must be positive");
  const std::size_t ranges = range_count(count, grain);
  if (ranges == 0) return;
  if (ranges == 1) {
    body(0, count);
    return;
  }
  tbb::parallel_for(std::size_t(0), ranges,
                    [&](std::size_t r) { body(r * grain, std::min(count, (r + 1) * grain)); });
}

double parallel_sum(std::size_t count, std::size_t grain,
                    const std::function<double(std::size_t, std::size_t)>& body) {
  HARIKO_ASSERT(grain > 0, "grain must be positive");
  std::vector<double> partial(range_count(count, grain));
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin / grain; r * grain < end; ++r)
      partial[r] = body(r * grain, std::min(end, (r + 1) * grain));
  });
  double sum = 0;
  for (double p : partial) sum += p;
  return sum;
}

struct ParallelLimit::Control {
  tbb::global_control control;
};

ParallelLimit::ParallelLimit(int threads)
    : control_(new Control{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                               static_cast<std::size_t>(std::max(1, threads)))}) {}

ParallelLimit::~ParallelLimit() = default;

}  // namespace hariko
