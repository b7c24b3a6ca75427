// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

// Pictures of physical light by the built program, as a user asks for them.
namespace limn {
namespace {

using nlohmann::json;
using test::Outcome;

class PathCommand : public testing::Test {
protected:
  Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }

  // A scene of the phantom with an end of its own.
  std::string sceneUntil(const std::string& until) const {
    const std::string file = path("scene.json");
    std::ofstream(file) << R"({"limn_scene": 1, "volume": "volume.nrrd", "image": {"width": 40, "height": 30},
                               "transfer_function": {"points": [{"value": 50, "opacity": 0, "color": [0.9, 0.7, 0.6]},
                                                                {"value": 200, "opacity": 0.7, "color": [1, 0.9, 0.8]}]},
                               "shading": {"model": "physical", "physical": {"until": )" +
                               until + "}}}";
    return file;
  }

  // A ball of 250 in air, 12 voxels wide.
  void SetUp() override {
    std::ofstream file(path("volume.nrrd"), std::ios::binary);
    file << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 16 16 16\nspacings: 4 4 4\nencoding: raw\n\n";
    for (int k = 0; k < 16; ++k)
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i) {
          const double x = i - 7.5, y = j - 7.5, z = k - 7.5;
          file.put(static_cast<char>(x * x + y * y + z * z < 36.0 ? 250 : 0));
        }
  }

  test::TemporaryFolder folder;
};

TEST_F(PathCommand, oneSeedGivesTheSameBytesWithAnyNumberOfThreads) {
  const std::string scene = sceneUntil(R"({"paths": 24})");
  for (const char* threads : {"1", "2", "7"})
    ASSERT_EQ(run("render " + scene + " --threads " + threads + " -o " + path(threads) + ".png").status, 0);
  const std::string one = test::bytesOfFile(path("1.png"));
  EXPECT_EQ(test::bytesOfFile(path("2.png")), one);
  EXPECT_EQ(test::bytesOfFile(path("7.png")), one);
  // The picture is a scene that draws itself again.
  ASSERT_EQ(run("render " + path("1.png") + " -o " + path("again.png")).status, 0);
  EXPECT_EQ(readBytes(path("again.png")).bytes, readBytes(path("1.png")).bytes);
}

TEST_F(PathCommand, jsonTellsPathsAndTheirError) {
  const Outcome outcome = run("render " + sceneUntil(R"({"paths": 32})") + " --json -o " + path("a.png"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json error = json::parse(outcome.out)["error"];
  EXPECT_EQ(error["kind"], "standard error");
  EXPECT_EQ(error["paths"], 32);
  EXPECT_GT(error["rms_levels"].get<double>(), 0.0);
  EXPECT_GT(error["p99_9_levels"].get<double>(), error["rms_levels"].get<double>());
  EXPECT_GT(error["seconds"].get<double>(), 0.0);
  EXPECT_NE(outcome.err.find("32 paths a pixel"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("instead"), std::string::npos) << "nobody chose another engine: " << outcome.err;
}

TEST_F(PathCommand, noiseIsFilteredOnDemandAndWhatIsLeftOfItIsSaid) {
  const std::string scene = sceneUntil(R"({"paths": 16})");
  ASSERT_EQ(run("render " + scene + " -o " + path("a.exr")).status, 0);
  const Outcome outcome = run("render " + scene + " --filter-noise --json -o " + path("b.exr"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json error = json::parse(outcome.out)["error"];
  EXPECT_EQ(error["kind"], "estimate");
  EXPECT_GT(error["rms_levels"].get<double>(), 0.0);
  EXPECT_NE(outcome.err.find("16 paths a pixel whose noise was filtered"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("standard error"), std::string::npos)
      << "of the picture before: " << outcome.err;
  EXPECT_NE(readExr(path("a.exr")).pixels, readExr(path("b.exr")).pixels);
  EXPECT_EQ(readExr(path("a.exr"), ExrLayer::radiance).pixels,
            readExr(path("b.exr"), ExrLayer::radiance).pixels)
      << "radiance stays as paths found it";
  // The picture is a scene that draws itself again.
  ASSERT_EQ(run("render " + path("b.exr") + " -o " + path("again.exr")).status, 0);
  EXPECT_EQ(readExr(path("again.exr")).pixels, readExr(path("b.exr")).pixels);
  const Outcome other = run("render " + scene + " --model classic --filter-noise -o " + path("c.png"));
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("--filter-noise filters pictures of random paths"), std::string::npos)
      << other.err;
}

TEST_F(PathCommand, pathsGoOnUntilTheErrorOrTheTimeIsReached) {
  const Outcome levels = run("render " + sceneUntil(R"({"levels": 2})") + " --json -o " + path("a.png"));
  ASSERT_EQ(levels.status, 0) << levels.err;
  const json error = json::parse(levels.out)["error"];
  EXPECT_LE(error["rms_levels"].get<double>(), 2.0);
  EXPECT_GT(error["rms_levels"].get<double>(), 1.0) << "far more paths than that takes";
  const Outcome seconds = run("render " + sceneUntil(R"({"seconds": 0.5})") + " --json -o " + path("b.png"));
  ASSERT_EQ(seconds.status, 0) << seconds.err;
  EXPECT_GE(json::parse(seconds.out)["error"]["paths"].get<int>(), 4);
  // What was drawn is written down, not for how long.
  const json written = json::parse(readImageDescription(path("b.png")));
  EXPECT_EQ(written["shading"]["physical"]["until"]["paths"], json::parse(seconds.out)["error"]["paths"]);
}

TEST_F(PathCommand, exrKeepsTheRadianceBesideTheDisplayColours) {
  const std::string scene = sceneUntil(R"({"paths": 8})");
  ASSERT_EQ(run("render " + scene + " -o " + path("a.exr")).status, 0);
  const Image picture = readExr(path("a.exr"));
  const Image radiance = readExr(path("a.exr"), ExrLayer::radiance);
  ASSERT_EQ(picture.size, glm::ivec2(40, 30));
  int lit = 0;
  for (std::size_t n = 0; n < picture.pixels.size(); ++n)
    // Encoded values lie above linear ones, where no channel is so bright that the knee dims them all.
    if (const glm::vec4& light = radiance.pixels[n]; light.a > 0.9f && light.g > 0.01f && light.r < 0.7f) {
      ++lit;
      EXPECT_GT(picture.pixels[n].g, light.g);
    }
  EXPECT_GT(lit, 20);
  ASSERT_EQ(run("render " + scene + " --model classic -o " + path("b.exr")).status, 0);
  EXPECT_THROW(readExr(path("b.exr"), ExrLayer::radiance), std::exception)
      << "nothing but physical light has one";
}

TEST_F(PathCommand, accuracyIsTheErrorOverPathsWithItsOwnLaw) {
  const std::string scene = sceneUntil(R"({"paths": 1})");
  const Outcome outcome =
      run("accuracy " + scene + " --quick --within 1 --at-most-ms 1000 -o " + path("report"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::ifstream file(path("report") + "/accuracy.json");
  const json report = json::parse(file);
  EXPECT_EQ(report["reference"]["standard_error"], true);
  std::vector<int> paths;
  double last = 255.0, ms = 0.0;
  for (const json& point : report["points"]) {
    paths.push_back(point["paths"]);
    EXPECT_TRUE(point["step_voxels"].is_null());
    EXPECT_LT(point["rms"].get<double>(), last);
    EXPECT_GE(point["ms"]["median"].get<double>(), ms);
    last = point["rms"];
    ms = point["ms"]["median"];
  }
  EXPECT_EQ(paths, (std::vector<int>{4, 8, 16, 32}));
  EXPECT_NE(outcome.out.find("the law of chance is −0.5"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("takes 16 times as many paths and as long: 512 paths"), std::string::npos);
  // Both wishes are answered by the law.
  EXPECT_NE(outcome.out.find("By the law of 1/√n"), outcome.out.rfind("By the law of 1/√n"));
  EXPECT_NE(outcome.out.find("and lie within 1.00 levels"), std::string::npos) << outcome.out;
  // Reports are joined as others are.
  EXPECT_EQ(run("accuracy --join " + path("report") + " -o " + path("joined")).status, 0);
  EXPECT_EQ(run("accuracy " + scene + " --engine gl -o " + path("other")).status, 2);
}

TEST_F(PathCommand, aFigureSaysPathsAndError) {
  const Outcome outcome =
      run("figure " + sceneUntil(R"({"paths": 8})") + " --model physical --size 300px -o " + path("f.png"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("after 8 paths a pixel"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("--tolerance"), std::string::npos) << "no step mends it";
}

TEST_F(PathCommand, theHelpOfTurntablesNamesPhysicalLight) {
  const Outcome help = run("turntable --help");
  EXPECT_NE(help.out.find("physical"), std::string::npos) << help.out;
}

TEST_F(PathCommand, aPictureKeepsItsStandardError) {
  ASSERT_EQ(run("render " + sceneUntil(R"({"paths": 8})") + " -o " + path("a.png")).status, 0);
  const json written = json::parse(readImageDescription(path("a.png")));
  EXPECT_GT(written["accuracy"]["within_levels"].get<double>(), 0.0);
  EXPECT_GT(written["accuracy"]["rms_levels"].get<double>(), 0.0);
  EXPECT_EQ(written["accuracy"]["paths"], 8);
  EXPECT_FALSE(written["accuracy"].contains("filter_rms_levels"));
  EXPECT_NE(written["accuracy"]["statement"].get<std::string>().find("after 8 paths a pixel"),
            std::string::npos);
}

TEST_F(PathCommand, aFilteredPictureKeepsWhatIsLeftAndWhatTheFilterChanged) {
  ASSERT_EQ(run("render " + sceneUntil(R"({"paths": 16})") + " --filter-noise -o " + path("a.png")).status,
            0);
  const json accuracy = json::parse(readImageDescription(path("a.png")))["accuracy"];
  EXPECT_FALSE(accuracy.contains("within_levels")) << "not known";
  EXPECT_EQ(accuracy["paths"], 16);
  EXPECT_GT(accuracy["rms_levels"].get<double>(), 0.0);
  EXPECT_GT(accuracy["filter_rms_levels"].get<double>(), 0.0);
  EXPECT_GT(accuracy["filter_largest_levels"].get<double>(), accuracy["filter_rms_levels"].get<double>());
}

TEST_F(PathCommand, whoFollowsNoPathsRefusesInASentence) {
  const std::string scene = sceneUntil(R"({"paths": 1})");
  for (const char* engine : {"gl", "slices", "reference"}) {
    const Outcome outcome = run("render " + scene + " --engine " + engine + " -o " + path("a.png"));
    EXPECT_EQ(outcome.status, 2) << engine << " " << outcome.err;
    EXPECT_NE(outcome.err.find("physical light"), std::string::npos) << outcome.err;
  }
  const Outcome outcome = run("render " + scene + " --engine auto -o " + path("a.png"));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find(" on CPU engine"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("OpenGL"), std::string::npos) << "nobody asked for it: " << outcome.err;
  EXPECT_EQ(run("render " + sceneUntil(R"({"paths": 0})") + " -o " + path("a.png")).status, 3);
}

} // namespace
} // namespace limn
