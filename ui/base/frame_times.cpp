#include "ui/base/frame_times.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(fraction * double(values.size()))) - 1;
  const auto at = values.begin() + std::clamp<std::ptrdiff_t>(rank, 0, std::ssize(values) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

template <class Part>
double quantile_of(const std::vector<FrameSample>& samples, double fraction, Part part) {
  std::vector<double> values;
  values.reserve(samples.size());
  for (const FrameSample& sample : samples) values.push_back(part(sample));
  return quantile(std::move(values), fraction);
}

}  // namespace

void FrameTimes::clear() {
  samples_.clear();
  latencies_.clear();
}

double FrameTimes::total(double fraction) const {
  return quantile_of(samples_, fraction, [](const FrameSample& s) { return s.ours + s.renderer; });
}
double FrameTimes::ours(double fraction) const {
  return quantile_of(samples_, fraction, [](const FrameSample& s) { return s.ours; });
}
double FrameTimes::renderer(double fraction) const {
  return quantile_of(samples_, fraction, [](const FrameSample& s) { return s.renderer; });
}
double FrameTimes::latency(double fraction) const {
  return quantile(latencies_, fraction);
}

}  // namespace hariko
