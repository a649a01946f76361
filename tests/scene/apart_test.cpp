// SPDX-License-Identifier: MIT
#include "scene/apart.h"

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

std::string apart(const std::function<std::string()> &work) {
    return run_apart("scene.toml:3:1: a.obj", 100, work);
}

TEST(Apart, ReturnsEveryByte) {
    std::string bytes(300'000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(i * i / 7);
    }
    EXPECT_EQ(apart([&] { return bytes; }), bytes);
    EXPECT_EQ(apart([] { return std::string(); }), "");
}

TEST(Apart, LeavesNothingBehindAndPrintsNothing) {
    int changed = 0;
    testing::internal::CaptureStderr();
    apart([&] {
        changed = 1;
        std::cerr << "free(): invalid pointer" << std::endl;
        return std::string();
    });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(changed, 0);
}

TEST(Apart, ThrowsWhatWasThrownThere) {
    EXPECT_EQ(message_of([] { apart([]() -> std::string { throw UserError("no mesh"); }); }),
              "no mesh");
    EXPECT_THROW(apart([]() -> std::string { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(Apart, TellsOfACrash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL}) {
        EXPECT_EQ(message_of([&] {
                      apart([&] {
                          std::raise(signal);
                          return std::string();
                      });
                  }),
                  "scene.toml:3:1: a.obj: can't be read: the reader crashed (signal "
                      + std::to_string(signal) + "), expected an undamaged file");
    }
}

// Its own limits are of seconds to minutes: they are seen, then brought near.
TEST(Apart, TellsOfTooLongATime) {
    EXPECT_EQ(message_of([] {
                  apart([]() -> std::string {
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

TEST(Apart, TellsOfTooLongAWait) {
    EXPECT_EQ(message_of([] {
                  apart([]() -> std::string {
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

TEST(Apart, TakesItsTimeOnceAllowed) {
    EXPECT_EQ(apart([] {
                  allow_any_time();
                  rlimit limits{};
                  getrlimit(RLIMIT_CPU, &limits);
                  return std::to_string(alarm(0) == 0 && limits.rlim_cur == limits.rlim_max);
              }),
              "1");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they end such a program
TEST(Apart, HasHalfOfTheMemory) {
    const auto memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES))
                        * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    EXPECT_THROW(apart([&] {
                     std::string bytes;
                     bytes.reserve(memory / 2 + memory / 16);
                     return std::to_string(bytes.capacity());
                 }),
                 std::bad_alloc);
}
#endif

TEST(Apart, IsAMistakeOfOursWhenItEndsOtherwise) {
    EXPECT_THROW(apart([]() -> std::string { _exit(77); }), std::logic_error);
}

}  // namespace
}  // namespace stagelight
