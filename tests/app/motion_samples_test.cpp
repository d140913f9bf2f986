#include "ui/view/motion_samples.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace hariko {
namespace {

constexpr double slow = MotionSamples::longest_milliseconds + 1, quick = 1;

/// Frames of a card that needs `cost(samples)` milliseconds; the number of changes.
int run(MotionSamples& motion, int frames, const std::function<double(int)>& cost) {
  int changes = 0;
  for (int i = 0; i < frames; ++i) {
    const int before = motion.samples();
    motion.measured(before, cost(before));
    changes += motion.samples() != before;
  }
  return changes;
}

TEST(MotionSamples, StayTheMostWherePicturesAreInTime) {
  MotionSamples motion(4);
  EXPECT_TRUE(motion.chooses());
  EXPECT_EQ(run(motion, 1000, [](int) { return MotionSamples::longest_milliseconds; }), 0);
  EXPECT_EQ(run(motion, 1000, [](int) { return quick; }), 0);
  EXPECT_EQ(motion.samples(), 4);
}

TEST(MotionSamples, FallByHalvesAndNeverBelowOne) {
  MotionSamples motion(4);
  run(motion, MotionSamples::deciding_frames - 1, [](int) { return slow; });
  EXPECT_EQ(motion.samples(), 4);
  run(motion, 1, [](int) { return slow; });
  EXPECT_EQ(motion.samples(), 2);
  run(motion, 100, [](int) { return slow; });
  EXPECT_EQ(motion.samples(), 1);
}

TEST(MotionSamples, SingleSlowPicturesDecideNothing) {
  MotionSamples motion(4);
  for (int i = 0; i < 100; ++i) {
    run(motion, MotionSamples::deciding_frames - 1, [](int) { return slow; });
    run(motion, 1, [](int) { return quick; });
  }
  EXPECT_EQ(motion.samples(), 4);
}

TEST(MotionSamples, RiseAgainWhenTheCardIsAwake) {
  MotionSamples motion(4);
  run(motion, 6, [](int) { return slow; });
  EXPECT_EQ(motion.samples(), 1);
  EXPECT_EQ(run(motion, 1000, [](int samples) { return 0.5 * samples; }), 2);
  EXPECT_EQ(motion.samples(), 4);
}

TEST(MotionSamples, TimesOfOtherSamplesSayNothing) {
  MotionSamples motion(4);
  for (int i = 0; i < 100; ++i) motion.measured(2, slow);
  EXPECT_EQ(motion.samples(), 4);
}

TEST(MotionSamples, OneIsNoChoice) {
  MotionSamples motion(1);
  EXPECT_FALSE(motion.chooses());
  EXPECT_EQ(run(motion, 100, [](int) { return slow; }) + run(motion, 100, [](int) { return quick; }), 0);
}

TEST(MotionSamples, WhatProvedTooSlowIsTriedEverMoreSeldom) {
  MotionSamples motion(4);
  // A card on which two samples take much more than twice as long as one: each trial is a rise and a fall.
  const auto cost = [](int samples) { return samples > 1 ? slow : quick; };
  EXPECT_LE(run(motion, 600, cost), 2 + 2 * 3) << "ten seconds";
  EXPECT_LE(run(motion, 3600, cost), 2 * 2) << "a minute more";
}

}  // namespace
}  // namespace hariko
