// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include <time.h>

namespace limn::test {

/// Processor time that the calling thread has taken, ms. What else the machine does is not in it, nor what
/// other threads do for this one.
inline double threadMs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Whether times count: in `./dev bench` alone, which sets LIMN_BENCH and runs nothing beside it. What a test
/// draws only to take its time may be small elsewhere.
inline bool isTimeJudged() {
  return std::getenv("LIMN_BENCH") != nullptr;
}

/// Prints a time on the clock and its bound. Only `./dev bench` fails where the bound is exceeded: a busy
/// machine must fail no test.
inline void judgeMs(const std::string& what, double ms, double mostMs) {
  std::printf("time: %s: %.1f ms of at most %.0f\n", what.c_str(), ms, mostMs);
  if (isTimeJudged()) {
    EXPECT_LE(ms, mostMs) << what;
  }
}

} // namespace limn::test
