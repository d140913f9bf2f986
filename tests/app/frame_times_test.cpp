#include "ui/base/frame_times.hpp"

#include <gtest/gtest.h>

namespace hariko {
namespace {

TEST(FrameTimes, QuantilesAreValuesThatWereMeasured) {
  FrameTimes times;
  EXPECT_EQ(times.total(0.5), 0);
  for (int i = 1; i <= 100; ++i) times.add({double(i), 1000.0 - i});
  EXPECT_EQ(times.ours(0.5), 50);
  EXPECT_EQ(times.ours(0.95), 95);
  EXPECT_EQ(times.ours(0), 1);
  EXPECT_EQ(times.ours(1), 100);
  EXPECT_EQ(times.renderer(0.5), 949);
  EXPECT_EQ(times.total(0.95), 1000);
}

TEST(FrameTimes, KeepsTheLastFramesOnly) {
  FrameTimes times;
  for (std::size_t i = 0; i < FrameTimes::kept + 10; ++i) times.add({double(i), 0});
  EXPECT_EQ(times.samples().size(), FrameTimes::kept);
  EXPECT_EQ(times.samples().front().ours, 10);
}

}  // namespace
}  // namespace hariko
