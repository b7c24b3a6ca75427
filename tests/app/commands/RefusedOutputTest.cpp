// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>

// Output that cannot be written is refused before the work: here the volume is not even looked for.
namespace limn {
namespace {

using test::Outcome;

class RefusedOutput : public testing::Test {
protected:
  void SetUp() override { test::writeBytes(file("taken"), "a file"); }

  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  // What is said of the output, in one sentence.
  std::string refusal(const std::string& arguments, int status, const std::string& before = {}) const {
    const Outcome outcome = test::runProgram(home.path(), arguments, before);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.find("nowhere.nii"), std::string::npos) << "it was read first: " << outcome.err;
    EXPECT_EQ(test::entriesOf(folder.path()), 1u) << arguments << " left something behind";
    return outcome.err;
  }

  test::TemporaryFolder home, folder;
};

TEST_F(RefusedOutput, ofAFileWhoseFolderIsMissingComesBeforeTheWork) {
  for (const char* command :
       {"render nowhere.nii -o '%/a.png'", "render nowhere.nii -o a.png --samples-spent '%/a.png'",
        "figure nowhere.nii -o '%/a.pdf'", "surface nowhere.nii --value 300 -o '%/a.stl'",
        "surface nowhere.nii --value 300 --value 400 -o '%/a.ply'", "turntable nowhere.nii -o '%/a.mp4'",
        "presets convert 'CT bone' '%/a.vp' --for nowhere.nii", "bench --scale --page '%/a.html'",
        "nowhere.nii --screenshot '%/a.png'"}) {
    std::string arguments = command;
    arguments.replace(arguments.find('%'), 1, file("missing"));
    EXPECT_NE(refusal(arguments, 1).find("there is no folder " + file("missing")), std::string::npos)
        << command;
  }
}

TEST_F(RefusedOutput, ofAFolderThatCannotBeMadeComesBeforeTheWork) {
  for (const char* command : {"accuracy nowhere.nii", "dicom nowhere.nii", "turntable nowhere.nii",
                              "stability", "accuracy --join nowhere.nii"})
    for (const char* below : {"taken", "taken/below"})
      EXPECT_NE(refusal(std::string(command) + " -o '" + file(below) + "'", 1)
                    .find("The folder " + file(below) + " cannot be made (Not a directory)"),
                std::string::npos)
          << command;
  EXPECT_NE(refusal("bench nowhere.nii --pictures '" + file("taken") + "'", 1).find("cannot be made"),
            std::string::npos);
}

TEST_F(RefusedOutput, makesNoFolderWhereTheVolumeIsRefused) {
  const Outcome outcome =
      test::runProgram(home.path(), "accuracy nowhere.nii -o '" + file("reports/of/today") + "'");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(test::entriesOf(folder.path()), 1u);
}

TEST_F(RefusedOutput, anEmptyFolderIsTheCurrentOne) {
  for (const char* command : {"accuracy", "dicom", "turntable"}) {
    const Outcome outcome = test::runProgram(home.path(), std::string(command) + " nowhere.nii -o ''");
    EXPECT_EQ(outcome.status, 3) << command;
    EXPECT_NE(outcome.err.find("nowhere.nii"), std::string::npos) << outcome.err;
  }
}

TEST_F(RefusedOutput, ofAnEndingThatMeansNothingComesBeforeTheWork) {
  EXPECT_NE(refusal("render nowhere.nii -o '" + file("a.bmp") + "'", 2).find("use .png, .tif, .jpg or .exr"),
            std::string::npos);
  EXPECT_NE(refusal("surface nowhere.nii --value 1 -o '" + file("a.gltf") + "'", 2).find("use .stl"),
            std::string::npos);
}

TEST_F(RefusedOutput, ofATurntableWithAnotherEndingSaysWhatThereIs) {
  for (const char* name : {"t.avi", "t.GIF", "t.png"})
    EXPECT_NE(refusal("turntable nowhere.nii -o '" + file(name) + "'", 2)
                  .find("a turntable is a video with the ending .mp4, or frames in a folder"),
              std::string::npos)
        << name;
  // Whoever has such a folder means it.
  std::filesystem::remove(file("taken"));
  std::filesystem::create_directory(file("t.gif"));
  EXPECT_EQ(test::runProgram(home.path(), "turntable nowhere.nii --quiet -o '" + file("t.gif") + "'").status,
            3);
}

} // namespace
} // namespace limn
