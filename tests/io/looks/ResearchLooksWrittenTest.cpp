// SPDX-License-Identifier: GPL-3.0-or-later
// Looks as Inviwo, MITK, MRIcroGL, niivue and ImageVis3D get them, read back.
#include "CurveOf.h"

namespace limn {
namespace {

using test::ctTarget;
using test::expectCurve;
using test::isTold;
using test::readBack;
using test::Rgba;
using test::stretched;

Preset somePreset() {
  Preset preset;
  preset.name = "some look";
  preset.transferFunction.points = {{-250.125, {0.1, 0.2, 0.3}, 0.0},
                                    {40.0, {1.0 / 3.0, 0.5, 0.75}, 0.0625},
                                    {40.0, {1.0, 0.5, 0.25}, 0.3},
                                    {1200.7, {1.0, 1.0, 0.9}, 0.7}};
  return preset;
}

void expectSame(const TransferFunction& read, const TransferFunction& written, double tolerance) {
  expectCurve(read, written.points.front().value, written.points.back().value, tolerance, [&](double x) {
    const Classified seen = classify(written, x);
    return Rgba{seen.color.r, seen.color.g, seen.color.b, seen.opacity};
  });
}

TEST(ResearchLooks, whatInviwoGetsReadsAgainEqual) {
  const Preset preset = somePreset();
  const ReadLook read = readBack(preset, "some look.itf");
  EXPECT_EQ(read.preset.transferFunction, preset.transferFunction);
  EXPECT_TRUE(read.changes.empty());
  EXPECT_TRUE(lookAs("a.itf", preset).changes.empty());
}

TEST(ResearchLooks, whatMitkGetsReadsAgainEqual) {
  Preset preset = somePreset();
  preset.gradientOpacity = GradientOpacity{{{3.0, 0.25}, {77.7, 1.0}}};
  const ReadLook read = readBack(preset, "some look.mitk.xml", ctTarget);
  // It keeps one point of each value: the left one of a step lies at the number before.
  const auto& points = read.preset.transferFunction.points;
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[1].value, std::nextafter(40.0, 0.0));
  EXPECT_EQ(points[2].value, 40.0);
  expectSame(read.preset.transferFunction, preset.transferFunction, 1e-12);
  ASSERT_TRUE(read.preset.gradientOpacity);
  ASSERT_EQ(read.preset.gradientOpacity->points.size(), 2u);
  EXPECT_NEAR(read.preset.gradientOpacity->points[1].gradient, 77.7, 1e-9);
  EXPECT_EQ(read.preset.gradientOpacity->points[0].opacity, 0.25);
  preset.gradientOpacity.reset();
  EXPECT_TRUE(lookAs("a.mitk.xml", preset).changes.empty());
}

TEST(ResearchLooks, bytesReadAgainEqualUpToTheirLevels) {
  for (const char* file : {"some look.clut", "some look.niivue.json"}) {
    const Preset preset = somePreset();
    const WrittenLook written = lookAs(file, preset);
    EXPECT_TRUE(isTold(written.changes, "256 places")) << file;
    EXPECT_TRUE(isTold(written.changes, "256 levels")) << file;
    const TransferFunction read = parseLooks(written.text, file).front().preset.transferFunction;
    ASSERT_EQ(read.points.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const ControlPoint& was = preset.transferFunction.points[i];
      EXPECT_NEAR(read.points[i].value, was.value, 0.5 / 255.0 * (1200.7 + 250.125) + 1e-9);
      EXPECT_NEAR(read.points[i].opacity, was.opacity, 0.5 / 255.0 + 1e-9);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(read.points[i].color[channel], was.color[channel], 0.5 / 255.0 + 1e-9);
    }
    EXPECT_EQ(read.points[1].value, read.points[2].value) << "the step stays one";
    // What they hold exactly stays exact.
    Preset exact;
    exact.name = "some look";
    exact.transferFunction = read;
    EXPECT_EQ(readBack(exact, file).preset.transferFunction, read);
    EXPECT_TRUE(lookAs(file, exact).changes.empty());
  }
}

TEST(ResearchLooks, aTableReadsAgainWithinItsLevels) {
  Preset preset;
  preset.name = "some look";
  // Points that lie on rows.
  preset.transferFunction.points = {{stretched(0.2), {0.1, 0.2, 0.3}, 0.0},
                                    {stretched(0.8), {1, 1, 0.9}, 0.7}};
  const WrittenLook written = lookAs("some look.1dt", preset, ctTarget);
  EXPECT_TRUE(written.changes.empty());
  const ReadLook read = parseLooks(written.text, "some look.1dt", ctTarget).front();
  expectSame(read.preset.transferFunction, preset.transferFunction, 1.0 / 255.0);
  EXPECT_TRUE(isTold(lookAs("a.1dt", somePreset(), ctTarget).changes, "256 rows"));
  EXPECT_THROW(lookAs("a.1dt", preset), Error);
}

TEST(ResearchLooks, whatIsLeftOutIsTold) {
  Preset preset = somePreset();
  preset.shading = Shading{};
  preset.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {10.0, 1.0}}};
  preset.projection = Projection::mip;
  preset.transferFunction.unitDistanceMm = 2.0;
  for (const char* file : {"a.itf", "a.clut", "a.niivue.json", "a.1dt"}) {
    const std::vector<Message> changes = lookAs(file, preset, ctTarget).changes;
    for (const char* words : {"Light", "by gradient", "projection", "2 mm"})
      EXPECT_TRUE(isTold(changes, words)) << file << ": " << words;
  }
}

TEST(ResearchLooks, emptyAndFlatFunctionsAreWritten) {
  for (const char* file : {"a.itf", "a.mitk.xml", "a.clut", "a.niivue.json"}) {
    Preset preset;
    preset.name = "a";
    EXPECT_EQ(largestOpacityWithin(readBack(preset, file).preset.transferFunction, -1e9, 1e9), 0.0) << file;
    preset.transferFunction.points = {{7.0, {0, 0, 0}, 0.0}, {7.0, {1, 1, 1}, 1.0}};
    const TransferFunction read = readBack(preset, file).preset.transferFunction;
    EXPECT_EQ(classify(read, 6.9).opacity, 0.0) << file;
    EXPECT_EQ(classify(read, 7.1).opacity, 1.0) << file;
  }
}

} // namespace
} // namespace limn
