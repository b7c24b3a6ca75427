// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions about accuracy in whole pictures: the defaults are the program's own, every other is valid
// everywhere, and stored gradients are as good as the fetched ones where they are claimed to be.
#include "accuracy/ImageError.h"
#include "glsl/decisions/Decisions.h"
#include "glsl/programs/ShaderVariant.h"
#include "raycaster/RayCaster.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/Places.h"
#include "support/TestData.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>

namespace limn {
namespace {

constexpr glm::ivec2 decisionsSize{96, 96};

const EffectSet lit{Effect::lighting,    Effect::diffuse,          Effect::specular,
                    Effect::exponentMap, Effect::opacityMap,       Effect::emptySpaceSkipping,
                    Effect::cutFaces,    Effect::earlyTermination, Effect::fogExp};

// Sets that differ in the blocks beside those that decisions replace.
std::vector<EffectSet> assortedSets() {
  std::vector<EffectSet> sets;
  for (const EffectSet& extra :
       {EffectSet{}, EffectSet{Effect::longRays}, EffectSet{Effect::preintegration},
        EffectSet{Effect::jitter}, EffectSet{Effect::denseFunctions}, EffectSet{Effect::xray},
        EffectSet{Effect::isosurface}, EffectSet{Effect::hybrid}, EffectSet{Effect::mip},
        EffectSet{Effect::average}, EffectSet{Effect::gradientOpacity}, EffectSet{Effect::unlimited}}) {
    sets.push_back(canonical(lit.with(extra)));
    sets.push_back(canonical(extra.with(Effect::emptySpaceSkipping)));
  }
  return sets;
}

std::vector<Decisions> otherDecisions() {
  std::vector<Decisions> all;
  for (const DecisionVariant& variant : decisionVariants())
    if (!(variant.decisions == Decisions{}))
      all.push_back(variant.decisions);
  // And all at once, with what only tests decide.
  all.push_back({TableFormat::bytes256, VolumeFormat::r8, SamplePlace::front, GradientFormat::directions,
                 ClassificationOrder::beforeInBytes, FilterWeights::eightBits});
  return all;
}

RayCaster casterWith(const Decisions& decisions,
                     RayCaster::EmptySpace emptySpace = RayCaster::EmptySpace::skipped) {
  return RayCaster(emptySpace, RayCaster::Programs::specialised, decisions);
}

Scene unintegratedPhantom(ShadingModel model) {
  Scene scene = test::headScene(phantomVolume({.spacingMm = 4.0, .noiseHu = 15.0}), model);
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

using DecisionPictures = test::GlTest;

TEST(DecisionText, theProgramsOwnDecisionsUseTheProgramsOwnBlocksOnly) {
  std::set<std::string> replacing;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::sourceFolder() / "shaders" / "decisions"))
    replacing.insert(entry.path().filename().string());
  ASSERT_FALSE(replacing.empty());
  std::set<std::string> used;
  for (const EffectSet& effects : assortedSets()) {
    const ShaderSource own = fragmentSource(effects, Decisions{});
    EXPECT_EQ(own.text, fragmentSource(effects).text);
    EXPECT_EQ(own.text.find("DECISION"), std::string::npos);
    for (const ShaderSource::Line& line : own.lines)
      EXPECT_FALSE(replacing.contains(line.file)) << line.file;
    for (const Decisions& decisions : otherDecisions())
      for (const ShaderSource::Line& line : fragmentSource(effects, decisions).lines)
        used.insert(line.file);
  }
  for (const std::string& file : replacing)
    EXPECT_TRUE(used.contains(file)) << file << " is used by no decision";
}

TEST(DecisionText, everyDecisionIsValidGlsl130) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs glslangValidator (Debian package glslang-tools), which this machine does not have";
  const auto folder = test::buildFolder() / "decision_variants";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  int count = 0;
  for (const EffectSet& effects : assortedSets())
    for (const Decisions& decisions : otherDecisions())
      std::ofstream(folder / (std::to_string(++count) + ".frag")) << fragmentSource(effects, decisions).text;
  const std::string log = (folder / "log.txt").string();
  const std::string command = "cd '" + folder.string() + "' && glslangValidator *.frag > '" + log + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << "see " << log;
  std::cout << count << " programs validated\n";
}

TEST(DecisionLists, everyGroupHoldsTheProgramsOwnDecisionOnce) {
  std::map<std::string, int> own;
  for (const DecisionVariant& variant : decisionVariants()) {
    own[variant.group] += variant.isDefault ? 1 : 0;
    if (variant.isDefault) {
      EXPECT_EQ(variant.decisions, Decisions{}) << variant.name;
      EXPECT_EQ(variant.earlyTermination.value_or(Quality{}.earlyTermination), Quality{}.earlyTermination);
    }
  }
  EXPECT_EQ(own.size(), 7u);
  for (const auto& [group, count] : own)
    EXPECT_EQ(count, 1) << group;
}

TEST(DecisionLists, aPictureIsMeasuredOnlyByWhatCanShowInIt) {
  const auto groupsOf = [](Projection projection, EffectSet effects) {
    Scene scene;
    scene.projection = projection;
    std::set<std::string> groups;
    for (const DecisionVariant& variant : decisionVariants(scene, effects))
      groups.insert(variant.group);
    return groups;
  };
  EXPECT_EQ(groupsOf(Projection::composite, {Effect::gradient}).size(), 7u);
  EXPECT_FALSE(groupsOf(Projection::composite, {}).contains("gradient"));
  EXPECT_EQ(groupsOf(Projection::mip, {}),
            (std::set<std::string>{"look-up table", "volume texture", "sample in its step"}));
  EXPECT_FALSE(groupsOf(Projection::xray, {}).contains("early termination"));
}

TEST_F(DecisionPictures, theDefaultsDrawThePictureOfToday) {
  const Scene scene = unintegratedPhantom(ShadingModel::enhanced);
  RayCaster own;
  RayCaster stated = casterWith({});
  EXPECT_EQ(own.render(scene, decisionsSize), stated.render(scene, decisionsSize));
  EXPECT_EQ(own.fragmentShader(scene), stated.fragmentShader(scene));
  // Volume texels alone, 4 bytes each, the apron included.
  const glm::dvec3 size(scene.volume->grid().dims + 2);
  EXPECT_DOUBLE_EQ(own.volumeMb(), 4e-6 * size.x * size.y * size.z);
}

TEST_F(DecisionPictures, everyOtherDecisionShowsAndSkippingEmptySpaceChangesNone) {
  const Scene scene = unintegratedPhantom(ShadingModel::enhanced);
  RayCaster own;
  const Image picture = own.render(scene, decisionsSize);
  for (const DecisionVariant& variant : decisionVariants()) {
    if (variant.decisions == Decisions{})
      continue;
    SCOPED_TRACE(variant.group + ", " + variant.name);
    RayCaster skipping = casterWith(variant.decisions);
    RayCaster sampling = casterWith(variant.decisions, RayCaster::EmptySpace::sampled);
    const Image other = skipping.render(scene, decisionsSize);
    EXPECT_NE(other, picture);
    EXPECT_EQ(other, sampling.render(scene, decisionsSize)) << "skipping empty space changes the picture";
  }
}

TEST_F(DecisionPictures, whatIsStoredFollowsTheScene) {
  const Scene first = unintegratedPhantom(ShadingModel::enhanced);
  Scene edited = first;
  edited.transferFunction = test::boneOnly();
  Scene stepped = edited;
  stepped.quality.stepVoxels = 0.5;
  Scene other = stepped;
  other.volume = phantomVolume({.spacingMm = 5.0});
  for (const Decisions& decisions : otherDecisions()) {
    RayCaster caster = casterWith(decisions);
    for (const Scene& scene : {first, edited, stepped, other})
      EXPECT_EQ(caster.render(scene, decisionsSize), casterWith(decisions).render(scene, decisionsSize));
  }
}

// Halves round each component of a vector by at most 2^-11 of itself (eleven binary digits), so where the
// eight vectors around a sample agree, the normal turns by less than 2^-11. A colour then changes by less
// than 2^-11 times the steepness of light over the angle: kd for the diffuse term and, for the specular one,
// ks·max|d cos^n/dφ| < ks·sqrt(n)·e^(-1/2)·1.01 for n > 10. Opposed vectors cancel and leave a larger part,
// at which few pixels lie: hence the 99.9th percentile. Enhanced changes opacities by 2^-11 of themselves
// as well, which moves a pixel by less than the same again: hence twice the bound.
double boundOfHalves(const Shading& shading) {
  const double sharpest =
      shading.model == ShadingModel::classic ? shading.exponent : shading.exponentRange.atBoundary;
  const double steepest = shading.diffuse + shading.specular * std::sqrt(sharpest) * std::exp(-0.5) * 1.01;
  return 255.0 * 0x1p-11 * steepest * (shading.model == ShadingModel::classic ? 1.0 : 2.0);
}

void compareStoredGradients(const Scene& scene, const glm::ivec2& size) {
  const Image own = RayCaster().render(scene, size);
  const auto differenceOf = [&](GradientFormat format) {
    return imageError(casterWith({.gradients = format}).render(scene, size), own);
  };
  const ImageError halves = differenceOf(GradientFormat::halves);
  const ImageError bytes = differenceOf(GradientFormat::directions);
  const double bound = boundOfHalves(scene.shading);
  std::cout << "from gradients on the fly, levels: halves " << halves.p99_9 << " (mean " << halves.mean
            << "), bytes " << bytes.p99_9 << " (mean " << bytes.mean << "); bound of halves " << bound
            << "\n";
  EXPECT_LE(halves.p99_9, bound);
  EXPECT_LE(halves.mean, bound / 10.0);
  // A component of a direction is up to 1/255 off in bytes and 1/2048 in halves, mostly far less.
  EXPECT_GE(bytes.mean, 2048.0 / 255.0 * halves.mean);
}

TEST_F(DecisionPictures, gradientsStoredInHalvesEqualThoseOnTheFly) {
  compareStoredGradients(unintegratedPhantom(ShadingModel::classic), decisionsSize);
  compareStoredGradients(unintegratedPhantom(ShadingModel::enhanced), decisionsSize);
}

TEST_F(DecisionPictures, gradientsStoredInHalvesEqualThoseOnTheFlyOnTheCtHead) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  Scene scene = test::headScene(test::ctHead(), ShadingModel::enhanced);
  scene.quality.preintegrated = Preintegration::never;
  compareStoredGradients(scene, {128, 128});
}

} // namespace
} // namespace limn
