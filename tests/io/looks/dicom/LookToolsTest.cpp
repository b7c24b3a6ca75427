// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Looks.h"

#include "stability/scenes/SimpleScenes.h"

#include <cstdlib>

#include <sys/wait.h>

// What others say of both objects: DCMTK's and GDCM's own programs read them from end to end.

namespace limn {
namespace {

namespace fs = std::filesystem;

class LookTools : public testing::Test {
protected:
  void SetUp() override {
    Scene scene = test::phantomScene();
    scene.crop.lower.z = 0.2;
    scene.shading.model = ShadingModel::classic;
    scene.keep = cubesRegion(scene.volume->grid().dims, 7, {1.0, 0.0, 0.4});
    writeDicomObjects(folder.path(), test::objectsOf(scene));
  }

  // Everything that a program prints about a file; fails where it ends badly.
  std::string saidOf(const std::string& program, const char* file) {
    const fs::path out = folder.path() / "out";
    const std::string command =
        program + " '" + (folder.path() / file).string() + "' >'" + out.string() + "' 2>&1";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command;
    return test::bytesOfFile(out);
  }

  void expectNoComplaint(const std::string& program, const char* file) {
    const std::string said = saidOf(program, file);
    EXPECT_NE(said.find("(0008"), std::string::npos) << program << " printed nothing";
    for (const char* complaint : {"W: ", "E: ", "F: ", "Warning", "Error", "error:", "Caught"})
      EXPECT_EQ(said.find(complaint), std::string::npos) << program << " on " << file << ": " << complaint;
  }

  test::TemporaryFolder folder;
};

bool isInstalled(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null").c_str()) == 0;
}

TEST_F(LookTools, dcmdumpHasNothingToSay) {
  if (!isInstalled("dcmdump"))
    GTEST_SKIP() << "dcmdump is not installed (package dcmtk)";
  for (const char* file : {"look.dcm", "picture.dcm", "segments.dcm"})
    expectNoComplaint("dcmdump -v", file);
}

TEST_F(LookTools, gdcmdumpHasNothingToSay) {
  if (!isInstalled("gdcmdump"))
    GTEST_SKIP() << "gdcmdump is not installed (package libgdcm-tools)";
  for (const char* file : {"look.dcm", "picture.dcm", "segments.dcm"})
    expectNoComplaint("gdcmdump", file);
}

} // namespace
} // namespace limn
