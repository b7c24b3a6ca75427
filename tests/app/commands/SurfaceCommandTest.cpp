// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/FileBytes.h"
#include "support/ProgramRun.h"
#include "support/ShortVolume.h"
#include "support/TemporaryFolder.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

// `limn surface`, as a user types it.

namespace limn {
namespace {

using test::Outcome;

class SurfaceCommand : public testing::Test {
protected:
  Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return test::runProgram(home.path(), "surface " + arguments, before);
  }
  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  test::TemporaryFolder home, folder;
};

TEST_F(SurfaceCommand, writesTheSkullAndTellsItsDistance) {
  const Outcome outcome = run("phantom:4 --value 300 -o " + file("skull.stl"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("skull.stl: value 300\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("watertight every edge is used twice"), std::string::npos);
  EXPECT_NE(outcome.out.find("mm (mean"), std::string::npos);
  EXPECT_NE(outcome.err.find("millimetres in patient axes (LPS)"), std::string::npos);
  EXPECT_GT(test::bytesOfFile(file("skull.stl")).size(), 100'000u);
}

TEST_F(SurfaceCommand, tellsTheSameAsJson) {
  const Outcome outcome = run("phantom:4 --value 300 --value -300 --tolerance 0.5 --finer 2 --smallest 100 "
                              "--crop 0,0,0,1,1,0.6 --keep body --json --quiet -o " +
                              file("head.obj"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto told = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(told.at("unit"), "mm");
  EXPECT_EQ(told.at("axes"), "LPS");
  ASSERT_EQ(told.at("surfaces").size(), 2u);
  const auto& skin = told.at("surfaces").at(1);
  EXPECT_EQ(skin.at("value"), -300.0);
  EXPECT_EQ(skin.at("file"), "head.obj");
  EXPECT_TRUE(skin.at("watertight").get<bool>());
  EXPECT_LT(skin.at("triangles"), skin.at("triangles_before"));
  EXPECT_EQ(skin.at("distance_mm").at("mesh_to_surface").at("points"), 200'000);
  const double largest = skin.at("distance_mm").at("largest");
  EXPECT_GT(largest, 0.0);
  // The phantom's ellipsoid of skin, 74 × 95 × 105 mm, is cut at 60 % of its height.
  EXPECT_GT(skin.at("volume_mm3"), told.at("surfaces").at(0).at("volume_mm3"));
}

TEST_F(SurfaceCommand, isTheSameEachTime) {
  const std::string arguments = "phantom:6 --value 300 --tolerance 0.5 --quiet -o ";
  ASSERT_EQ(run(arguments + file("one.ply")).status, 0);
  ASSERT_EQ(run(arguments + file("two.ply")).status, 0);
  EXPECT_EQ(test::bytesOfFile(file("one.ply")), test::bytesOfFile(file("two.ply")));
}

TEST_F(SurfaceCommand, refusesInOneSentence) {
  const auto refusal = [this](const std::string& arguments, int status) {
    const Outcome outcome = run("phantom:8 --quiet " + arguments);
    EXPECT_EQ(outcome.status, status) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(test::entriesOf(folder.path()), 0u) << arguments;
    return outcome.err;
  };
  EXPECT_NE(refusal("--value 30000 -o " + file("a.stl"), 3).find("choose one between them."),
            std::string::npos);
  EXPECT_NE(refusal("--value nan -o " + file("a.stl"), 3).find("choose one between them."),
            std::string::npos);
  EXPECT_NE(refusal("--value 300 --memory 1 -o " + file("a.stl"), 3).find("crop the volume"),
            std::string::npos);
  EXPECT_NE(refusal("--value 300 -o " + file("a.gltf"), 2).find("use .stl, .ply or .obj."),
            std::string::npos);
  EXPECT_NE(refusal("--value 300 --value 300 -o " + file("a.stl"), 2).find("twice"), std::string::npos);
  EXPECT_NE(refusal("--value 300 --crop 0,0,0,0,1,1 -o " + file("a.stl"), 2).find("--crop takes"),
            std::string::npos);
  refusal("-o " + file("a.stl"), 2);
  refusal("--value 300", 2);
  refusal("--value 300 -o " + file("missing/a.stl"), 1);
}

TEST_F(SurfaceCommand, leavesTheOldFileWhereTheDiskIsFull) {
  test::writeBytes(file("skull.stl"), "old");
  // No file may be larger than 40 blocks of 512 bytes.
  const Outcome outcome =
      run("phantom:6 --value 300 --quiet -o " + file("skull.stl"), "trap '' XFSZ; ulimit -f 40;");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("Cannot write"), std::string::npos) << outcome.err;
  EXPECT_EQ(test::bytesOfFile(file("skull.stl")), "old");
  EXPECT_EQ(test::entriesOf(folder.path()), 1u);
}

TEST_F(SurfaceCommand, leavesNothingBehindWhereItIsInterrupted) {
  // A second is less than this takes; the shell sees the signal that ended it (124: timeout sent one).
  const Outcome outcome =
      run("phantom:0.7 --value 300 --tolerance 0.2 --finer 2 --quiet -o " + file("skull.stl"),
          "timeout --preserve-status -s INT 1");
  EXPECT_NE(outcome.status, 0);
  EXPECT_EQ(test::entriesOf(folder.path()), 0u);
}

TEST_F(SurfaceCommand, writesAMeshOfEachLabel) {
  const auto write = [&](const std::string& name, const auto& value) {
    test::writeShorts(folder.path() / name, 9, value);
  };
  const auto isIn = [](const glm::ivec3& v, int from, int to) {
    return glm::all(glm::greaterThanEqual(v, glm::ivec3(from, 2, 2))) &&
           glm::all(glm::lessThan(v, glm::ivec3(to, 7, 7)));
  };
  write("v.nrrd", [](const glm::ivec3& v) { return 10 * v.x; });
  write("masks/liver.nrrd", [&](const glm::ivec3& v) { return isIn(v, 1, 4) ? 1 : 0; });
  write("masks/spleen.nrrd", [&](const glm::ivec3& v) { return isIn(v, 5, 8) ? 1 : 0; });
  std::ofstream(folder.path() / "masks/notes.txt") << "none";
  const Outcome outcome = run(file("v.nrrd") + " --labels " + file("masks") + " -o " + file("organ.stl"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* organ : {"liver", "spleen"}) {
    const std::string name = "organ_" + std::string(organ) + ".stl";
    EXPECT_GT(test::bytesOfFile(file(name)).size(), 84u) << name;
    EXPECT_NE(outcome.out.find(name + ": " + organ + "\n"), std::string::npos) << outcome.out;
  }
  EXPECT_NE(outcome.err.find("notes.txt is no mask and was left out."), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(file("organ.stl")));
  const auto refused = [&](const std::string& arguments) {
    const Outcome one = run(file("v.nrrd") + " " + arguments + " -o " + file("no.stl"));
    EXPECT_EQ(one.status, 2) << one.err;
    return one.err;
  };
  EXPECT_NE(refused("").find("Give --value"), std::string::npos);
  EXPECT_NE(refused("--value 3 --labels " + file("masks")).find("Give --value"), std::string::npos);
  EXPECT_NE(refused("--keep body --labels " + file("masks")).find("--keep and --crop"), std::string::npos);
}

} // namespace
} // namespace limn
