#pragma once

// FrameTimes: how long the last frames took, and which part of that was our own work. A value; the
// application writes it while the overlay shows.

#include <cstddef>
#include <vector>

namespace hariko {

/// Milliseconds.
struct FrameSample {
  double ours = 0;      ///< tools, scene, panels: all that runs on the main thread before OpenGL gets it
  double renderer = 0;  ///< OpenGL until it is finished, a software rasteriser included
};

class FrameTimes {
 public:
  bool visible = false;

  void add(const FrameSample& sample) { push(samples_, sample); }
  /// From an event of the pointer to the end of the frame that shows the surface it made.
  void add_latency(double milliseconds) { push(latencies_, milliseconds); }
  void clear();

  /// Oldest first.
  const std::vector<FrameSample>& samples() const { return samples_; }
  /// The value that a fraction of the frames does not exceed, fraction in [0, 1]; 0 without frames.
  double total(double fraction) const;
  double ours(double fraction) const;
  double renderer(double fraction) const;
  double latency(double fraction) const;
  static constexpr std::size_t kept = 240;

 private:
  template <class T>
  static void push(std::vector<T>& values, const T& value) {
    if (values.size() == kept) values.erase(values.begin());
    values.push_back(value);
  }

  std::vector<FrameSample> samples_;
  std::vector<double> latencies_;
};

}  // namespace hariko
