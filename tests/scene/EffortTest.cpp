// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Effort.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace limn {
namespace {

TEST(Effort, doesEveryPieceOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7, 64}) {
    std::vector<int> done(50, 0);
    forEachPiece(50, {threads, {}, {}}, [&](int piece) { ++done[static_cast<std::size_t>(piece)]; });
    EXPECT_EQ(done, std::vector<int>(50, 1)) << threads;
  }
  forEachPiece(0, {}, [](int) { FAIL() << "there is none"; });
}

TEST(Effort, asksAndReportsOnTheCallersThread) {
  const std::thread::id caller = std::this_thread::get_id();
  double last = -1.0;
  const Effort effort{4,
                      [&] {
                        EXPECT_EQ(std::this_thread::get_id(), caller);
                        return false;
                      },
                      [&](double fraction) {
                        EXPECT_EQ(std::this_thread::get_id(), caller);
                        EXPECT_GE(fraction, last);
                        EXPECT_LE(fraction, 1.0);
                        last = fraction;
                      }};
  forEachPiece(1000, effort, [](int) {});
  EXPECT_GE(last, 0.0);
}

TEST(Effort, endsWithWhatAWorkerThrows) {
  for (const int threads : {1, 4})
    EXPECT_THROW(forEachPiece(100, {threads, {}, {}},
                              [](int piece) {
                                if (piece == 37)
                                  throw Error(Error::Kind::other, "this one fails");
                              }),
                 Error);
}

} // namespace
} // namespace limn
