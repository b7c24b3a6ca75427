// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

// 3D Slicer's volume properties: JSON, lines of text and MRML. The numbers are invented, the shapes are those
// of real files.
namespace limn {
namespace {

using nlohmann::json;
using test::isTold;
using test::linearAt;
using test::onlyLook;
using test::readBack;
using test::sameCurve;

json slicerComponent() {
  return json::parse(R"({"componentWeight": 1, "shade": true,
    "lighting": {"ambient": 0.1, "diffuse": 0.8, "specular": 0.2, "specularPower": 12},
    "disableGradientOpacity": false, "scalarOpacityUnitDistance": 0.6,
    "scalarOpacity": {"points": [{"x": 900, "y": 0.7}, {"x": 100, "y": 0, "midpoint": 0.5, "sharpness": 0}]},
    "gradientOpacity": {"points": [{"x": 0, "y": 1}, {"x": 255, "y": 1}]},
    "rgbTransferFunction": {"points": [{"x": 100, "color": [0.2, 0, 0]}, {"x": 300, "color": [1, 0.5, 0]},
                                       {"x": 900, "color": [1, 1, 0.9]}]}})");
}

std::string slicerJson(const json& component) {
  return json{{"@schema", "volume-property-schema-v1.0.0.json#"},
              {"volumeProperties",
               {{{"effectiveRange", {100, 900}},
                 {"independentComponents", true},
                 {"interpolationType", "linear"},
                 {"components", {component}}}}}}
      .dump();
}

// The lines of a .vp file with these functions.
std::string slicerLines(const std::string& opacity, const std::string& gradient, const std::string& color) {
  return "1\n1\n0.8\n0.1\n0.2\n12\n" + opacity + "\n" + gradient + "\n" + color + "\n";
}

constexpr const char* plainGradient = "4 0 1 255 1";

Classified demoCurve(double value) {
  return {{linearAt({{100, 0.2}, {300, 1.0}, {900, 1.0}}, value),
           linearAt({{100, 0.0}, {300, 0.5}, {900, 1.0}}, value),
           linearAt({{100, 0.0}, {300, 0.0}, {900, 0.9}}, value)},
          linearAt({{100, 0.0}, {900, 0.7}}, value)};
}

TEST(SlicerLook, jsonBecomesItsCurveLightAndUnitDistance) {
  const ReadLook look = onlyLook(slicerJson(slicerComponent()));
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, demoCurve, 0.0, 1000.0), sameCurve);
  EXPECT_EQ(look.preset.transferFunction.unitDistanceMm, 0.6);
  ASSERT_TRUE(look.preset.shading);
  EXPECT_EQ(look.preset.shading->diffuse, 0.8);
  EXPECT_EQ(look.preset.shading->exponent, 12.0);
  EXPECT_EQ(look.preset.shading->model, ShadingModel::classic);
  EXPECT_FALSE(look.preset.gradientOpacity);
  EXPECT_EQ(look.preset.name, "demo");
  EXPECT_TRUE(look.changes.empty()) << test::allOf(look.changes);
}

TEST(SlicerLook, whatJsonHoldsAndLimnDoesNotDrawIsTold) {
  json component = slicerComponent();
  component["componentWeight"] = 0.5;
  component["shade"] = false;
  component["gradientOpacity"]["points"] = {{{"x", 0}, {"y", 0.1}}, {{"x", 40}, {"y", 1}}};
  component["disableGradientOpacity"] = true;
  json document = json::parse(slicerJson(component));
  json& property = document["volumeProperties"][0];
  property["interpolationType"] = "cubic";
  property["components"].push_back(slicerComponent());
  property["isoSurfaceValues"] = {200};
  property["scatteringAnisotropy"] = 0.4;
  property["clippedVoxelIntensity"] = 55.0;
  const ReadLook look = onlyLook(document.dump());
  for (const char* words :
       {"weight", "switched off", "cubic", "2 components", "isosurfaces", "scattering", "clipped"})
    EXPECT_TRUE(isTold(look.changes, words)) << words << " in " << test::allOf(look.changes);
  EXPECT_FALSE(look.preset.gradientOpacity);
  EXPECT_EQ(look.preset.shading->model, ShadingModel::none);
}

TEST(SlicerLook, midpointsAndSharpnessAreFollowedAndTold) {
  json component = slicerComponent();
  component["scalarOpacity"]["points"] = {{{"x", 0}, {"y", 0}, {"midpoint", 0.4}, {"sharpness", 0.5}},
                                          {{"x", 100}, {"y", 1}, {"midpoint", 0.5}, {"sharpness", 1}},
                                          {{"x", 200}, {"y", 0.2}}};
  const ReadLook look = onlyLook(slicerJson(component));
  EXPECT_TRUE(isTold(look.changes, "by at most 0.01"));
  EXPECT_EQ(classify(look.preset.transferFunction, 149.9).opacity, 1.0) << "a true step";
  EXPECT_EQ(classify(look.preset.transferFunction, 150.0).opacity, 0.2);
}

TEST(SlicerLook, severalPropertiesAreSeveralLooks) {
  json document = json::parse(slicerJson(slicerComponent()));
  document["volumeProperties"].push_back(document["volumeProperties"][0]);
  const std::vector<ReadLook> looks = parseLooks(document.dump(), "two.vp.json");
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_EQ(looks[0].preset.name, "two");
  EXPECT_EQ(looks[1].preset.name, "two 2");
}

TEST(SlicerLook, linesBecomeTheSameCurveWithDiffuseBeforeAmbient) {
  const std::string text =
      slicerLines("4 100 0 900 0.7", plainGradient, "12 100 0.2 0 0 300 1 0.5 0 900 1 1 0.9 ");
  const ReadLook look = onlyLook(text);
  EXPECT_LE(test::largestDifference(look.preset.transferFunction, demoCurve, 0.0, 1000.0), sameCurve);
  EXPECT_EQ(look.preset.shading->diffuse, 0.8);
  EXPECT_EQ(look.preset.shading->ambient, 0.1);
  EXPECT_TRUE(isTold(look.changes, "1 mm was taken"));
  std::string crlf;
  for (const char letter : text)
    crlf += letter == '\n' ? "\r\n" : std::string(1, letter);
  EXPECT_EQ(onlyLook("\xEF\xBB\xBF" + crlf).preset, look.preset) << "of Windows, with a byte order mark";
}

TEST(SlicerLook, blankLinesLeaveDefaults) {
  const ReadLook look = onlyLook("\n\n\n0.3\n\n\n4 0 0 1 1\n\n8 0 0 0 0 1 1 1 1\n");
  EXPECT_EQ(look.preset.shading->ambient, 0.3);
  EXPECT_EQ(look.preset.shading->model, ShadingModel::classic);
  EXPECT_FALSE(look.preset.gradientOpacity);
}

TEST(SlicerLook, pointsAtOneValueStayAStep) {
  const ReadLook look = onlyLook(
      slicerLines("8 58.6 0 58.6 0.9 200 0.9 300 0", plainGradient, "12 58.6 0 0 1 58.6 1 0 0 300 1 1 1"));
  const TransferFunction& function = look.preset.transferFunction;
  EXPECT_EQ(classify(function, 58.599).opacity, 0.0);
  EXPECT_EQ(classify(function, 58.6).opacity, 0.9);
  EXPECT_EQ(classify(function, 58.599).color, glm::dvec3(0, 0, 1));
  EXPECT_EQ(classify(function, 58.6).color, glm::dvec3(1, 0, 0));
  EXPECT_EQ(function.points[1].value, 58.6) << "nothing is nudged";
}

TEST(SlicerLook, aDamagedNumberIsReadAsFarAsItGoes) {
  const ReadLook look =
      onlyLook(slicerLines("4 -250.0.0 0 900 0.7", plainGradient, "8 -250 0 0 0 900 1 1 1"));
  EXPECT_EQ(look.preset.transferFunction.points.front().value, -250.0);
  EXPECT_TRUE(isTold(look.changes, "-250.0.0"));
}

TEST(SlicerLook, differentDomainsAreExtendedAndTold) {
  const ReadLook look = onlyLook(slicerLines("4 -1000 0 952 0.7", plainGradient, "8 -1000 0 0 0 2952 1 1 1"));
  EXPECT_EQ(classify(look.preset.transferFunction, 2000.0).opacity, 0.7);
  EXPECT_TRUE(isTold(look.changes, "end at different values"));
}

TEST(SlicerLook, gradientOpacityIsConvertedByTheVolumesSpacing) {
  const std::string text = slicerLines("4 0 0 1024 1", "8 0 1 0 1 47 0.1 128 1", "8 0 0 0 0 1024 1 1 1");
  const ReadLook look = onlyLook(text, LookTarget{0.0, 1024.0, 0.5});
  ASSERT_TRUE(look.preset.gradientOpacity);
  EXPECT_EQ(look.preset.gradientOpacity->points[2], (GradientOpacityPoint{94.0, 0.1}));
  EXPECT_TRUE(isTold(look.changes, "0.5 mm"));
}

TEST(SlicerLook, aSceneHoldsSeveralPropertiesByName) {
  const std::string element =
      R"(<VolumeProperty name="NAME" shade="1" ambient="0.1" diffuse="0.8" specular="0.2"
    specularPower="12" interpolation="INTERPOLATION" effectiveRange="0 -1" scalarOpacity="4 100 0 900 0.7"
    gradientOpacity="4 0 1 255 1" colorTransfer="12 100 0.2 0 0 300 1 0.5 0 900 1 1 0.9 "/>)";
  const auto with = [&](const std::string& name, const std::string& interpolation) {
    std::string text = element;
    text.replace(text.find("NAME"), 4, name);
    return text.replace(text.find("INTERPOLATION"), 13, interpolation);
  };
  const auto looks =
      parseLooks("<?xml version=\"1.0\"?>\n<MRML>\n" + with("CT-Demo", "1") + with("MR-Demo", "0") +
                     "<Volume/><VolumeProperty name=\"elsewhere\" references=\"storage\"/></MRML>",
                 "presets.xml");
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_EQ(looks[0].preset.name, "CT-Demo");
  EXPECT_EQ(looks[0].preset.modality, "CT");
  EXPECT_EQ(looks[1].preset.modality, "MR");
  EXPECT_LE(test::largestDifference(looks[0].preset.transferFunction, demoCurve, 0.0, 1000.0), sameCurve);
  EXPECT_FALSE(isTold(looks[0].changes, "interpolation"));
  EXPECT_TRUE(isTold(looks[1].changes, "interpolation"));
}

TEST(SlicerLook, anEffectiveRangeIsNoPartOfALook) {
  for (const char* range : {"0 -1", "-250.0.0 1500", ""})
    EXPECT_EQ(onlyLook("<MRML><VolumeProperty name=\"CT\" effectiveRange=\"" + std::string(range) +
                       "\" scalarOpacity=\"4 0 0 9 1\" colorTransfer=\"4 0 1 1 1\"/></MRML>")
                  .preset.transferFunction.points.size(),
              2u)
        << range;
}

TEST(SlicerLook, whatWasWrittenReadsBackEqual) {
  const std::string text = slicerLines("8 -250 0 60.25 0 60.25 0.9 3071 0.1", "6 0 0.25 47 0.5 128 1",
                                       "8 -250 0.2 0 0 3071 1 1 0.9");
  const LookTarget target{-1000.0, 3000.0, 0.75};
  Preset preset = onlyLook(text, target).preset;
  preset.name = "CT <bone> & \"skin\"";
  preset.modality = "CT";
  for (const char* file : {"a.xml", "a.vp", "a.vp.json"}) {
    Preset expected = preset;
    const ReadLook back = readBack(preset, file, target);
    if (std::string(file) != "a.xml") // the others have no name in them
      expected.name = "a", expected.modality = "";
    EXPECT_EQ(back.preset.name, expected.name);
    EXPECT_EQ(back.preset.transferFunction, expected.transferFunction) << file;
    EXPECT_EQ(back.preset.shading, expected.shading) << file;
    ASSERT_TRUE(back.preset.gradientOpacity);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(back.preset.gradientOpacity->points[i].gradient, preset.gradientOpacity->points[i].gradient,
                  1e-9);
  }
}

TEST(SlicerLook, aLookOfLimnKeepsItsCurveAndSaysWhatItLoses) {
  Preset preset;
  preset.name = "Robust";
  preset.transferFunction = {0.5,
                             {{-1000, {0, 0, 0}, 0}, {40.5, {1, 0.5, 0.25}, 0.5}, {40.5, {0, 0.5, 1}, 1}}};
  preset.shading = Shading{};
  preset.shading->model = ShadingModel::robust;
  preset.shading->gradientSmoothing = 3.5;
  preset.projection = Projection::mip;
  preset.landmarks = hounsfieldLandmarks;
  const WrittenLook written = lookAs("robust.vp.json", preset);
  for (const char* words :
       {"robust", "mip", "Blinn-Phong", "another scale", "material's colour", "turned away", "smoothing"})
    EXPECT_TRUE(isTold(written.changes, words)) << words << " in " << test::allOf(written.changes);
  EXPECT_EQ(onlyLook(written.text).preset.transferFunction, preset.transferFunction);
  EXPECT_TRUE(isTold(lookAs("robust.vp", preset).changes, "over 0.5 mm")) << "lines hold no length";
}

// Whoever saw enhanced, robust or physical pictures is told so first, by every format of other programs.
TEST(SlicerLook, aModelThatOtherProgramsLackIsToldFirstByEveryFormat) {
  Preset preset;
  preset.shading = Shading{};
  const LookTarget target{0.0, 255.0, 1.0};
  for (const double unitDistanceMm : {1.0, 0.5}) // of another one more is told
    for (const char* file : {"a.vp", "a.vp.json", "a.xml", "a.plist", "a.paraview.json", "a.weasis.json",
                             "a.itf", "a.clut", "a.niivue.json", "a.1dt"}) {
      preset.transferFunction = {unitDistanceMm, {{0, {0, 0, 0}, 0}, {255, {1, 1, 1}, 0.9}}};
      const auto told = [&](ShadingModel model) {
        preset.shading->model = model;
        return lookAs(file, preset, target).changes;
      };
      for (const ShadingModel model : {ShadingModel::enhanced, ShadingModel::robust}) {
        const std::string first = told(model).front().english();
        for (const std::string& words : {std::string("shading model ") + nameOf(model),
                                         std::string("exponent range, opacity range and gradient reference")})
          EXPECT_NE(first.find(words), std::string::npos) << file << ": " << first;
      }
      EXPECT_TRUE(told(ShadingModel::physical).front().english().starts_with("Physical light")) << file;
      EXPECT_FALSE(isTold(told(ShadingModel::classic), "shading model")) << file;
    }
}

// The classic presets of Slicer, whose numbers a shared file has as facts.
TEST(SlicerLook, classicPresetsImportToTheirCurves) {
  const char* const shared = std::getenv("LIMN_SHARED");
  std::ifstream file(std::string(shared ? shared : "") + "/slicer_presets.json");
  if (!shared || !file)
    GTEST_SKIP() << "LIMN_SHARED names no folder with slicer_presets.json";
  const auto text = [](const json& points) {
    std::ostringstream out;
    std::size_t count = 0;
    for (const json& point : points)
      for (const json& number : point) {
        out << " " << number.dump();
        ++count;
      }
    return std::to_string(count) + out.str();
  };
  const auto channel = [](const json& points, std::size_t which) {
    std::vector<std::pair<double, double>> list;
    for (const json& point : points)
      list.emplace_back(point[0].get<double>(), std::clamp(point[which].get<double>(), 0.0, 1.0));
    return list;
  };
  const json presets = json::parse(file)["presets"];
  for (const json& preset : presets) {
    const json& opacity = preset["scalar_opacity"];
    const json& color = preset["scalar_rgb"];
    const ReadLook look = onlyLook(slicerLines(text(opacity), text(preset["gradient_opacity"]), text(color)));
    const auto expected = [&](double value) {
      return Classified{{linearAt(channel(color, 1), value), linearAt(channel(color, 2), value),
                         linearAt(channel(color, 3), value)},
                        linearAt(channel(opacity, 1), value)};
    };
    const double low = opacity.front()[0], high = opacity.back()[0], margin = 0.1 * (high - low);
    EXPECT_LE(
        test::largestDifference(look.preset.transferFunction, expected, low - margin, high + margin, 499),
        sameCurve)
        << preset["name"];
  }
  EXPECT_EQ(presets.size(), 31u);
}

} // namespace
} // namespace limn
