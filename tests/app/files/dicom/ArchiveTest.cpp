// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dicom/Archive.h"
#include "app/privacy/Marks.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <map>

// Series, picture and look go into an archive and come back. The program itself speaks to no archive: DCMTK's
// storescu and curl do, as the guide shows.

namespace limn {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int sliceCount = 16;
constexpr const char* lookClass = "1.2.840.10008.5.1.4.1.1.11.9";
constexpr const char* pictureClass = "1.2.840.10008.5.1.4.1.1.7";

class RealArchive : public testing::Test {
protected:
  void SetUp() override {
    if (const std::string missing = test::missingForArchive(); !missing.empty())
      GTEST_SKIP() << missing;
    test::writeMarkedSeries(folder.path() / "sent/head", sliceCount);
  }

  void expectRuns(const std::string& arguments) {
    const test::Outcome outcome = test::runProgram(folder.path(), arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.err;
  }

  std::string at(const char* name) const { return "'" + (folder.path() / name).string() + "'"; }

  test::TemporaryFolder folder;
};

std::string textOf(const json& instance, const char* tag) {
  return instance.at(tag).at("Value").at(0).get<std::string>();
}

// The study that every file of the marked series is of.
std::string studyIn(const test::Archive& archive) {
  const json studies =
      json::parse(archive.get("/dicom-web/studies", "application/dicom+json"), nullptr, false);
  return studies.is_array() && studies.size() == 1 ? textOf(studies[0], "0020000D") : std::string();
}

TEST_F(RealArchive, takesSeriesPictureAndLookAndGivesThemBack) {
  expectRuns("dicom " + at("sent/head") + " --model enhanced --size 40x32 --engine reference -o " +
             at("sent/objects"));
  test::Archive archive(folder.path() / "archive");
  ASSERT_TRUE(archive.answers()) << archive.log();
  ASSERT_TRUE(archive.store(folder.path() / "sent")) << archive.log();

  // QIDO-RS: one study holds them all.
  const std::string study = studyIn(archive);
  ASSERT_NE(study, "");
  const json found = json::parse(
      archive.get("/dicom-web/studies/" + study + "/instances", "application/dicom+json"), nullptr, false);
  ASSERT_EQ(found.size(), sliceCount + 2u);
  fs::create_directories(folder.path() / "fetched/head");
  std::map<std::string, int> counts;
  for (const json& instance : found) {
    const std::string kind = textOf(instance, "00080016"), uid = textOf(instance, "00080018");
    const std::string file = kind == lookClass      ? "fetched/look.dcm"
                             : kind == pictureClass ? "fetched/picture.dcm"
                                                    : "fetched/head/" + uid;
    // WADO-RS
    const std::string bytes = archive.instance(study, textOf(instance, "0020000E"), uid);
    ASSERT_GT(bytes.size(), 132u) << uid;
    EXPECT_EQ(bytes.substr(128, 4), "DICM");
    std::ofstream(folder.path() / file, std::ios::binary) << bytes;
    ++counts[kind];
  }
  EXPECT_EQ(counts[lookClass], 1);
  EXPECT_EQ(counts[pictureClass], 1);

  // The same picture, scene and all.
  expectRuns("render " + at("sent/objects/look.dcm") + " --volume " + at("sent/head") +
             " --engine reference -o " + at("sent.png"));
  expectRuns("render " + at("fetched/look.dcm") + " --volume " + at("fetched/head") +
             " --engine reference -o " + at("fetched.png"));
  EXPECT_EQ(test::bytesOfFile(folder.path() / "fetched.png"), test::bytesOfFile(folder.path() / "sent.png"));
  const test::Outcome picture = test::runProgram(folder.path(), "info " + at("fetched/picture.dcm"));
  EXPECT_EQ(picture.status, 0) << picture.err;
  EXPECT_NE(picture.out.find("40 x 32"), std::string::npos) << picture.out;
}

} // namespace
} // namespace limn
