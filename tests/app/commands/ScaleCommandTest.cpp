// SPDX-License-Identifier: GPL-3.0-or-later
// `limn bench --scale`: the smallest size alone, its figures and its page.
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limn {
namespace {

TEST(ScaleCommand, countsTheWorkOfRanksAndShowsTheArithmetic) {
  const test::TemporaryFolder folder;
  const std::string page = (folder.path() / "scale.html").string();
  const test::Outcome outcome =
      test::runProgram(folder.path(), "bench --scale --largest 128 --frames 1 --engine cpu --quiet --json "
                                      "--page '" +
                                          page + "'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto ranks = nlohmann::json::parse(outcome.out)["ranks"];
  ASSERT_EQ(ranks.size(), 4u);
  const double samples = ranks[0]["samples"];
  for (int row = 0; row < 4; ++row) {
    const int count = 1 << row;
    EXPECT_EQ(ranks[row]["ranks"], count);
    // Every rank but one sends a picture of 512 x 512 pixels in four floats.
    EXPECT_DOUBLE_EQ(ranks[row]["reduced_mb"], (count - 1) * 512 * 512 * 16 / 1e6);
    EXPECT_GE(ranks[row]["most_samples"].get<double>() * count, ranks[row]["samples"].get<double>());
    // Each sample belongs to one rank; where a rank alone finds its part empty, it takes fewer.
    EXPECT_LE(ranks[row]["samples"].get<double>(), samples);
    EXPECT_GT(ranks[row]["samples"].get<double>(), 0.8 * samples);
  }
  const std::string text = test::bytesOfFile(page);
  for (const char* word : {"<h2>With the voxels</h2>", "<h2>With the ranks</h2>", "⌈log₂ 1000⌉ = 10 messages",
                           "a picture is made soonest"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
}

} // namespace
} // namespace limn
