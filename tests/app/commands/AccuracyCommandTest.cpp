// SPDX-License-Identifier: GPL-3.0-or-later
// `limn accuracy` on real volumes: the shape of its report, and a chosen point measured again from scratch by
// other calls of the program.
#include "accuracy/ImageError.h"
#include "support/Places.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"
#include "support/TestData.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <sstream>

namespace limn {
namespace {

using Json = nlohmann::json;

Json jsonIn(const std::filesystem::path& path) {
  std::ifstream file(path);
  return Json::parse(file);
}

Image exrIn(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input)
    throw std::runtime_error("no picture " + path.string());
  Image image(glm::ivec2(input->spec().width, input->spec().height));
  input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, image.pixels.data());
  return image;
}

class AccuracyCommand : public testing::TestWithParam<const char*> {
protected:
  int run(const std::string& arguments) { return test::runProgram(folder.path(), arguments).status; }

  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  // The volume with its preset, model and size as arguments.
  std::string sourceOf(const Json& expected) const {
    // A file stands beside what is expected of it: built-in presets change.
    std::string preset = expected["preset"];
    if (preset.ends_with(".json"))
      preset = (test::sourceFolder() / "tests/accuracy/expectations" / preset).string();
    std::ostringstream words;
    words << "'" << (test::sharedFolder() / expected["volume"]).string() << "' --model "
          << expected["model"].get<std::string>() << " --size " << expected["size"][0] << "x"
          << expected["size"][1] << " --quiet";
    if (!preset.empty())
      words << " --preset '" << preset << "'";
    return words.str();
  }

  test::TemporaryFolder folder;
};

bool isOfFamily(const Json& point, const Json& family) {
  for (const auto& [key, value] : family.items())
    if (point[key] != value)
      return false;
  return point["tolerance_levels"].is_null();
}

// The mean error falls with every halving of the step, far enough. What the exact picture itself is uncertain
// by cannot be told from nothing (DEFINITION section 9): there it has only to stay.
void expectMonotone(const Json& report, const Json& expected) {
  const double least = report["reference"]["least_mean"];
  double before = std::numeric_limits<double>::infinity();
  for (const double step : expected["steps_voxels"]) {
    const Json* found = nullptr;
    for (const Json& point : report["points"])
      if (isOfFamily(point, expected["monotone_family"]) && point["step_voxels"] == step)
        found = &point;
    ASSERT_TRUE(found) << "no point at step " << step;
    const double mean = (*found)["mean"];
    std::cout << "step " << step << ": mean " << mean << ", 99.9 % " << (*found)["p99_9"] << "\n";
    EXPECT_TRUE(mean < before || mean < least) << "step " << step << ": not below " << before;
    before = std::max(mean, least);
  }
  EXPECT_LT(before, expected["finest_mean_below_levels"].get<double>());
}

// The fastest point of the ray caster with equal steps that stays within so many levels.
Json fastestOf(const Json& report, double levels) {
  Json best;
  for (const Json& point : report["points"]) {
    const bool canBeDrawnByCommand = point["engine"] == "gl" && point["image_scale"] == 1.0 &&
                                     point["gradients"] == "on_the_fly" &&
                                     point["tolerance_levels"].is_null();
    if (canBeDrawnByCommand && point["p99_9"] <= levels &&
        (best.is_null() || point["ms"]["median"] < best["ms"]["median"]))
      best = point;
  }
  return best;
}

TEST_P(AccuracyCommand, reportsAnErrorThatFallsAndPointsThatKeepTheirBound) {
  const Json expected = jsonIn(test::sourceFolder() / "tests/accuracy/expectations" / GetParam());
  LIMN_NEEDS_SHARED(expected["volume"].get<std::string>());
  ASSERT_EQ(run("accuracy " + sourceOf(expected) + " -o '" + file("report") + "'"), 0);
  for (const char* name : {"accuracy.csv", "accuracy.png", "accuracy.html"})
    EXPECT_GT(std::filesystem::file_size(folder.path() / "report" / name), 500u) << name;
  const Json report = jsonIn(folder.path() / "report" / "accuracy.json");
  ASSERT_TRUE(report["reference"]["converged"]);
  EXPECT_LE(report["reference"]["last_change_levels"], 0.15);
  expectMonotone(report, expected);
  int best = 0;
  for (const Json& point : report["points"])
    best += point["pareto"] == true ? 1 : 0;
  EXPECT_GT(best, 0);

  // A scene file with the point's settings, drawn by the program, against double precision at a fixed step.
  ASSERT_EQ(run("render " + sourceOf(expected) + " -o '" + file("scene.png") + "'"), 0);
  const auto drawn = [&](Json quality, const std::string& engine, const std::string& name) {
    const auto picture = OIIO::ImageInput::open(file("scene.png"));
    Json scene = Json::parse(picture->spec().get_string_attribute("ImageDescription"));
    scene["volume"] = (test::sharedFolder() / expected["volume"]).string();
    for (const auto& [key, value] : quality.items())
      scene["quality"][key] = value;
    std::ofstream(file("scene.json")) << scene;
    EXPECT_EQ(run("render '" + file("scene.json") + "' --engine " + engine + " -o '" + file(name) + "'"), 0);
    return exrIn(file(name));
  };
  const Image exact =
      drawn({{"step_voxels", 1.0 / 128}, {"early_termination", 1.0}}, "reference", "exact.exr");
  for (const double levels : expected["within_levels"]) {
    const Json point = fastestOf(report, levels);
    ASSERT_FALSE(point.is_null()) << "none within " << levels;
    const Image picture = drawn({{"step_voxels", point["step_voxels"]},
                                 {"early_termination", point["early_termination"]},
                                 {"preintegrated", point["preintegrated"] == true ? "always" : "never"}},
                                "gl", "point.exr");
    const double error = imageError(picture, exact).p99_9;
    std::cout << "within " << levels << ": step " << point["step_voxels"] << ", reported " << point["p99_9"]
              << ", measured again " << error << "\n";
    // A fixed step of 1/128 is itself off by what its halvings still change: a twentieth of the bound.
    EXPECT_LE(error, 1.05 * levels);
  }
}

INSTANTIATE_TEST_SUITE_P(RealVolumes, AccuracyCommand,
                         testing::Values("ct_head.json", "mr_head.json", "bonsai.json"));

} // namespace
} // namespace limn
