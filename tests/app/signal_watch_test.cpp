// Signals that ask for the end: in a child each, as they end the process.

#include "app/window/signal_watch.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

/// Exit code of a child that runs `body`; 99 when `body` returns.
int exit_code_of(const std::function<void()>& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(60);  // a child that hangs fails the test
    body();
    ::_exit(99);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

[[noreturn]] void wait_for_ever() {
  for (;;) ::pause();
}

TEST(SignalWatch, WithoutAnActionTheProgramEndsAsAShellNamesIt) {
  for (const auto& [signal, code] : {std::pair{SIGTERM, 143}, std::pair{SIGHUP, 129}, std::pair{SIGINT, 130}})
    EXPECT_EQ(exit_code_of([signal = signal] {
                const SignalWatch watch;
                ::kill(::getpid(), signal);
                wait_for_ever();
              }),
              code);
}

TEST(SignalWatch, TheActionRunsOnAnotherThreadWhileTheMainOneIsStuck) {
  const test::TemporaryFolder folder;
  const auto written = folder.path() / "written";
  EXPECT_EQ(exit_code_of([&] {
              SignalWatch watch;
              watch.set_action([&](int signal) {
                test::spill(written, std::to_string(signal));
                ::kill(::getpid(), SIGTERM);  // asked again: the main thread does not answer
              });
              ::kill(::getpid(), SIGHUP);
              wait_for_ever();
            }),
            129)
      << "the code is that of the first signal";
  EXPECT_EQ(test::slurp(written), std::to_string(SIGHUP));
}

TEST(SignalWatch, AProgramThatEndsItselfHasItsOwnCode) {
  EXPECT_EQ(exit_code_of([] {
              std::atomic<int> seen = 0;
              {
                SignalWatch watch;
                watch.set_action([&](int signal) { seen = signal; });
                ::kill(::getpid(), SIGINT);
                while (seen == 0) std::this_thread::yield();
              }
              ::_exit(seen == SIGINT ? 7 : 8);
            }),
            7);
}

TEST(SignalWatch, WhatWasIgnoredAtTheStartStaysIgnored) {
  EXPECT_EQ(exit_code_of([] {
              ::signal(SIGHUP, SIG_IGN);  // nohup
              const SignalWatch watch;
              ::kill(::getpid(), SIGHUP);
              ::kill(::getpid(), SIGTERM);
              wait_for_ever();
            }),
            143);
}

TEST(SignalWatch, AClosedSocketDoesNotEndTheProgram) {
  EXPECT_EQ(exit_code_of([] {
              const SignalWatch watch;
              ::kill(::getpid(), SIGPIPE);
            }),
            99);
}

}  // namespace
}  // namespace hariko
