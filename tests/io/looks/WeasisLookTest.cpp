// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include "io/looks/curves/CurvedSegments.h"

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
  EXPECT_TRUE(isTold(lookAs("a.weasis.json", preset).changes, "rounded to whole ones, by up to 0.4"));
  EXPECT_EQ(test::readBack(preset, "a.weasis.json").preset.transferFunction.points.back().value, 100.0);
}

// A map as Weasis keeps them since 2026, with further keys.
std::string weasisMap(const std::string& stops, const std::string& more = "") {
  return R"({"schema": 1, "maps": [{"name": "Map", "type": "transfer", "modality": ["CT"], )" + more +
         R"("domain": {"kind": "absolute", "unit": "HU", "min": 0, "max": 100}, "stops": [)" + stops + "]}]}";
}

constexpr const char* mapStops = R"({"pos": 0, "color": "#000000", "alpha": 0}, {"pos": "20", "alpha": 0.5},
  {"pos": 60, "color": "#ff8000"}, {"pos": 60, "alpha": 0.25}, {"pos": 60, "alpha": 1}, {"pos": 100, "color": "#fff"})";

TEST(WeasisLook, stopsOfAMapAreTwoCurvesWithSteps) {
  const ReadLook look = onlyLook(weasisMap(mapStops));
  const auto expected = [](double value) {
    return Classified{{linearAt({{0, 0}, {60, 1}}, value),
                       linearAt({{0, 0}, {60, 128 / 255.0}, {100, 1}}, value),
                       linearAt({{0, 0}, {60, 0}, {100, 1}}, value)},
                      value < 60 ? linearAt({{0, 0}, {20, 0.5}, {60, 0.25}}, value) : 1.0};
  };
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, expected, -10.0, 120.0), test::sameCurve);
  EXPECT_EQ(look.preset.modality, "CT");
  EXPECT_FALSE(look.preset.shading);
}

TEST(WeasisLook, aMapHasLightAndIsRelativeUnlessItSays) {
  const ReadLook lit =
      onlyLook(weasisMap(mapStops, R"("lighting": {"shade": true, "specularPower": "20"}, )"));
  ASSERT_TRUE(lit.preset.shading);
  EXPECT_EQ(lit.preset.shading->exponent, 20.0);
  const ReadLook relative =
      onlyLook(R"({"name": "Ramp", "stops": [{"pos": 0, "color": "#000"}, {"pos": 1, "color": "#fff"}]})",
               LookTarget{-1000.0, 3000.0, 1.0});
  EXPECT_EQ(classify(relative.preset.transferFunction, 1000.0).color, glm::dvec3(0.5));
  EXPECT_EQ(classify(relative.preset.transferFunction, 1000.0).opacity, 1.0) << "without an opacity, opaque";
}

TEST(WeasisLook, stepsAndColourSpacesOfAMapAreFollowed) {
  const std::string ends =
      R"({"pos": 0, "color": "#ff0000", "alpha": 0.5}, {"pos": 100, "color": "#0000ff", "alpha": 1})";
  const TransferFunction steps =
      onlyLook(weasisMap(ends, R"("interpolation": "step", )")).preset.transferFunction;
  EXPECT_EQ(classify(steps, 99.0).color, glm::dvec3(1, 0, 0)) << "each holds up to the next";
  EXPECT_EQ(classify(steps, 99.0).opacity, 0.5);
  EXPECT_EQ(classify(steps, 100.0).color, glm::dvec3(0, 0, 1));
  const ReadLook lab = onlyLook(weasisMap(ends, R"("space": "lab", "outside": {"low": "transparent"}, )"));
  EXPECT_LE(test::largestDifference(
                lab.preset.transferFunction,
                [](double value) {
                  return Classified{mixed(ColorSpace::lab, {1, 0, 0}, {0, 0, 1}, value / 100.0),
                                    0.5 + value / 200.0};
                },
                0.0, 100.0),
            0.01);
  EXPECT_TRUE(isTold(lab.changes, "beyond its ends"));
}

TEST(WeasisLook, aColourThatIsNoneIsRefused) {
  for (const char* color : {"#12", "red", "#gg0000", "#ff00f"})
    EXPECT_NE(
        test::refusal(weasisMap(R"({"pos": 0, "color": ")" + std::string(color) + "\"}")).find("#ff8000"),
        std::string::npos)
        << color;
  EXPECT_NE(test::refusal(weasisMap("")).find("no points"), std::string::npos);
}

} // namespace
} // namespace limn
