#include "ui/view/motion_samples.hpp"

#include <algorithm>

namespace hariko {

void MotionSamples::measured(int samples, double milliseconds) {
  if (samples != samples_) return;
  // Twice the samples take at most about twice as long.
  constexpr double quick_milliseconds = 0.45 * longest_milliseconds;
  constexpr int rarer = 8, most_wanted = 10'000;
  slow_ = milliseconds > longest_milliseconds ? slow_ + 1 : 0;
  quick_ = milliseconds < quick_milliseconds ? quick_ + 1 : 0;
  if (slow_ >= deciding_frames && samples_ > 1) {
    samples_ /= 2;
    if (raised_) quick_wanted_ = std::min(rarer * quick_wanted_, most_wanted);
    raised_ = false;
  } else if (quick_ >= quick_wanted_ && samples_ < most_) {
    samples_ *= 2;
    raised_ = true;
  } else {
    return;
  }
  slow_ = quick_ = 0;
}

}  // namespace hariko
