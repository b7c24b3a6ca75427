// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/privacy/Marks.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

// `limn dicom` and what it wrote, by the built program.

namespace limn {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

class DicomCommand : public testing::Test {
protected:
  void SetUp() override { test::writeMarkedSeries(folder.path() / "skull"); }

  Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }

  std::string at(const std::string& name) const { return "'" + (folder.path() / name).string() + "'"; }
  std::string bytes(const char* name) const { return test::bytesOfFile(folder.path() / name); }

  void write(const char* options = "") {
    const Outcome outcome =
        run("dicom " + at("skull") + " --model enhanced --size 40x32 --engine reference --step 0.7 " +
            options + " -o " + at("objects"));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_TRUE(fs::exists(folder.path() / "objects/look.dcm") &&
                fs::exists(folder.path() / "objects/picture.dcm"));
  }

  test::TemporaryFolder folder;
};

TEST_F(DicomCommand, whatItWroteDrawsTheSamePicture) {
  write();
  const Outcome again = run("render " + at("objects/look.dcm") + " --volume " + at("skull") +
                            " --engine reference -o " + at("look.png"));
  ASSERT_EQ(again.status, 0) << again.err;
  const Outcome first = run("render " + at("skull") + " --model enhanced --size 40x32 --engine reference" +
                            " --step 0.7 -o " + at("scene.png"));
  ASSERT_EQ(first.status, 0) << first.err;
  // Picture and the scene inside it, which names the same folder.
  EXPECT_EQ(bytes("look.png"), bytes("scene.png"));
}

TEST_F(DicomCommand, findsItsSeriesBesideIt) {
  write();
  fs::copy_file(folder.path() / "objects/look.dcm", folder.path() / "skull/look.dcm");
  const Outcome outcome = run("render " + at("skull/look.dcm") + " --size 16x16 -o " + at("a.png"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(DicomCommand, saysEachLossAndThatThePatientIsNamed) {
  const Outcome outcome = run("dicom " + at("skull") + " --model robust --size 16x16 -o " + at("objects"));
  for (const char* part : {"exponents by gradient", "background", "--anonymous leaves it out"})
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << ": " << outcome.err;
}

TEST_F(DicomCommand, namesThePatientOnlyWhereThatIsWanted) {
  std::size_t searched = 0;
  write();
  for (const char* name : {"objects/look.dcm", "objects/picture.dcm"})
    for (const char* mark : {"ZEBEDEE", "PID774411", "ACC998877", "19870615"})
      EXPECT_TRUE(test::marksIn(bytes(name), searched).contains(mark)) << mark << " in " << name;
  // Neither path nor file name, nor whom the machine belongs to.
  for (const char* name : {"objects/look.dcm", "objects/picture.dcm"})
    for (const char* word : {"/tmp", "skull", "slice", "limn-test", "SERIAL86753", "STATIONXQ", "MERCYHOLM"})
      EXPECT_EQ(bytes(name).find(word), std::string::npos) << word << " in " << name;
  write("--anonymous");
  for (const char* name : {"objects/look.dcm", "objects/picture.dcm"})
    EXPECT_EQ(test::marksIn(bytes(name), searched), std::set<std::string>{"1.2.826.99"}) << name; // UIDs stay
  const Outcome outcome = run("render " + at("objects/look.dcm") + " --volume " + at("skull") +
                              " --size 16x16 -o " + at("a.png"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(DicomCommand, refusesWhatIsNoSeries) {
  const Outcome outcome = run("dicom phantom:8 --size 16x16 -o " + at("objects"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("Only a DICOM series"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder.path() / "objects"));
}

TEST_F(DicomCommand, refusesALookOfOtherOrMissingImages) {
  write();
  const std::string render = "render " + at("objects/look.dcm") + " -o " + at("a.png");
  test::writeMarkedSeries(folder.path() / "part", 12); // of 16
  Outcome outcome = run(render + " --volume " + at("part"));
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("4 of the 16 images"), std::string::npos) << outcome.err;
  fs::create_directories(folder.path() / "none");
  outcome = run(render + " --volume " + at("none"));
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("another series"), std::string::npos) << outcome.err;
  outcome = run(render);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("--volume"), std::string::npos) << outcome.err;
  const std::string look = bytes("objects/look.dcm");
  std::ofstream(folder.path() / "objects/look.dcm", std::ios::binary) << look.substr(0, look.size() / 2);
  outcome = run(render + " --volume " + at("skull"));
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("cut off"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder.path() / "a.png"));
}

TEST_F(DicomCommand, aLookIsAPreset) {
  write();
  const std::string size = " --size 24x24 --engine reference --view left -o ";
  Outcome outcome = run("render " + at("skull") + " --preset " + at("objects/look.dcm") + size + at("a.png"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  // Curve, light and the model; the rest is the command's own.
  outcome = run("render " + at("skull") + " --model enhanced" + size + at("b.png"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

} // namespace
} // namespace limn
