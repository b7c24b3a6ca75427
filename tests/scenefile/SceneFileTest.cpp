// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneFile.h"

#include "scene/basics/Error.h"
#include "scene/regions/BodyAndLabels.h"

#include <gtest/gtest.h>

#include <map>

namespace limn {
namespace {

std::string refusalOf(const std::string& text) {
  try {
    parseScene(text, "test.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

Scene unusualScene() {
  Scene scene;
  scene.camera = {Camera::Projection::orthographic, {1, 2, 3}, {4, 5, 6}, {0, 1, 0}, 42.5, 123.25};
  scene.transferFunction = {0.5, {{-200.125, {0.1, 0.2, 0.3}, 0.0}, {1.0 / 3.0, {1, 1, 1}, 0.7}}};
  scene.shading.model = ShadingModel::robust;
  scene.shading.exponentRange = {2.5, 99};
  scene.shading.gradientReference = PercentileReference{97.25};
  scene.shading.gradientCurve = {GradientCurve::Type::log, 9};
  scene.shading.significance.reset();
  scene.shading.knee = 0.6;
  scene.shading.specularColor = SpecularColor::light;
  scene.shading.reflection = Reflection::phong;
  scene.shading.twoSided = true;
  scene.shading.lightDirection = glm::dvec3(1, -1, 0.5);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.gradientSmoothing = 3.75;
  scene.shading.shadow = {0.85, 6.5};
  scene.shading.occlusion = {0.4, 15.25};
  scene.shading.physical = {2.5, -0.25, 0.5, 0.25, 1.5, 12.0, {0.125, 0.75}, -1.5, 77, UntilSeconds{12.5}};
  scene.gradientOpacity = GradientOpacity{{{0, 0}, {120.5, 1}}};
  scene.fog = {Fog::Mode::exp2, {0.1, 0.2, 0.3}, 0.004, 10, 900};
  scene.crop = {{0.1, 0, 0}, {1, 0.5, 0.75}};
  scene.projection = Projection::compositeIsosurface;
  scene.isovalue = 255.5;
  scene.quality = {0.125, Preintegration::never, 1.0, false, 0.75, 7, true};
  scene.image = {640, 480, {0, 0, 0}};
  return scene;
}

TEST(SceneFile, whatIsWrittenIsReadBackToTheLastBit) {
  const Scene scene = unusualScene();
  const SceneDocument document = parseScene(sceneToJson(scene, "a folder/b.nii.gz"), "test.json");
  EXPECT_EQ(document.scene, scene);
  EXPECT_EQ(document.volume, "a folder/b.nii.gz");
  EXPECT_TRUE(document.hasCamera);
  EXPECT_TRUE(document.hasTransferFunction);
}

TEST(SceneFile, whatAPictureSaysOfItsErrorChangesNoScene) {
  const Scene scene = unusualScene();
  const std::string text = sceneToJson(scene, "v", PictureAccuracy{0.5, "within half a level"});
  EXPECT_NE(text.find("within half a level"), std::string::npos);
  const std::string filtered =
      sceneToJson(scene, "v", PictureAccuracy{{}, "of paths", AccuracyOfPaths{24, 3.5, 2.0, 19.0}});
  EXPECT_EQ(parseScene(filtered, "test.json").scene, scene);
  EXPECT_EQ(filtered.find("within_levels"), std::string::npos) << "not known";
  for (const char* key :
       {"\"paths\"", "\"rms_levels\"", "\"filter_rms_levels\"", "\"filter_largest_levels\""})
    EXPECT_NE(filtered.find(key), std::string::npos) << key;
  EXPECT_EQ(parseScene(text, "test.json").scene, scene);
}

TEST(SceneFile, theSidesOfAPictureAreReadBackAndChangeNoScene) {
  SceneDocument document = documentOf(unusualScene(), "v");
  EXPECT_EQ(sceneToJson(document).find("shown"), std::string::npos);
  for (const ShownSides& sides :
       {ShownSides{}, ShownSides{CompareLayout::wipe, ShadingModel::robust, ShadingModel::none, 0.25}}) {
    document.sides = sides;
    EXPECT_EQ(parseScene(sceneToJson(document), "t"), document);
  }
}

// Whole, so that a scene with it is what stood there.
TEST(SceneFile, theLookAtTheLeftOfAPictureIsReadBack) {
  SceneDocument document = documentOf(unusualScene(), "v");
  Scene left = unusualScene();
  left.transferFunction = {1.0, {{-100.0, {1, 0, 0}, 0.0}, {500.0, {0, 1, 0}, 0.5}}};
  left.shading.model = ShadingModel::enhanced;
  left.shading.gradientSmoothing = 0.0;
  ShownSides& sides =
      document.sides.emplace(ShownSides{CompareLayout::sideBySide, ShadingModel::enhanced,
                                        unusualScene().shading.model, 0.5, presetOf(left, "CT skin")});
  sides.look->isWhole = true;
  EXPECT_EQ(parseScene(sceneToJson(document), "t"), document);
  EXPECT_EQ(withPreset(unusualScene(), *sides.look), left);
  sides.layout = CompareLayout::single;
  EXPECT_EQ(sceneToJson(document).find("CT skin"), std::string::npos) << "nothing stands beside it";
}

SceneDocument withViews(std::vector<NamedView> views) {
  SceneDocument document = documentOf(unusualScene(), "v");
  document.views = std::move(views);
  return document;
}

TEST(SceneFile, namedViewsAreReadBackToTheLastBit) {
  std::vector<NamedView> views{{"from the ear", unusualScene().camera}, {"Ohr \"ä\"\n", Camera{}}};
  EXPECT_EQ(parseScene(sceneToJson(withViews(views)), "t").views, views);
  for (int n = 0; n < 100; ++n) // long names, equal ones among them
    views.push_back({std::string(500, 'x'), unusualScene().camera});
  EXPECT_EQ(parseScene(sceneToJson(withViews(views)), "t"), withViews(views));
  EXPECT_EQ(sceneToJson(withViews({})).find("views"), std::string::npos);
  EXPECT_EQ(sceneToJson(unusualScene(), "v"), sceneToJson(withViews({})));
}

TEST(SceneFile, namedViewsThatSayNothingOrTooMuchAreRefusedByTheirPlace) {
  const auto refusal = [](const std::string& views) {
    return refusalOf(R"({"limn_scene": 1, "volume": "v", "views": )" + views + "}");
  };
  EXPECT_EQ(refusal(R"([{"name": "a", "camera": {}}])"), "accepted");
  EXPECT_EQ(refusal("[]"), "accepted");
  EXPECT_NE(refusal(R"({"name": "a"})").find("\"views\" must be a list"), std::string::npos);
  EXPECT_NE(refusal(R"(["a"])").find("views[0]"), std::string::npos);
  EXPECT_NE(refusal(R"([{"camera": {}}])").find("\"views[0].name\" is missing"), std::string::npos);
  EXPECT_NE(refusal(R"([{"name": "", "camera": {}}])").find("views[0].name"), std::string::npos);
  EXPECT_NE(refusal(R"([{"name": 3, "camera": {}}])").find("views[0].name"), std::string::npos);
  EXPECT_NE(refusal(R"([{"name": "a"}])").find("\"views[0].camera\" is missing"), std::string::npos);
  EXPECT_NE(refusal(R"([{"name": "a", "camera": 3}])").find("views[0].camera"), std::string::npos);
  EXPECT_NE(refusal(R"([{"name": "a", "camera": {}}, {"name": "b", "camera": {"fov_y_deg": 171}}])")
                .find("views[1].camera.fov_y_deg"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"name": "a", "camera": {}, "colour": 1}])").find("views[0].colour"),
            std::string::npos);
}

TEST(SceneFile, aLightDirectionMayHaveAnyLengthButNone) {
  Scene scene = unusualScene();
  for (const double length : {1e-300, 1e300}) {
    scene.shading.lightDirection = glm::dvec3(0.0, length, 0.0);
    EXPECT_EQ(parseScene(sceneToJson(scene, "v"), "test.json").scene, scene);
  }
  scene.shading.lightDirection = glm::dvec3(0.0);
  EXPECT_NE(refusalOf(sceneToJson(scene, "v")).find("light_direction"), std::string::npos);
}

TEST(SceneFile, lightOnItsWayIsReadAsDocumentedAndLeftOutWhereItIsNeutral) {
  const auto withShading = [](const std::string& shading) {
    return R"({"limn_scene": 1, "volume": "v", "shading": )" + shading + "}";
  };
  const auto shadingOf = [&](const std::string& shading) {
    return parseScene(withShading(shading), "test.json").scene.shading;
  };
  const Shading asked =
      shadingOf(R"({"light_direction": {"camera": [0.5, -0.5, 1]}, "shadow": {"strength": 0.85},
                                      "occlusion": {"strength": 1, "reach_mm": 7}})");
  EXPECT_EQ(asked.lightDirection, glm::dvec3(0.5, -0.5, 1.0));
  EXPECT_EQ(asked.lightAxes, LightAxes::camera);
  EXPECT_EQ(asked.shadow, (Shadow{0.85, 4.0}));
  EXPECT_EQ(asked.occlusion, (Occlusion{1.0, 7.0}));
  EXPECT_EQ(shadingOf(R"({"light_direction": [0, 1, 0]})").lightAxes, LightAxes::world);
  for (const auto& [shading, field] :
       {std::pair{R"({"shadow": {"strength": 1.5}})", "shading.shadow.strength"},
        std::pair{R"({"shadow": {"softness_deg": 46}})", "shading.shadow.softness_deg"},
        std::pair{R"({"shadow": {"blur": 1}})", "shading.shadow.blur"},
        std::pair{R"({"occlusion": {"strength": -0.1}})", "shading.occlusion.strength"},
        std::pair{R"({"occlusion": {"reach_mm": 0}})", "shading.occlusion.reach_mm"},
        std::pair{R"({"light_direction": {"camera": [0, 0, 0]}})", "shading.light_direction"},
        std::pair{R"({"light_direction": {"patient": [0, 0, 1]}})", "shading.light_direction.patient"}})
    EXPECT_NE(refusalOf(withShading(shading)).find(field), std::string::npos) << shading;
  Preset preset;
  preset.name = "from above";
  preset.transferFunction = unusualScene().transferFunction;
  preset.shading = unusualScene().shading;
  EXPECT_EQ(parsePreset(presetToJson(preset), "test.json").shading, preset.shading);
  const std::string neutral = sceneToJson(Scene{}, "v");
  EXPECT_EQ(neutral.find("shadow"), std::string::npos);
  EXPECT_EQ(neutral.find("occlusion"), std::string::npos);
}

TEST(SceneFile, theSmoothingOfNormalsIsReadAsDocumentedAndLeftOutWhereItIsNeutral) {
  const auto withSmoothing = [](const std::string& number) {
    return R"({"limn_scene": 1, "volume": "v", "shading": {"gradient_smoothing_mm": )" + number + "}}";
  };
  EXPECT_EQ(parseScene(withSmoothing("3.5"), "test.json").scene.shading.gradientSmoothing, 3.5);
  EXPECT_EQ(parseScene(withSmoothing("20"), "test.json").scene.shading.gradientSmoothing, 20.0);
  for (const char* number : {"-0.1", "20.1", "\"much\""})
    EXPECT_NE(refusalOf(withSmoothing(number)).find("shading.gradient_smoothing_mm"), std::string::npos)
        << number;
  EXPECT_NE(refusalOf(withSmoothing("21")).find("20"), std::string::npos); // the range is told
  Preset preset;
  preset.name = "smooth";
  preset.transferFunction = unusualScene().transferFunction;
  preset.shading = unusualScene().shading;
  EXPECT_EQ(parsePreset(presetToJson(preset), "test.json").shading->gradientSmoothing, 3.75);
  EXPECT_EQ(sceneToJson(Scene{}, "v").find("gradient_smoothing_mm"), std::string::npos);
}

TEST(SceneFile, physicalLightIsReadAsDocumentedAndLeftOutWhereItIsNeutral) {
  const auto withPhysical = [](const std::string& physical) {
    return R"({"limn_scene": 1, "volume": "v", "shading": {"model": "physical", "physical": )" + physical +
           "}}";
  };
  const auto lightOf = [&](const std::string& physical) {
    return parseScene(withPhysical(physical), "test.json").scene.shading.physical;
  };
  EXPECT_EQ(parseScene(withPhysical("{}"), "test.json").scene.shading.model, ShadingModel::physical);
  EXPECT_EQ(lightOf("{}"), PhysicalLight{});
  const PhysicalLight asked = lightOf(
      R"({"density": 100, "anisotropy": -0.95, "surface": 0, "specular_share": 1, "key_irradiance": 0,
          "key_radius_deg": 45, "sky": [0, 2], "exposure_ev": 3, "seed": 9, "until": {"levels": 0.5}})");
  EXPECT_EQ(asked, (PhysicalLight{100.0, -0.95, 0.0, 1.0, 0.0, 45.0, {0.0, 2.0}, 3.0, 9, UntilLevels{0.5}}));
  EXPECT_EQ(lightOf(R"({"until": {"seconds": 31536000}})").until, Until(UntilSeconds{31536000.0}));
  for (const auto& [physical, field] :
       {std::pair{R"({"density": 0.001})", "shading.physical.density"},
        std::pair{R"({"anisotropy": 1})", "shading.physical.anisotropy"},
        std::pair{R"({"surface": 1.1})", "shading.physical.surface"},
        std::pair{R"({"specular_share": -1})", "shading.physical.specular_share"},
        std::pair{R"({"key_irradiance": -1})", "shading.physical.key_irradiance"},
        std::pair{R"({"key_radius_deg": 46})", "shading.physical.key_radius_deg"},
        std::pair{R"({"sky": [0.1, -0.1]})", "shading.physical.sky"},
        std::pair{R"({"exposure_ev": 21})", "shading.physical.exposure_ev"},
        std::pair{R"({"seed": -1})", "shading.physical.seed"},
        std::pair{R"({"until": {"paths": 0}})", "shading.physical.until.paths"},
        std::pair{R"({"until": {"levels": 0}})", "shading.physical.until.levels"},
        std::pair{R"({"until": {"seconds": 0}})", "shading.physical.until.seconds"},
        std::pair{R"({"until": {"seconds": 1e9}})", "shading.physical.until.seconds"},
        std::pair{R"({"until": {"paths": 4, "seconds": 1}})", "shading.physical.until"},
        std::pair{R"({"until": {}})", "shading.physical.until"},
        std::pair{R"({"until": {"hours": 1}})", "shading.physical.until.hours"},
        std::pair{R"({"bounces": 4})", "shading.physical.bounces"}})
    EXPECT_NE(refusalOf(withPhysical(physical)).find(field), std::string::npos) << physical;
  EXPECT_EQ(sceneToJson(Scene{}, "v").find("physical"), std::string::npos);
  // A picture on its way carries the paths that it has.
  Scene drawn;
  drawn.shading.model = ShadingModel::physical;
  drawn.quality.paths = 12;
  const Scene again = parseScene(sceneToJson(drawn, "v"), "test.json").scene;
  EXPECT_EQ(again.shading.physical.until, Until(UntilPaths{12}));
  EXPECT_FALSE(again.quality.paths);
}

TEST(SceneFile, aToleranceNeedsNoFinenessButAFinenessATolerance) {
  const auto withQuality = [](const std::string& quality) {
    return R"({"limn_scene": 1, "volume": "v", "quality": )" + quality + "}";
  };
  const Quality read = parseScene(withQuality(R"({"tolerance_levels": 0.5})"), "test.json").scene.quality;
  EXPECT_EQ(read.toleranceLevels, 0.5);
  EXPECT_FALSE(read.fineness);
  EXPECT_NE(refusalOf(withQuality(R"({"fineness": 4})")).find("tolerance_levels"), std::string::npos);
  EXPECT_NE(refusalOf(withQuality(R"({"tolerance_levels": 0})")).find("tolerance_levels"), std::string::npos);
  EXPECT_NE(refusalOf(withQuality(R"({"tolerance_levels": 1, "fineness": 99})")).find("24"),
            std::string::npos);
}

TEST(SceneFile, missingKeysTakeTheDefaultsOfTheDefinition) {
  const SceneDocument document = parseScene(R"({"limn_scene": 1, "volume": "v.nii"})", "test.json");
  Scene defaults;
  EXPECT_EQ(document.scene, defaults);
  EXPECT_FALSE(document.hasCamera);
  EXPECT_FALSE(document.hasTransferFunction);
}

std::string withKeep(const std::string& keep) {
  return R"({"limn_scene": 1, "volume": "v", "keep": )" + keep + "}";
}

TEST(SceneFile, whatIsKeptIsReadBack) {
  EXPECT_EQ(parseScene(withKeep(R"("all")"), "t").keep, KeptPart{});
  EXPECT_EQ(parseScene(withKeep(R"("body")"), "t").keep.kind, Region::Kind::body);
  const KeptPart labels{Region::Kind::labels, "a/seg.nrrd", {{-2, 1.0}, {3, 0.0}, {4, 0.25}}, {}};
  EXPECT_EQ(
      parseScene(withKeep(R"({"labels": "a/seg.nrrd", "weights": {"3": 0, "4": 0.25, "-2": 1}})"), "t").keep,
      labels);
  // What is written of a region: its weights but for those that are 1 anyway.
  Scene scene;
  scene.keep = {Region::Kind::labels,
                "seg.nrrd",
                std::make_shared<const LabelMap>(glm::ivec3(1), std::vector<std::uint8_t>{0},
                                                 std::vector<Label>{{0, "", {}}, {3, "", {}}, {7, "", {}}}),
                {1.0, 0.1, 1.0}};
  const KeptPart written{Region::Kind::labels, "seg.nrrd", {{3, 0.1}}, {}};
  EXPECT_EQ(parseScene(sceneToJson(scene, "v"), "t").keep, written);
  scene.keep = bodyRegion(glm::ivec3(1), std::vector<std::uint8_t>{1});
  EXPECT_EQ(parseScene(sceneToJson(scene, "v"), "t").keep, (KeptPart{Region::Kind::body, "", {}, {}}));
}

TEST(SceneFile, masksInSeveralFilesAreReadBack) {
  const KeptPart masks{Region::Kind::labels, "a.nrrd", {{2, 0.5}}, {}, {}, false, {"b/c.nrrd"}};
  EXPECT_EQ(parseScene(withKeep(R"({"labels": ["a.nrrd", "b/c.nrrd"], "weights": {"2": 0.5}})"), "t").keep,
            masks);
  Scene scene;
  scene.keep = {Region::Kind::labels,
                "a.nrrd",
                std::make_shared<const LabelMap>(glm::ivec3(1), std::vector<std::uint8_t>{0},
                                                 std::vector<Label>{{0, "", {}}, {1, "", {}}, {2, "", {}}}),
                {1.0, 1.0, 0.5}};
  scene.keep.moreSources = {"b/c.nrrd"};
  EXPECT_EQ(parseScene(sceneToJson(scene, "v"), "t").keep, masks);
  SceneDocument document;
  document.keep = masks;
  EXPECT_EQ(located(document, "/scans/s.limn.json").keep.moreLabels,
            std::vector<std::string>{"/scans/b/c.nrrd"});
}

TEST(SceneFile, looksOfLabelsAreReadBackAloneAndBesideCuts) {
  const TransferFunction bone{2.5, {{200.0, {1.0, 0.9, 0.8}, 0.0}, {900.0, {1.0, 1.0, 1.0}, 0.75}}};
  const TransferFunction vessel{1.0, {{100.0, {0.9, 0.1, 0.1}, 0.0}, {350.0, {1.0, 0.3, 0.2}, 0.5}}};
  Scene scene;
  const Region labels{Region::Kind::labels,
                      "seg.nrrd",
                      std::make_shared<const LabelMap>(
                          glm::ivec3(1), std::vector<std::uint8_t>{0},
                          std::vector<Label>{{0, "", {}}, {3, "", {}}, {-7, "", {}}, {9, "", {}}}),
                      {1.0, 0.5, 1.0, 1.0}};
  scene.keep = withLooks(labels, {{1, bone}, {2, vessel}, {3, bone}});
  EXPECT_EQ(scene.keep.looks.size(), 2u) << "equal looks are one";
  const KeptPart read = parseScene(sceneToJson(scene, "v"), "t").keep;
  EXPECT_EQ(
      read,
      (KeptPart{Region::Kind::labels, "seg.nrrd", {{3, 0.5}}, {}, {{3, bone}, {-7, vessel}, {9, bone}}}));
  EXPECT_EQ(withLooksOf(labels, read.looks, "seg.nrrd"), scene.keep);
  // In the list of what is kept and of cuts, with what a person leaves out.
  const KeptPart typed =
      parseScene(withKeep(R"([{"labels": "s", "looks": {"3": {"points": [{"value": 5, "opacity": 0.5}]}}},
                              {"piece": {"seed_mm": [1, 2, 3], "range": [5, 9]}}])"),
                 "t")
          .keep;
  EXPECT_EQ(typed.looks, (std::map<int, TransferFunction>{{3, {1.0, {{5.0, glm::dvec3(1.0), 0.5}}}}}));
  EXPECT_EQ(typed.cuts.size(), 1u);
}

TEST(SceneFile, aLookNeedsItsLabelAndOnlySoManyMayDiffer) {
  std::vector<Label> labels;
  for (int value = 0; value < 40; ++value)
    labels.push_back({value, "", {}});
  Region region{Region::Kind::labels, "s",
                std::make_shared<const LabelMap>(glm::ivec3(1), std::vector<std::uint8_t>{0}, labels),
                std::vector<double>(40, 1.0)};
  std::map<int, TransferFunction> looks;
  for (int value = 0; value < 32; ++value)
    looks[value] = {1.0 + value, {}};
  EXPECT_EQ(withLooksOf(region, looks, "s").looks.size(), 32u);
  looks[33] = looks[32] = looks[31]; // no other look
  EXPECT_EQ(withLooksOf(region, looks, "s").looks.size(), 32u);
  looks[33].unitDistanceMm = 0.5;
  const auto refusalOfLooks = [&region](const std::map<int, TransferFunction>& wanted) -> std::string {
    try {
      withLooksOf(region, wanted, "seg.nrrd");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusalOfLooks(looks).find("more than 32 different looks"), std::string::npos);
  EXPECT_NE(refusalOfLooks({{41, {1.0, {}}}}).find("look to label 41, which seg.nrrd does not have"),
            std::string::npos);
}

TEST(SceneFile, cutsAreReadBackInTheirOrderBesideWhatTheyCut) {
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  camera.position = {1.0, -200.5, 3.0};
  camera.heightMm = 123.25;
  const Scissors scissors{camera, 1.5, {{0.1, 0.2}, {0.5, -0.25}, {-0.75, 0.0}}, false, glm::dvec2(10, 250)};
  const Scissors inside{camera, 0.75, {{0, 0}, {1, 0}, {0, 1}}, true, {}};
  const ConnectedPiece piece{{4.5, 5.0, -6.0}, {226.0, 3071.0}, 2, ConnectedPiece::Fate::alone};
  const TransferFunction look{2.5, {{100.0, {1.0, 0.0, 0.25}, 0.5}, {300.0, {0.0, 1.0, 0.0}, 1.0}}};
  const ConnectedPiece red{{0.0, 1.0, 2.0}, {-1.0, 1.0}, 1, ConnectedPiece::Fate::ownLook, look};
  const std::vector<Cut> cuts{{scissors, true}, {piece, false}, {inside, true}, {red, true}};
  for (const Region::Kind kind : {Region::Kind::all, Region::Kind::body, Region::Kind::labels}) {
    Scene scene;
    scene.keep.kind = kind;
    scene.keep.source = kind == Region::Kind::labels ? "seg.nrrd" : "";
    scene.keep.cuts = cuts;
    const KeptPart read = parseScene(sceneToJson(scene, "v"), "t").keep;
    EXPECT_EQ(read, (KeptPart{kind, scene.keep.source, {}, cuts}));
  }
  // What a person leaves out: the whole depth, hidden, grown by one voxel, on.
  const KeptPart typed = parseScene(withKeep(R"(["body", {"piece": {"seed_mm": [1, 2, 3], "range": [5, 9]}},
                                                {"scissors": {"camera": {}, "polygon": [[0,0],[1,0],[0,1]]}}])"),
                                    "t")
                             .keep;
  EXPECT_EQ(typed.kind, Region::Kind::body);
  ASSERT_EQ(typed.cuts.size(), 2u);
  EXPECT_EQ(typed.cuts[0], (Cut{ConnectedPiece{{1, 2, 3}, {5, 9}, 1, ConnectedPiece::Fate::hidden}, true}));
  EXPECT_EQ(typed.cuts[1], (Cut{Scissors{Camera(), 1.0, {{0, 0}, {1, 0}, {0, 1}}, true, {}}, true}));
}

TEST(SceneFile, keepsTheBodyBesideASegmentationAndNamesOfCuts) {
  Cut cut{ConnectedPiece{{1.0, 2.0, 3.0}, {100.0, 200.0}}, true, "kn\u00f6cherner Kiefer"};
  const KeptPart both{Region::Kind::labels, "seg.nrrd", {{3, 0.5}}, {cut}, {}, true};
  const std::string text = R"(["body", {"labels": "seg.nrrd", "weights": {"3": 0.5}},
      {"piece": {"seed_mm": [1, 2, 3], "range": [100, 200]}, "name": "kn\u00f6cherner Kiefer"}])";
  EXPECT_EQ(parseScene(withKeep(text), "t").keep, both);
  const std::string turned = R"([{"labels": "seg.nrrd", "weights": {"3": 0.5}}, "body",
      {"piece": {"seed_mm": [1, 2, 3], "range": [100, 200]}, "name": "kn\u00f6cherner Kiefer"}])";
  EXPECT_EQ(parseScene(withKeep(turned), "t").keep, both) << "they multiply, in either order";

  Scene scene;
  const Region labels{Region::Kind::labels,
                      "seg.nrrd",
                      std::make_shared<const LabelMap>(glm::ivec3(2, 1, 1), std::vector<std::uint8_t>{1, 0},
                                                       std::vector<Label>{{0, "", {}}, {3, "", {}}}),
                      {1.0, 0.5}};
  scene.keep = withBody(labels, bodyRegion({2, 1, 1}, std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(keptPartOf(scene.keep), (KeptPart{Region::Kind::labels, "seg.nrrd", {{3, 0.5}}, {}, {}, true}));
  scene.volume = nullptr;
  EXPECT_EQ(parseScene(sceneToJson(documentOf(scene, "v.nrrd")), "t").keep, keptPartOf(scene.keep));
}

TEST(SceneFile, keepsHowFarAPieceReaches) {
  const KeptPart kept =
      parseScene(withKeep(R"([{"piece": {"seed_mm": [1, 2, 3], "range": [5, 9], "reach_mm": 14}}])"), "t")
          .keep;
  ConnectedPiece piece{{1, 2, 3}, {5, 9}};
  piece.reachMm = 14.0;
  ASSERT_EQ(kept.cuts, std::vector<Cut>{{piece}});
  Scene scene;
  scene.keep.cuts = kept.cuts;
  EXPECT_EQ(parseScene(sceneToJson(documentOf(scene, "v.nrrd")), "t").keep.cuts, kept.cuts);
}

TEST(SceneFile, whatIsKeptIsRefusedWhereItMakesNoSense) {
  for (const auto& [keep, named] : std::map<std::string, std::string>{
           {R"("head")", "\"body\""},
           {R"(3)", "keep"},
           {R"({"weights": {}})", "keep.labels"},
           {R"({"labels": ""})", "keep.labels"},
           {R"({"labels": []})", "keep.labels"},
           {R"({"labels": ["s", 3]})", "keep.labels"},
           {R"({"labels": ["s", ""]})", "keep.labels"},
           {R"({"labels": "s", "weights": {"3": 1.5}})", "keep.weights.3"},
           {R"({"labels": "s", "weights": {"3": "half"}})", "keep.weights.3"},
           {R"({"labels": "s", "weights": {"bone": 1}})", "keep.weights.bone"},
           {R"({"labels": "s", "weights": [1]})", "keep.weights"},
           {R"({"labels": "s", "looks": {"bone": {"points": []}}})", "keep.looks.bone"},
           {R"({"labels": "s", "looks": {"3": {"unit_distance_mm": 1}}})", "keep.looks.3.points"},
           {R"({"labels": "s", "looks": {"3": {"points": [], "unit_distance_mm": 0}}})",
            "keep.looks.3.unit_distance_mm"},
           {R"({"labels": "s", "looks": {"3": {"points": [{"opacity": 1}]}}})",
            "keep.looks.3.points[0].value"},
           {R"({"labels": "s", "looks": {"3": {"points": [{"value": 1, "opacity": 2}]}}})",
            "keep.looks.3.points[0].opacity"},
           {R"([{"labels": "s", "looks": {"3": {"points": 4}}}])", "keep[0].looks.3"},
           {R"({"labels": "s", "looks": {"3": {"points": [], "colour": 1}}})", "keep.looks.3.colour"},
           {R"(["body", {"labels": "s"}, "body"])", "twice"},
           {R"([{"labels": "s"}, {"labels": "t"}])", "twice"},
           {R"(["head"])", "keep"},
           {R"([{}])", "keep[0].scissors"},
           {R"([{"scissors": {"polygon": [[0,0],[1,0],[0,1]]}}])", "camera"},
           {R"([{"scissors": {"camera": {}, "polygon": [[0,0],[1,0]]}}])", "keep[0].scissors.polygon"},
           {R"([{"scissors": {"camera": {}, "polygon": [[0,0],[1,0],[0]]}}])", "keep[0].scissors.polygon"},
           {R"(["body", {"piece": {"range": [0, 1]}}])", "keep[1].piece.seed_mm"},
           {R"([{"piece": {"seed_mm": [0,0,0]}}])", "keep[0].piece.range"},
           {R"([{"piece": {"seed_mm": [0,0,0], "range": [0,1], "do": "eat"}}])", "hide, only"},
           {R"([{"piece": {"seed_mm": [0,0,0], "range": [0,1], "reach_mm": 0}}])", "keep[0].piece.reach_mm"},
           {R"([{"piece": {"seed_mm": [0,0,0], "range": [0,1], "do": "look"}}])", "keep[0].piece.look"},
           {R"([{"piece": {"seed_mm": [0,0,0], "range": [0,1], "look": {"points": []}}}])",
            "keep[0].piece.look"},
           {R"([{"piece": {"seed_mm": [0,0,0], "range": [0,1], "do": "look", "look": {"points": [{}]}}}])",
            "keep[0].piece.look.points[0].value"},
           {R"({"labels": "s", "wieghts": {}})", "keep.wieghts"}}) {
    const std::string refusal = refusalOf(withKeep(keep));
    EXPECT_NE(refusal.find(named), std::string::npos) << keep << ": " << refusal;
  }
}

TEST(SceneFile, aWeightNeedsItsLabel) {
  const std::vector<Label> labels{{0, "", {}}, {3, "", {}}};
  EXPECT_EQ(weightsOf(labels, {{3, 0.5}}, "seg.nrrd"), (std::vector<double>{1.0, 0.5}));
  try {
    weightsOf(labels, {{3, 0.5}, {4, 0.0}}, "seg.nrrd");
    FAIL() << "label 4 is not there";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("label 4, which seg.nrrd does not have"), std::string::npos)
        << error.what();
  }
}

TEST(SceneFile, refusesUnknownKeysByName) {
  EXPECT_NE(
      refusalOf(R"({"limn_scene": 1, "volume": "v", "shading": {"exponnent": 3}})").find("shading.exponnent"),
      std::string::npos);
}

TEST(SceneFile, refusesNumbersOutsideTheirRangeWithTheRange) {
  const std::string refusal = refusalOf(R"({"limn_scene": 1, "volume": "v", "shading": {"exponent": 5000}})");
  EXPECT_NE(refusal.find("1024"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("5000"), std::string::npos) << refusal;
}

TEST(SceneFile, saysWhichPointOfACurveIsWrong) {
  const std::string refusal = refusalOf(
      R"({"limn_scene": 1, "volume": "v", "transfer_function":
          {"points": [{"value": 0, "opacity": 0.5}, {"value": 1, "opacity": "high"}]}})");
  EXPECT_NE(refusal.find("transfer_function.points[1].opacity"), std::string::npos) << refusal;
}

TEST(SceneFile, refusesWhatIsNotASceneInOneSentence) {
  for (const char* text :
       {"", "[]", "{", "{\"limn_scene\": 2, \"volume\": \"v\"}", "{\"volume\": \"v\"}", "{\"limn_scene\": 1}",
        "{\"limn_scene\": 1, \"volume\": 7}", R"({"limn_scene": 1, "volume": "v", "camera": []})",
        R"({"limn_scene": 1, "volume": "v", "transfer_function": {"points": [{"opacity": 1}]}})",
        R"({"limn_scene": 1, "volume": "v", "shading": {"exponent_range": [9, 3]}})",
        R"({"limn_scene": 1, "volume": "v", "crop": {"lower": [0.5,0,0], "upper": [0.5,1,1]}})"}) {
    const std::string refusal = refusalOf(text);
    EXPECT_NE(refusal, "accepted") << text;
    EXPECT_NE(refusal.find("test.json"), std::string::npos) << refusal;
  }
}

TEST(SceneFile, writesAsciiOnly) {
  const std::string text = sceneToJson(Scene{}, "Schädel.nii");
  for (const char c : text)
    EXPECT_GE(c, 0);
  EXPECT_EQ(parseScene(text, "t").volume, "Schädel.nii");
}

TEST(PresetFile, whatIsWrittenIsReadBack) {
  const Preset preset{.name = "Knochen",
                      .modality = "CT",
                      .note = "Bone in warm colours",
                      .folder = "Heads",
                      .transferFunction = unusualScene().transferFunction,
                      .gradientOpacity = GradientOpacity{{{0.5, 0.25}, {80.0, 1.0 / 3.0}}},
                      .shading = unusualScene().shading,
                      .projection = Projection::compositeIsosurface,
                      .isovalue = 123.456789,
                      .landmarks = Landmarks{0.0, 0.1, 99.9}};
  EXPECT_EQ(parsePreset(presetToJson(preset), "p"), preset);
}

TEST(SceneFile, anOrientationGivenByHandIsKeptAndOthersAreRefused) {
  Scene scene;
  VolumeInfo info;
  info.orientationByHand = "RAS";
  scene.volume = std::make_shared<const Volume>(Grid{{1, 1, 1}}, std::vector<std::uint8_t>{1}, Rescale{},
                                                std::nullopt, info);
  EXPECT_EQ(parseScene(sceneToJson(scene, "v"), "test.json").orientation, "RAS");
  EXPECT_EQ(sceneToJson(Scene{}, "v").find("orientation"), std::string::npos);
  EXPECT_NE(refusalOf(R"({"limn_scene": 1, "volume": "v", "orientation": "LLS"})").find("three letters"),
            std::string::npos);
}

} // namespace
} // namespace limn
