// SPDX-License-Identifier: GPL-3.0-or-later
#include "Attempt.h"

#include "support/FileBytes.h"
#include "support/JudgedTime.h"
#include "support/Places.h"
#include "support/TemporaryFolder.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include <signal.h>
#include <sys/wait.h>

namespace limn::test {
namespace {

// Damaged copies of each format in the test command; `limn_malformed_table` tries any number.
constexpr int mutationsPerFormat = 300;
constexpr std::uint32_t mutationSeed = 20251;

class Malformed : public testing::TestWithParam<Format> {};

std::string testName(const testing::TestParamInfo<Format>& info) {
  std::string name = info.param.name;
  name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == ' ' || c == ','; }),
             name.end());
  return name;
}

void requireData(const Format& format) {
  if (std::string(format.name) == "DICOM, odd")
    LIMN_NEEDS_SHARED("data/odd_dicom");
}

TEST_P(Malformed, inputBecomesTheVolumeOrAWarningOrOneSentence) {
  requireData(GetParam());
  if (IsSkipped())
    return;
  const FormatReport report = triedFormat(GetParam());
  EXPECT_FALSE(report.rows.empty());
  judgeMs("the longest opening of " + report.format, 1e3 * report.worstSeconds, 1e3 * longestSeconds);
  for (const std::string& failure : report.failures)
    ADD_FAILURE() << failure;
}

TEST_P(Malformed, randomDamageDoesNoHarm) {
  requireData(GetParam());
  if (IsSkipped())
    return;
  const FormatReport report = triedMutations(GetParam(), mutationsPerFormat, mutationSeed);
  EXPECT_GE(report.rows.size(), mutationsPerFormat / 2u);
  for (const std::string& failure : report.failures)
    ADD_FAILURE() << failure;
}

// The exit status of `limn info` and what it wrote as its complaint; libpng adds a line of its own.
std::pair<int, std::string> infoOf(const std::filesystem::path& path,
                                   const std::filesystem::path& complaint) {
  const std::string command = test::programPath() + " info '" + path.string() +
                              "' --json --quiet >/dev/null 2>'" + complaint.string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytesOfFile(complaint)};
}

TEST_P(Malformed, theProgramSaysByItsExitStatus) {
  const TemporaryFolder folder;
  Corpus corpus(folder.path());
  GetParam().addInputs(corpus);
  constexpr int mostRefused = 3;
  int refused = 0;
  for (const MalformedInput& input : corpus.inputs()) {
    const bool isRefused = input.allowed == Outcomes{Outcome::refused};
    if (input.flaw != "sound" && (!isRefused || ++refused > mostRefused))
      continue;
    const auto [status, complaint] = infoOf(input.path, folder.path() / "complaint");
    EXPECT_EQ(status, isRefused ? 3 : 0) << input.path << complaint;
    EXPECT_EQ(complaint.find(".\n") != std::string::npos, isRefused) << input.path << complaint;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Malformed, testing::ValuesIn(formats()), testName);

TEST(MalformedJudge, knowsOneSentence) {
  EXPECT_TRUE(isOneSentence("Cannot read a.nii: it ends after 2.5 MiB; copy it again."));
  EXPECT_FALSE(isOneSentence("Cannot read a.nii. Copy it again."));
  EXPECT_FALSE(isOneSentence("Cannot read a.nii"));
  EXPECT_FALSE(isOneSentence("Cannot read\na.nii."));
  EXPECT_FALSE(isOneSentence(std::string(1000, 'a').append(".")));
  EXPECT_FALSE(isOneSentence(""));
}

TEST(MalformedJudge, seesACrashAHangAndTheMemory) {
  EXPECT_TRUE(inChild([](const auto& say) { say("well"); }).isWell);
  // A sanitizer's handler would turn the signal into an exit.
  const ChildEnd crash = inChild([](const auto&) {
    signal(SIGSEGV, SIG_DFL);
    raise(SIGSEGV);
  });
  EXPECT_EQ(crash.how, "killed by signal 11");
  EXPECT_EQ(inChild(
                [](const auto&) {
                  for (volatile bool on = true; on;) {
                  }
                },
                1)
                .how,
            "took longer than 1 s");
  const std::uint64_t base = inChild([](const auto&) {}).peakBytes;
  const ChildEnd filled = inChild([](const auto& say) {
    const std::string bytes(64 << 20, 'x');
    say(bytes.substr(0, 1));
  });
  EXPECT_GE(filled.peakBytes, base + (64u << 20) - (1u << 20));
}

} // namespace
} // namespace limn::test
