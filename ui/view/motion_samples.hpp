#pragma once

// MotionSamples: samples a pixel while things move, so many that the graphics card keeps up with the screen.

namespace hariko {

/// Begins with the most samples. Halves them where pictures take too long, and doubles them again where these
/// would not; where they would after all, it tries that ever more seldom.
class MotionSamples {
 public:
  /// `most`: a power of two; with 1 there is nothing to choose.
  explicit MotionSamples(int most) : most_(most), samples_(most) {}

  int samples() const { return samples_; }
  bool chooses() const { return most_ > 1; }
  /// Takes how long the pictures of a frame took together. Those with other samples than the present ones
  /// say nothing.
  void measured(int samples, double milliseconds);

  /// Longest time for the pictures of a frame. The rest of the 16.7 of a frame is for the interface and for
  /// our own work.
  static constexpr double longest_milliseconds = 10;
  /// Frames in a row that decide. A card that rested is slow at first.
  static constexpr int deciding_frames = 3;

 private:
  int most_, samples_;
  int slow_ = 0, quick_ = 0;            ///< such frames in a row
  int quick_wanted_ = deciding_frames;  ///< in a row, for more samples
  bool raised_ = false;                 ///< by the last change
};

}  // namespace hariko
