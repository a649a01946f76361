// SPDX-License-Identifier: MIT
#include "scene/sandbox.h"

#include <csignal>
#include <iostream>
#include <new>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "scene/messages.h"

namespace stagelight {
namespace {

std::string sandboxed(const std::function<std::string()> &work) {
    return run_sandboxed("scene.toml:3:1: a.obj", 100, work);
}

TEST(Sandbox, ReturnsEveryByte) {
    std::string bytes(300'000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(i * i / 7);
    }
    EXPECT_EQ(sandboxed([&] { return bytes; }), bytes);
    EXPECT_EQ(sandboxed([] { return std::string(); }), "");
}

TEST(Sandbox, LeavesNothingBehindAndPrintsNothing) {
    int changed = 0;
    testing::internal::CaptureStderr();
    sandboxed([&] {
        changed = 1;
        std::cerr << "free(): invalid pointer" << std::endl;
        return std::string();
    });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(changed, 0);
}

TEST(Sandbox, ThrowsWhatWasThrownThere) {
    EXPECT_EQ(message_of([] { sandboxed([]() -> std::string { throw UserError("no mesh"); }); }),
              "no mesh");
    EXPECT_THROW(sandboxed([]() -> std::string { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(Sandbox, TellsOfACrash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL}) {
        EXPECT_EQ(message_of([&] {
                      sandboxed([&] {
                          std::raise(signal);
                          return std::string();
                      });
                  }),
                  "scene.toml:3:1: a.obj: can't be read: the reader crashed (signal "
                      + std::to_string(signal) + "), expected an undamaged file");
    }
}

// Its own limits are of seconds to minutes: they are seen, then brought near.
TEST(Sandbox, TellsOfTooLongATime) {
    EXPECT_EQ(message_of([] {
                  sandboxed([]() -> std::string {
                      rlimit limits{};
                      getrlimit(RLIMIT_CPU, &limits);
                      if (limits.rlim_cur != 8) {
                          throw UserError("has another limit of CPU time");
                      }
                      limits.rlim_cur = 1;
                      setrlimit(RLIMIT_CPU, &limits);
                      for (volatile bool on = true; on;) {
                      }
                      return "";
                  });
              }),
              "scene.toml:3:1: a.obj: can't be read: takes longer than 8 seconds, expected an "
              "undamaged file");
}

TEST(Sandbox, TellsOfTooLongAWait) {
    EXPECT_EQ(message_of([] {
                  sandboxed([]() -> std::string {
                      const itimerval soon{{}, {0, 10'000}};
                      itimerval patience{};
                      setitimer(ITIMER_REAL, &soon, &patience);
                      if (patience.it_value.tv_sec < 70 || patience.it_value.tv_sec > 80) {
                          throw UserError("has another limit of waiting");
                      }
                      pause();
                      return "";
                  });
              }),
              "scene.toml:3:1: a.obj: can't be read: takes longer than 80 seconds, expected an "
              "undamaged file");
}

TEST(Sandbox, TakesItsTimeOnceAllowed) {
    EXPECT_EQ(sandboxed([] {
                  allow_any_time();
                  rlimit limits{};
                  getrlimit(RLIMIT_CPU, &limits);
                  return std::to_string(alarm(0) == 0 && limits.rlim_cur == limits.rlim_max);
              }),
              "1");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they end such a program
TEST(Sandbox, HasHalfOfTheMemory) {
    const auto memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES))
                        * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    EXPECT_THROW(sandboxed([&] {
                     std::string bytes;
                     bytes.reserve(memory / 2 + memory / 16);
                     return std::to_string(bytes.capacity());
                 }),
                 std::bad_alloc);
}
#endif

TEST(Sandbox, IsAMistakeOfOursWhenItEndsOtherwise) {
    EXPECT_THROW(sandboxed([]() -> std::string { _exit(77); }), std::logic_error);
}

}  // namespace
}  // namespace stagelight
