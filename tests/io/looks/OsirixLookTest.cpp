// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

namespace limn {
namespace {

using test::isTold;
using test::linearAt;
using test::onlyLook;
using test::refusal;

struct Place {
  double x, y, red;
};

std::string placesXml(const std::vector<Place>& places) {
  std::string text = "<array>";
  for (const Place& place : places)
    text += "<dict><key>y</key><real>" + std::to_string(place.y) + "</real>\n<key>x</key><real>" +
            std::to_string(place.x) + "</real></dict>";
  return text + "</array>";
}

std::string colorsXml(const std::vector<Place>& places) {
  std::string text = "<array>";
  for (const Place& place : places)
    text += "<dict><key>red</key><real>" + std::to_string(place.red) +
            "</real><key>green</key><real>0.5</real><key>blue</key><real>0.25</real></dict>";
  return text + "</array>";
}

std::string plist(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE plist PUBLIC \"-//Apple//DTD PLIST 1.0//EN\" "
         "\"http://www.apple.com/DTDs/PropertyList-1.0.dtd\">\n<plist version=\"1.0\"><dict>" +
         content + "</dict></plist>";
}

std::string curvesXml(const std::vector<std::vector<Place>>& curves,
                      const std::string& placesKey = "16bitClutCurves",
                      const std::string& colorsKey = "16bitClutColors") {
  std::string places, colors;
  for (const std::vector<Place>& curve : curves) {
    places += placesXml(curve);
    colors += colorsXml(curve);
  }
  // Colours before places: what stands where does not count.
  return "<key>" + colorsKey + "</key><array>" + colors + "</array><key>" + placesKey + "</key><array>" +
         places + "</array>";
}

const std::string osirixRest =
    "<key>name</key><string>Demo</string><key>groupName</key><string>Bone CT</string>"
    "<key>advancedCLUT</key><true/><key>useShading</key><true/>"
    "<key>shading</key><string>Glossy Vascular</string>"
    "<key>projection</key><integer>0</integer><key>convolutionFilters</key><array/>";

TEST(OsirixLook, aCurveIsClearOutsideItsEnds) {
  const ReadLook look = onlyLook(plist(osirixRest + curvesXml({{{150, 0.25, 0.5}, {600, 0.75, 1.0}}})));
  const auto expected = [](double value) {
    const bool inside = value >= 150.0 && value < 600.0;
    return Classified{{linearAt({{150, 0.5}, {600, 1.0}}, value), 0.5, 0.25},
                      inside ? linearAt({{150, 0.25}, {600, 0.75}}, value) : 0.0};
  };
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, expected, 0.0, 1000.0), test::sameCurve);
  EXPECT_EQ(look.preset.name, "Demo");
  EXPECT_EQ(look.preset.folder, "Bone CT");
  EXPECT_EQ(look.preset.modality, "CT");
  EXPECT_EQ(look.preset.shading->specular, 1.42) << "more than 1 occurs and stays";
  EXPECT_EQ(look.preset.shading->exponent, 50.0);
  EXPECT_EQ(look.changes.size(), 1u) << test::allOf(look.changes); // of the length
}

TEST(OsirixLook, severalCurvesAreOneFunction) {
  const ReadLook apart = onlyLook(plist(
      osirixRest + curvesXml({{{0, 0, 1}, {50, 0.5, 1}, {100, 0, 1}}, {{200, 0.25, 0}, {300, 0.25, 0}}})));
  EXPECT_EQ(classify(apart.preset.transferFunction, 150.0).opacity, 0.0);
  EXPECT_EQ(classify(apart.preset.transferFunction, 250.0).opacity, 0.25);
  EXPECT_FALSE(isTold(apart.changes, "overlap"));
  const ReadLook over = onlyLook(
      plist(osirixRest + curvesXml({{{0, 0.5, 1}, {100, 0.5, 1}}, {{50, 0.75, 0}, {150, 0.75, 0}}})));
  EXPECT_EQ(classify(over.preset.transferFunction, 75.0).opacity, 0.75);
  EXPECT_EQ(classify(over.preset.transferFunction, 25.0).opacity, 0.5);
  EXPECT_TRUE(isTold(over.changes, "overlap"));
}

TEST(OsirixLook, functionsOfHorosAloneHaveOtherKeys) {
  const ReadLook look = onlyLook(plist(curvesXml({{{0, 0, 1}, {100, 1, 1}}}, "curves", "colors")));
  EXPECT_EQ(classify(look.preset.transferFunction, 50.0).opacity, 0.5);
  EXPECT_FALSE(look.preset.shading);
}

TEST(OsirixLook, aTableAndAWindowBecomeARamp) {
  const std::string window = "<key>advancedCLUT</key><false/><key>CLUT</key><string>VR Red Vessels</string>"
                             "<key>wl</key><real>300</real><key>ww</key><real>400</real>"
                             "<key>opacity</key><string>Logarithmic Table</string>";
  const ReadLook look = onlyLook(plist(window));
  EXPECT_EQ(classify(look.preset.transferFunction, 100.0).opacity, 0.0);
  EXPECT_EQ(classify(look.preset.transferFunction, 300.0).opacity, 0.5);
  EXPECT_EQ(classify(look.preset.transferFunction, 300.0).color, glm::dvec3(0.5));
  EXPECT_TRUE(isTold(look.changes, "VR Red Vessels"));
  EXPECT_TRUE(isTold(look.changes, "Logarithmic Table"));

  std::string table;
  for (const char* channel : {"Red", "Green", "Blue"}) {
    table += std::string("<key>") + channel + "</key><array>";
    for (int i = 0; i < 256; ++i)
      table += "<integer>" + std::to_string(std::string(channel) == "Red" ? i : 0) + "</integer>";
    table += "</array>";
  }
  const ReadLook own = onlyLook(plist(window + table));
  EXPECT_LE(test::difference(classify(own.preset.transferFunction, 300.0), {{0.5, 0.0, 0.0}, 0.5}),
            test::sameCurve);
  table.replace(table.find("<integer>7</integer>"), 20, "");
  EXPECT_NE(refusal(plist(window + table)).find("255 entries instead of 256"), std::string::npos);
}

TEST(OsirixLook, whatLimnDoesNotHoldIsTold) {
  const ReadLook look =
      onlyLook(plist("<key>useShading</key><true/><key>shading</key><string>Mine</string><key>projection</"
                     "key><integer>2</integer>"
                     "<key>convolutionFilters</key><array><string>Gauss</string></array><key>MIP</key><true/>"
                     "<key>backgroundColorBlueComponent</key><real>0.4</real>" +
                     curvesXml({{{0, 0, 1}, {100, 1, 1}}})));
  for (const char* words : {"\"Mine\"", "camera", "filters", "background"})
    EXPECT_TRUE(isTold(look.changes, words)) << words << " in " << test::allOf(look.changes);
  EXPECT_EQ(look.preset.projection, Projection::mip);
}

TEST(OsirixLook, contradictionsAreRefused) {
  const std::string places =
      "<key>16bitClutCurves</key><array>" + placesXml({{0, 0, 0}, {1, 1, 1}}) + "</array>";
  EXPECT_NE(refusal(plist(places)).find("1 curves and colours for 0"), std::string::npos);
  EXPECT_NE(refusal(plist(places + "<key>16bitClutColors</key><array>" + colorsXml({{0, 0, 0}}) + "</array>"))
                .find("2 points and 1 colours"),
            std::string::npos);
  EXPECT_NE(
      refusal(plist("<key>advancedCLUT</key><true/><key>16bitClutCurves</key><array/>")).find("no curves"),
      std::string::npos);
  EXPECT_NE(refusal(plist("<key>dimensions</key><array/>")).find("no look of OsiriX"), std::string::npos);
  EXPECT_NE(refusal("bplist00\x01\x02").find("not text"), std::string::npos);
  EXPECT_NE(refusal(plist("<key>CLUT</key><string/><key>ww</key><real>0</real><key>wl</key><real>1</real>"))
                .find("width of its window"),
            std::string::npos);
}

TEST(OsirixLook, whatWasWrittenReadsBackEqualOverSixteenBits) {
  Preset preset;
  preset.name = "A & <B>";
  preset.folder = "Mine CT";
  preset.modality = "CT";
  preset.transferFunction.points = {
      {-1000, {0, 0, 0}, 0.1}, {40.25, {1, 0.5, 0.1}, 0.3}, {40.25, {0, 0.5, 1}, 1}, {1500, {1, 1, 1}, 0.5}};
  preset.shading = Shading{};
  preset.shading->model = ShadingModel::none;
  const ReadLook back = test::readBack(preset, "a.plist");
  const auto expected = [&](double value) { return classify(preset.transferFunction, value); };
  EXPECT_LE(test::largestDifference(back.preset.transferFunction, expected, -32000.0, 32000.0, 64001), 1e-12);
  EXPECT_EQ(back.preset.name, preset.name);
  EXPECT_EQ(back.preset.folder, "Mine CT");
  EXPECT_EQ(back.preset.shading->model, ShadingModel::none);
  preset.shading->model = ShadingModel::classic;
  EXPECT_TRUE(isTold(lookAs("a.plist", preset).changes, "nearest that such files can name"));
}

} // namespace
} // namespace limn
