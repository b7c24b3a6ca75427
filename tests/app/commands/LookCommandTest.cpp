// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

// Looks of other programs, as a user converts and applies them.
namespace limn {
namespace {

using nlohmann::json;
using test::Outcome;

class LookCommand : public testing::Test {
protected:
  Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }

  std::string path(const std::string& name) const { return (folder.path() / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
  }

  json readJson(const std::string& name) const {
    return json::parse(test::bytesOfFile(folder.path() / name));
  }

  /// The sentences on stderr, a line each.
  static std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> list;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      list.push_back(line);
    return list;
  }

  test::TemporaryFolder folder;
  // A step at 40, a gradient opacity that is not constant, no light.
  const std::string vp = "1\n0\n0.8\n0.1\n0.2\n12\n6 -100 0 40 0.25 40 0.75\n4 0 0.5 20 1\n"
                         "8 -100 0.25 0 0 40 1 0.5 0.125\n";
  const std::string relative = R"([{"Name": "Relative", "RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1],
                                    "Points": [0, 0, 0.5, 0, 0.5, 0.25, 0.5, 0, 1, 1, 0.5, 0]}])";
};

TEST_F(LookCommand, everyFormatIsWrittenAndReadBackToTheSameCurve) {
  write("in.vp", vp);
  for (const char* name :
       {"a.vp.json", "a.vp", "a.xml", "a.plist", "a.paraview.json", "a.volview.json", "a.weasis.json"}) {
    const Outcome there = run("presets convert " + path("in.vp") + " " + path(name));
    ASSERT_EQ(there.status, 0) << there.err;
    EXPECT_EQ(there.out, "") << "stdout is for --json";
    ASSERT_EQ(run("presets convert " + path(name) + " " + path("back.json")).status, 0);
    const json points = readJson("back.json")["transfer_function"]["points"];
    ASSERT_GE(points.size(), 3u) << name;
    for (const auto& [index, value, opacity] :
         {std::tuple{0, -100.0, 0.0}, std::tuple{1, 40.0, 0.25}, std::tuple{2, 40.0, 0.75}}) {
      EXPECT_EQ(points[index]["value"], value) << name;
      EXPECT_EQ(points[index]["opacity"], opacity) << name;
    }
  }
}

TEST_F(LookCommand, whatIsLostIsToldAlikeOnStderrAndAsJson) {
  write("in.vp", vp);
  const Outcome outcome = run("presets convert " + path("in.vp") + " " + path("out.weasis.json") + " --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report.size(), 1u);
  std::vector<std::string> told;
  for (const json& change : report["changes"]) {
    EXPECT_EQ(change.size(), 1u);
    told.push_back("limn: " + change["what"].get<std::string>()); // as every remark on stderr starts
  }
  EXPECT_EQ(told, lines(outcome.err));
  EXPECT_GE(told.size(), 2u) << "gradient opacity is left out, and no length was said";
  EXPECT_NE(outcome.err.find("gradient opacity was left out"), std::string::npos) << outcome.err;
}

TEST_F(LookCommand, aVolumeGivesRangeAndSpacing) {
  write("in.vp", vp);
  write("relative.paraview.json", relative);
  ASSERT_EQ(run("presets convert " + path("in.vp") + " " + path("g.json") + " --for phantom:8").status, 0);
  EXPECT_EQ(readJson("g.json")["gradient_opacity"]["points"][1]["gradient"], 2.5) << "20 per voxel of 8 mm";
  const Outcome info = run("info phantom:8 --json");
  const json range = json::parse(info.out)["range"];
  ASSERT_EQ(
      run("presets convert " + path("relative.paraview.json") + " " + path("r.json") + " --for phantom:8")
          .status,
      0);
  const json points = readJson("r.json")["transfer_function"]["points"];
  EXPECT_EQ(points.front()["value"], range[0]);
  EXPECT_EQ(points.back()["value"], range[1]);
}

TEST_F(LookCommand, ofSeveralLooksOneIsChosenByName) {
  const json map = json::parse(relative)[0];
  json second = map;
  second["Name"] = "Second";
  second["Points"] = {0, 0.5, 0.5, 0, 1, 0.5, 0.5, 0};
  write("two.json", json::array({map, second}).dump());
  const Outcome first = run("presets convert " + path("two.json") + " " + path("a.json"));
  EXPECT_EQ(readJson("a.json")["name"], "Relative");
  EXPECT_NE(first.err.find("Of its 2 looks the first, \"Relative\", was taken."), std::string::npos)
      << first.err;
  EXPECT_EQ(run("presets convert " + path("two.json") + " " + path("b.json") + " --look Second").status, 0);
  EXPECT_EQ(readJson("b.json")["name"], "Second");
  const Outcome none = run("presets convert " + path("two.json") + " " + path("c.json") + " --look Third");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("Relative, Second"), std::string::npos) << none.err;
  EXPECT_FALSE(std::filesystem::exists(path("c.json")));
}

TEST_F(LookCommand, aPictureThatWasDrawnIsALook) {
  ASSERT_EQ(run("render phantom:8 --preset \"CT skin\" --size 32x24 -o " + path("look.png")).status, 0);
  const Outcome outcome = run("presets convert " + path("look.png") + " " + path("look.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("its view, quality and background were not"), std::string::npos) << outcome.err;
  const json preset = readJson("look.json"), drawn = json::parse(readImageDescription(path("look.png")));
  EXPECT_EQ(preset["name"], "look");
  EXPECT_EQ(preset["transfer_function"], drawn["transfer_function"]);
}

TEST_F(LookCommand, aPresetIsConvertedByItsName) {
  ASSERT_EQ(run("presets convert \"CT bone\" " + path("bone.vp.json")).status, 0);
  EXPECT_EQ(readJson("bone.vp.json")["volumeProperties"].size(), 1u);
}

TEST_F(LookCommand, aPresetThatMovesWithItsDataIsFittedToTheVolume) {
  // The phantom's air lies at -1000 and its brightest far above that of an MR scan.
  const Outcome outcome =
      run("presets convert \"MR skull-stripped brain\" " + path("brain.json") + " --for phantom:8");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("fitted to the volume's values"), std::string::npos) << outcome.err;
  ASSERT_EQ(run("presets convert \"MR skull-stripped brain\" " + path("own.json")).status, 0);
  EXPECT_NE(readJson("brain.json")["transfer_function"], readJson("own.json")["transfer_function"]);
}

TEST_F(LookCommand, badInputIsOneSentenceAndLeavesNothing) {
  write("cut.vp", vp.substr(0, 60));
  write("foreign.json", "{\"a\": 1}");
  write("nan.vp", "1\n1\n1\n1\n1\n1\n4 0 nan 1 1\n\n8 0 0 0 0 1 1 1 1\n");
  write("empty.vp", "");
  for (const char* name :
       {"cut.vp", "foreign.json", "nan.vp", "empty.vp", "missing.vp.json", "missing.txt"}) {
    const Outcome outcome = run("presets convert " + path(name) + " " + path("out.json") + " --json");
    EXPECT_EQ(outcome.status, 3) << name << " " << outcome.err;
    EXPECT_EQ(lines(outcome.err).size(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(path("out.json")));
  }
  write("in.vp", vp);
  write("kept.vp.json", "before");
  EXPECT_EQ(run("presets convert " + path("cut.vp") + " " + path("kept.vp.json")).status, 3);
  EXPECT_EQ(test::bytesOfFile(folder.path() / "kept.vp.json"), "before");
  const Outcome ending = run("presets convert " + path("in.vp") + " " + path("out.txt"));
  EXPECT_EQ(ending.status, 2);
  EXPECT_NE(ending.err.find(".vp.json"), std::string::npos) << ending.err;
  EXPECT_EQ(run("presets convert " + path("in.vp")).status, 2);
}

TEST_F(LookCommand, aFileShowsAVolumeWhereAPresetIsTaken) {
  write("in.vp", vp);
  write("relative.paraview.json", relative);
  const auto drawn = [&](const std::string& arguments) {
    const Outcome outcome = run("render phantom:8 --size 32x32 " + arguments + " -o " + path("a.png"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    json drawnScene = json::parse(readImageDescription(path("a.png")));
    drawnScene["told"] = outcome.err;
    return drawnScene;
  };
  const json plain = drawn("--preset " + path("in.vp"));
  EXPECT_EQ(plain["transfer_function"]["points"][1]["opacity"], 0.25);
  EXPECT_EQ(plain["gradient_opacity"]["points"][1]["gradient"], 2.5);
  EXPECT_EQ(plain["shading"]["model"], "none") << "the look is not lit";
  EXPECT_NE(plain["told"].get<std::string>().find("voxels of 8 mm"), std::string::npos) << plain["told"];
  EXPECT_EQ(drawn("--preset " + path("in.vp") + " --model classic")["shading"]["model"], "classic");
  EXPECT_EQ(drawn("--quiet --preset " + path("in.vp"))["told"], "");
  const json stretched = drawn("--preset " + path("relative.paraview.json"));
  EXPECT_EQ(stretched["transfer_function"]["points"][0]["value"], -1000.0) << "air of the phantom";

  EXPECT_EQ(run("effects phantom:8 --size 32x32 --preset " + path("in.vp") + " --json").status, 0);
  const Outcome bench = run("bench phantom:8 --size 32x32 --frames 1 --engine cpu --json --preset " +
                            path("relative.paraview.json"));
  ASSERT_EQ(bench.status, 0) << bench.err;
  EXPECT_NE(bench.out.find("Relative"), std::string::npos) << bench.out;
  EXPECT_EQ(run("render phantom:8 --preset " + path("missing.vp") + " -o " + path("b.png")).status, 3);
  EXPECT_EQ(run("render phantom:8 --preset \"No such preset\" -o " + path("b.png")).status, 2);
}

TEST_F(LookCommand, aFileIsShownAsAPreset) {
  write("in.vp", vp);
  const Outcome outcome = run("presets show " + path("in.vp"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["limn_preset"], 1);
  EXPECT_NE(outcome.err.find("1 mm"), std::string::npos);
}

} // namespace
} // namespace limn
