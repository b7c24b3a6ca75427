// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

namespace limn {
namespace {

using test::isTold;
using test::linearAt;
using test::onlyLook;

// A point with colour and light, all as texts.
std::string weasisPoint(int value, const std::string& opacity, const std::string& red,
                        const std::string& light = "0.1") {
  return R"({"intensity": ")" + std::to_string(value) + R"(", "opacity": ")" + opacity + R"(", "red": ")" +
         red + R"(", "green": "0.5", "blue": "0", "ambient": ")" + light +
         R"(", "diffuse": "0.9", "specular": "0.2"})";
}

std::string weasisClear(int value, const std::string& opacity) {
  return R"({"intensity": ")" + std::to_string(value) + R"(", "opacity": ")" + opacity + R"("})";
}

std::string weasisLook(const std::string& groups) {
  return R"([{"name": "Demo", "modality": "CT", "default": "true", "shade": "true", "specularPower": "10", "group": [)" +
         groups + "]}]";
}

std::string weasisGroup(const std::string& points) {
  return R"({"name": "Default", "point": [)" + points + "]}";
}

TEST(WeasisLook, numbersAreTextsAndPointsMayLackAColour) {
  const ReadLook look =
      onlyLook(weasisLook(weasisGroup(weasisPoint(-100, "0", "0.2") + "," + weasisClear(0, "0.8") + "," +
                                      weasisClear(100, "0.1") + "," + weasisPoint(300, "0.4", "1"))));
  const auto expected = [](double value) {
    return Classified{{linearAt({{-100, 0.2}, {300, 1.0}}, value), 0.5, 0.0},
                      linearAt({{-100, 0.0}, {0, 0.8}, {100, 0.1}, {300, 0.4}}, value)};
  };
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, expected, -200.0, 400.0), test::sameCurve);
  EXPECT_EQ(look.preset.modality, "CT");
  ASSERT_TRUE(look.preset.shading);
  EXPECT_EQ(look.preset.shading->ambient, 0.1);
  EXPECT_EQ(look.preset.shading->exponent, 10.0);
  EXPECT_EQ(look.preset.shading->reflection, Reflection::blinn);
  EXPECT_EQ(look.changes.size(), 1u) << test::allOf(look.changes); // of the length
}

TEST(WeasisLook, plainNumbersAreReadToo) {
  const ReadLook look =
      onlyLook(R"([{"name": "N", "modality": "ALL", "shade": false, "specularPower": 4, "group":
    [{"point": [{"intensity": 0, "opacity": 0, "red": 1}, {"intensity": 10, "opacity": 1, "red": 1}]}]}])");
  EXPECT_EQ(look.preset.modality, "");
  EXPECT_EQ(look.preset.shading->model, ShadingModel::none);
  EXPECT_EQ(classify(look.preset.transferFunction, 5.0).opacity, 0.5);
  EXPECT_EQ(classify(look.preset.transferFunction, 5.0).color, glm::dvec3(1, 0, 0));
}

TEST(WeasisLook, groupsFollowEachOther) {
  const ReadLook look =
      onlyLook(weasisLook(weasisGroup(weasisPoint(0, "0", "0") + "," + weasisPoint(10, "1", "0")) + "," +
                          weasisGroup(weasisPoint(30, "0", "1") + "," + weasisPoint(40, "1", "1"))));
  EXPECT_EQ(classify(look.preset.transferFunction, 20.0).opacity, 0.5);
  EXPECT_EQ(look.preset.transferFunction.points.size(), 4u);
}

TEST(WeasisLook, lightThatDiffersBecomesItsMeanByOpacity) {
  const ReadLook look = onlyLook(weasisLook(
      weasisGroup(weasisPoint(0, "0.25", "0", "0.1") + "," + weasisPoint(10, "0.75", "0", "0.5"))));
  EXPECT_NEAR(look.preset.shading->ambient, 0.25 * 0.1 + 0.75 * 0.5, 1e-12);
  EXPECT_TRUE(isTold(look.changes, "weighted by opacity: 0.4"));
}

TEST(WeasisLook, unsortedPointsAreSortedAndTold) {
  const ReadLook look = onlyLook(weasisLook(weasisGroup(
      weasisPoint(-3024, "0", "0") + "," + weasisPoint(-638, "0", "1") + "," + weasisPoint(-700, "1", "1"))));
  EXPECT_EQ(look.preset.transferFunction.points[1].value, -700.0);
  EXPECT_TRUE(isTold(look.changes, "sorted"));
}

TEST(WeasisLook, withoutAnyColourWhiteIsTaken) {
  const ReadLook look = onlyLook(weasisLook(weasisGroup(weasisClear(0, "0") + "," + weasisClear(10, "1"))));
  EXPECT_EQ(classify(look.preset.transferFunction, 5.0).color, glm::dvec3(1.0));
  EXPECT_TRUE(isTold(look.changes, "white was taken"));
}

TEST(WeasisLook, whatWasWrittenReadsBackEqual) {
  Preset preset;
  preset.name = "Step";
  preset.modality = "MR";
  preset.transferFunction.points = {
      {-1000, {0, 0, 0}, 0}, {40, {1, 0.5, 0.1}, 0.3}, {40, {0, 0.5, 1}, 1}, {100000, {1, 1, 1}, 1e-5}};
  preset.shading = Shading{};
  preset.shading->ambient = 0.3;
  const ReadLook back = test::readBack(preset, "a.weasis.json");
  EXPECT_EQ(back.preset.transferFunction, preset.transferFunction);
  EXPECT_EQ(back.preset.name, "Step");
  EXPECT_EQ(back.preset.modality, "MR");
  EXPECT_NEAR(back.preset.shading->ambient, 0.3 * 0.25, 1e-12) << "coefficient times intensity";
  EXPECT_EQ(back.preset.shading->exponent, 32.0) << "Weasis, too, reflects after Blinn-Phong";
  const std::string text = lookAs("a.weasis.json", preset).text;
  EXPECT_NE(text.find("\"intensity\": \"100000\""), std::string::npos)
      << "a whole number as Java reads it: " << text;
}

TEST(WeasisLook, valuesBetweenWholeOnesAreRoundedAndTold) {
  Preset preset;
  preset.name = "Fine";
  preset.transferFunction.points = {{0.4, glm::dvec3(0.0), 0}, {99.6, glm::dvec3(1.0), 1}};
  EXPECT_TRUE(isTold(lookAs("a.weasis.json", preset).changes, "rounded to whole ones"));
  EXPECT_EQ(test::readBack(preset, "a.weasis.json").preset.transferFunction.points.back().value, 100.0);
}

} // namespace
} // namespace limn
