#include "app/crash_report.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>

namespace hariko {
namespace {

TEST(CrashReportDeathTest, NamesTheSignalAndEndsByIt) {
  EXPECT_EXIT((report_crashes(), static_cast<void>(::raise(SIGSEGV))), ::testing::KilledBySignal(SIGSEGV),
              "hariko crashed: SEGV\n(.*\n)+");
  EXPECT_EXIT((report_crashes(), std::abort()), ::testing::KilledBySignal(SIGABRT), "hariko crashed: ABRT");
}

/// Each call keeps something of its own on the stack, so that the recursion cannot become a loop.
int deeper(volatile char* before, int depth) {
  volatile char own[4096];
  own[0] = *before;
  return depth == 0 ? own[0] : deeper(own, depth - 1) + own[0];
}

TEST(CrashReportDeathTest, ReportsAnOverflownStack) {
  volatile char start = 0;
  EXPECT_EXIT((report_crashes(), static_cast<void>(deeper(&start, 1 << 24))),
              ::testing::KilledBySignal(SIGSEGV), "hariko crashed: SEGV");
}

}  // namespace
}  // namespace hariko
