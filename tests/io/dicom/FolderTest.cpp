// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"

#include "support/Openings.h"
#include "support/TestData.h"

#include <chrono>
#include <fstream>
#include <set>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

int filesIn(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::set<int> timesIn(const std::map<std::string, int>& counted) {
  std::set<int> times;
  for (const auto& [file, count] : counted)
    times.insert(count);
  return times;
}

// Two openings are told from one, even with nothing between them but what a reader does.
TEST(Openings, areCounted) {
  const TemporaryFolder folder;
  slice(1, 0.0).write(folder.path() / "a");
  Openings openings(folder.path());
  for (int i = 0; i < 3; ++i)
    parseDicom(folder.path() / "a");
  EXPECT_EQ(openings.counted(), (std::map<std::string, int>{{"a", 3}}));
  EXPECT_TRUE(openings.counted().empty());
}

TEST(DicomFolder, eachFileIsOpenedOnceForItsHeaderAndOnceForItsPixels) {
  LIMN_NEEDS_SHARED("data/mr_pd_head_dicom/brain_001.dcm");
  const fs::path folder = sharedFolder() / "data/mr_pd_head_dicom";
  Openings openings(folder);
  const auto dicom = openDicom(folder, {});
  ASSERT_NE(dicom, nullptr);
  const auto headers = openings.counted();
  EXPECT_EQ(static_cast<int>(headers.size()), filesIn(folder));
  EXPECT_EQ(timesIn(headers), std::set<int>{1});
  ASSERT_EQ(dicom->summaries().size(), 1u);
  const auto images = static_cast<std::size_t>(dicom->summaries().front().dims.z);
  EXPECT_EQ(dicom->images().front().images.size(), images);
  EXPECT_TRUE(openings.counted().empty()) << "what the headers say is known";
  EXPECT_EQ(dicom->read({}, {})->grid().dims.z, static_cast<int>(images));
  const auto pixels = openings.counted();
  EXPECT_EQ(pixels.size(), images);
  EXPECT_EQ(timesIn(pixels), std::set<int>{1});
}

TEST(DicomFolder, ofSeveralSeriesAndOtherFilesTheOthersAreOpenedForTheirHeadersAlone) {
  const TemporaryFolder folder;
  for (int k = 0; k < 6; ++k)
    slice(k + 1, k)
        .text(0x0020000E, "UI", k < 4 ? "1.2.3.4" : "1.2.3.5")
        .write(folder.path() / std::to_string(k));
  std::ofstream(folder.path() / "note.txt") << "no image";
  Openings openings(folder.path());
  const auto dicom = openDicom(folder.path(), {});
  ASSERT_EQ(dicom->summaries().size(), 2u);
  ReadOptions second;
  second.series = 2;
  EXPECT_EQ(dicom->read(second, {})->grid().dims.z, 2);
  EXPECT_EQ(openings.counted(),
            (std::map<std::string, int>{
                {"0", 1}, {"1", 1}, {"2", 1}, {"3", 1}, {"4", 2}, {"5", 2}, {"note.txt", 1}}));
}

TEST(DicomFolder, presentationStatesAreNoted) {
  const TemporaryFolder folder;
  slice(1, 0.0).write(folder.path() / "image");
  DicomBuilder state;
  state.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.11.9").text(0x00080018, "UI", "1.2.3.9");
  state.text(0x00080060, "CS", "PR").write(folder.path() / "state");
  EXPECT_EQ(openDicom(folder.path(), {})->states(), std::vector<fs::path>{folder.path() / "state"});
}

TEST(DicomFolder, aLongFolderOfSomethingElseIsNone) {
  const TemporaryFolder folder;
  for (int i = 0; i < 2001; ++i)
    std::ofstream(folder.path() / std::to_string(10000 + i)) << i;
  slice(1, 0.0).write(folder.path() / "later");
  EXPECT_EQ(openDicom(folder.path(), {}), nullptr);
  fs::rename(folder.path() / "later", folder.path() / "1");
  EXPECT_NE(openDicom(folder.path(), {}), nullptr);
}

// Cancelled as soon as it says that it reads: no more than the file in hand is read.
TEST(DicomFolder, ofFiveThousandFilesReportsAtOnceAndEndsWhenAsked) {
  const TemporaryFolder folder;
  for (int k = 0; k < 5000; ++k)
    slice(k + 1, k).write(folder.path() / std::to_string(10000 + k));
  int reports = 0;
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point told;
  progress.report = [&](double fraction, const Message&) {
    if (reports++ == 0) {
      EXPECT_EQ(fraction, 0.0);
      told = std::chrono::steady_clock::now();
    }
  };
  progress.isCancelled = [&] { return reports > 0; };
  EXPECT_THROW(openDicom(folder.path(), progress), Cancelled);
  const std::chrono::duration<double, std::milli> toReport = told - start;
  const std::chrono::duration<double, std::milli> toEnd = std::chrono::steady_clock::now() - told;
  EXPECT_EQ(reports, 1);
  EXPECT_LT(toReport.count(), 1000.0);
  EXPECT_LT(toEnd.count(), 1000.0);
  std::printf("time: 5,000 headers: first report after %.1f ms, ended %.1f ms after that\n", toReport.count(),
              toEnd.count());
}

} // namespace
} // namespace limn::test
