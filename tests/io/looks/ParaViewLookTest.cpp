// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include "io/looks/curves/CurvedSegments.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using nlohmann::json;
using test::isTold;
using test::linearAt;
using test::onlyLook;
using test::refusal;

json paraViewMap() {
  return json::parse(R"({"Name": "Demo", "ColorSpace": "RGB", "NanColor": [1, 1, 0],
    "RGBPoints": [100, 0.2, 0, 0, 900, 1, 1, 0.9], "Points": [100, 0, 0.5, 0, 900, 0.7, 0.5, 0],
    "AbsoluteRange": true, "EffectiveRange": [100, 900]})");
}

std::string listOf(const json& map) {
  return json::array({map}).dump();
}

Classified paraViewCurve(double value) {
  return {{linearAt({{100, 0.2}, {900, 1.0}}, value), linearAt({{100, 0.0}, {900, 1.0}}, value),
           linearAt({{100, 0.0}, {900, 0.9}}, value)},
          linearAt({{100, 0.0}, {900, 0.7}}, value)};
}

TEST(ParaViewLook, aMapBecomesItsCurve) {
  const ReadLook look = onlyLook(listOf(paraViewMap()));
  EXPECT_EQ(look.preset.name, "Demo");
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, paraViewCurve, 0.0, 1000.0),
            test::sameCurve);
  EXPECT_FALSE(look.preset.shading) << "light stays as it is";
  EXPECT_TRUE(isTold(look.changes, "values that are no number"));
  EXPECT_EQ(onlyLook(paraViewMap().dump()).preset, look.preset) << "without a list around it";
}

TEST(ParaViewLook, namesOfSingleValuesAreToldAsLeftOut) {
  EXPECT_FALSE(isTold(onlyLook(listOf(paraViewMap())).changes, "names of single values"));
  for (const char* key : {"Annotations", "AnnotatedValues", "ActiveAnnotatedValues"}) {
    json map = paraViewMap();
    map[key] = json::array();
    EXPECT_FALSE(isTold(onlyLook(listOf(map)).changes, "names of single values")) << key;
    map[key] = {"300", "Bone"};
    EXPECT_TRUE(isTold(onlyLook(listOf(map)).changes, "names of single values were left out")) << key;
  }
}

TEST(ParaViewLook, volViewsOpacityIsReadAndADifferenceTold) {
  json map = paraViewMap();
  map["OpacityPoints"] = {100, 0, 900, 0.7};
  EXPECT_FALSE(isTold(onlyLook(listOf(map)).changes, "differ"));
  map["OpacityPoints"] = {100, 0, 900, 0.2};
  EXPECT_TRUE(isTold(onlyLook(listOf(map)).changes, "opacities for ParaView and for VolView differ"));
  map.erase("Points");
  EXPECT_EQ(classify(onlyLook(listOf(map)).preset.transferFunction, 900.0).opacity, 0.2);
  map.erase("OpacityPoints");
  const ReadLook ramp = onlyLook(listOf(map));
  EXPECT_EQ(classify(ramp.preset.transferFunction, 500.0).opacity, 0.5);
  EXPECT_TRUE(isTold(ramp.changes, "colours alone"));
}

TEST(ParaViewLook, relativeValuesAreStretchedOverTheVolumeAndAbsoluteOnesNot) {
  json map = paraViewMap();
  map["RGBPoints"] = {0, 0, 0, 0, 1, 1, 1, 1};
  map["Points"] = {0, 0, 0.5, 0, 0.5, 0.4, 0.5, 0, 1, 1, 0.5, 0};
  const LookTarget target{-1000.0, 3000.0, 1.0};
  EXPECT_EQ(onlyLook(listOf(map), target).preset.transferFunction.points.back().value, 1.0);
  map.erase("AbsoluteRange");
  const ReadLook look = onlyLook(listOf(map), target);
  EXPECT_EQ(classify(look.preset.transferFunction, 1000.0).opacity, 0.4);
  EXPECT_TRUE(isTold(look.changes, "stretched over -1000 to 3000"));
  EXPECT_TRUE(isTold(onlyLook(listOf(map)).changes, "--for"));
}

TEST(ParaViewLook, colourSpacesAreFollowedWithinTheStatedError) {
  const glm::dvec3 from{0.230, 0.299, 0.754}, to{0.706, 0.016, 0.150};
  for (const auto& [name, space] : {std::pair{"HSV", ColorSpace::hsv}, std::pair{"Lab", ColorSpace::lab},
                                    std::pair{"Diverging", ColorSpace::diverging}}) {
    json map = paraViewMap();
    map["ColorSpace"] = name;
    map["RGBPoints"] = {0, from.r, from.g, from.b, 1000, to.r, to.g, to.b};
    map["Points"] = {0, 0, 0.5, 0, 1000, 1, 0.5, 0};
    const ReadLook look = onlyLook(listOf(map));
    const auto expected = [&, space = space](double value) {
      return Classified{mixed(space, from, to, std::clamp(value / 1000.0, 0.0, 1.0)),
                        std::clamp(value / 1000.0, 0.0, 1.0)};
    };
    EXPECT_LE(test::largestDifference(look.preset.transferFunction, expected, 0.0, 1000.0), 0.01) << name;
    EXPECT_TRUE(isTold(look.changes, name));
    EXPECT_TRUE(isTold(look.changes, "by at most 0.01"));
    EXPECT_LT(look.preset.transferFunction.points.size(), 30u) << "as few as it needs";
  }
}

TEST(ParaViewLook, stepsTakeTheColourOnTheirRightAndLogarithmsTheirOwn) {
  json map = paraViewMap();
  map["ColorSpace"] = "Step";
  map["RGBPoints"] = {1, 1, 0, 0, 10, 0, 1, 0, 100, 0, 0, 1};
  map["Points"] = {1, 0, 0.5, 0, 100, 1, 0.5, 0};
  EXPECT_EQ(classify(onlyLook(listOf(map)).preset.transferFunction, 5.0).color, glm::dvec3(0, 1, 0));
  map["ColorSpace"] = "RGB";
  map["UseLogScale"] = 1;
  const ReadLook look = onlyLook(listOf(map));
  const auto expected = [](double value) {
    const double u = std::log10(std::clamp(value, 1.0, 100.0)); // 0 to 2
    return Classified{{std::max(0.0, 1.0 - u), u < 1.0 ? u : 2.0 - u, std::max(0.0, u - 1.0)}, u / 2.0};
  };
  // Opacity and colour are each within 0.01.
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, expected, 1.0, 100.0), 0.01);
  EXPECT_TRUE(isTold(look.changes, "logarithmic"));
  map["RGBPoints"] = {0, 1, 0, 0, 100, 0, 0, 1};
  EXPECT_NE(refusal(listOf(map)).find("logarithmic"), std::string::npos);
}

TEST(ParaViewLook, coloursOfSingleValuesAreRefusedOrPassedOver) {
  json indexed = {
      {"Name", "Labels"}, {"IndexedColors", {1, 0, 0, 0, 1, 0}}, {"Annotations", {0, "a", 1, "b"}}};
  EXPECT_NE(refusal(listOf(indexed)).find("single values"), std::string::npos);
  const ReadLook look = onlyLook(json::array({indexed, paraViewMap()}).dump());
  EXPECT_TRUE(isTold(look.changes, "\"Labels\" was passed over"));
  json second = paraViewMap();
  second["Name"] = "Second";
  const std::vector<ReadLook> both =
      parseLooks(json::array({paraViewMap(), indexed, second}).dump(), "two.json");
  ASSERT_EQ(both.size(), 2u);
  for (const ReadLook& each : both)
    EXPECT_TRUE(isTold(each.changes, "\"Labels\" was passed over"))
        << "it is not about one of them: " << each.preset.name;
}

TEST(ParaViewLook, tomvizNamesItsKeysInSmallLetters) {
  const ReadLook look = onlyLook(R"([{"name": "Small", "colorSpace": "rgb", "default": true,
                                      "colors": [0, 0, 0, 0, 1, 1, 1, 1]}])");
  EXPECT_EQ(look.preset.name, "Small");
  EXPECT_EQ(classify(look.preset.transferFunction, 0.5).color, glm::dvec3(0.5));
}

TEST(ParaViewLook, anUnknownColourSpaceIsTold) {
  json map = paraViewMap();
  map["ColorSpace"] = "Lab/CIEDE2000";
  EXPECT_TRUE(isTold(onlyLook(listOf(map)).changes, "became Lab"));
  map["ColorSpace"] = "Spectral";
  EXPECT_TRUE(isTold(onlyLook(listOf(map)).changes, "became RGB"));
}

TEST(ParaViewLook, whatWasWrittenReadsBackEqual) {
  Preset preset;
  preset.name = "Step";
  preset.transferFunction.points = {
      {-1000, {0, 0, 0}, 0}, {0.125, {1, 0.5, 0.1}, 0.3}, {0.125, {0, 0.5, 1}, 1}};
  preset.shading = Shading{};
  preset.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {10.0, 1.0}}};
  for (const char* file : {"a.paraview.json", "a.volview.json"}) {
    const ReadLook back = test::readBack(preset, file);
    EXPECT_EQ(back.preset.transferFunction, preset.transferFunction);
    EXPECT_EQ(back.preset.name, "Step");
    const WrittenLook written = lookAs(file, preset);
    EXPECT_TRUE(isTold(written.changes, "light was left out"));
    EXPECT_TRUE(isTold(written.changes, "gradient opacity was left out"));
  }
}

} // namespace
} // namespace limn
