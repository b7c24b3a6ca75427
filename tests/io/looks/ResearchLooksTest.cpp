// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of Inviwo, Voreen, ImageVis3D, MRIcroGL and niivue. What a curve shall be is computed here from the
// numbers in the texts, by each format's own rule.
#include "LookText.h"

#include <array>

namespace limn {
namespace {

using test::isTold;
using test::onlyLook;
using test::readBack;
using test::refusal;

using Rgba = std::array<double, 4>;

/// Compares a curve with what a test says it is, at many values between and around two.
void expectCurve(const TransferFunction& function, double low, double high, double tolerance,
                 const std::function<Rgba(double)>& expected) {
  const double margin = 0.1 * (high - low);
  const auto classified = [&](double value) {
    const Rgba rgba = expected(value);
    return Classified{{rgba[0], rgba[1], rgba[2]}, rgba[3]};
  };
  // A prime number of steps meets no point of a curve.
  EXPECT_LE(test::largestDifference(function, classified, low - margin, high + margin, 997), tolerance);
}

/// A straight line between two values, and the ends beyond them.
double ramp(double x, double x0, double y0, double x1, double y1) {
  if (x <= x0)
    return y0;
  return x >= x1 ? y1 : y0 + (x - x0) * (y1 - y0) / (x1 - x0);
}

const LookTarget ctTarget{-1000.0, 3000.0, 0.7};

double stretched(double fraction) {
  return -1000.0 + 4000.0 * fraction;
}

std::string inviwo(const std::string& type, const std::string& points, const std::string& mask = "") {
  return "<?xml version=\"1.0\"?>\r\n<InviwoWorkspace version=\"3\">" + mask + "<type content=\"" + type +
         "\"/>\r\n<Points>" + points + "</Points></InviwoWorkspace>";
}

std::string inviwoPoint(const std::string& x, const std::string& rgba) {
  return "<Point><pos content=\"" + x + "\"/><rgba " + rgba + "/></Point>\n";
}

const std::string dark = R"(x="0.2" y="0" z="0" w="0")";
const std::string bright = R"(x="1" y="1" z="0.9" w="0.7")";

// From dark to bright between two values.
Rgba darkToBright(double x, double from, double to) {
  return {ramp(x, from, 0.2, to, 1.0), ramp(x, from, 0.0, to, 1.0), ramp(x, from, 0.0, to, 0.9),
          ramp(x, from, 0.0, to, 0.7)};
}

TEST(InviwoLook, relativeValuesAreStretchedOverTheVolume) {
  const ReadLook look = onlyLook(inviwo("0", inviwoPoint("0.35", dark) + inviwoPoint("0.8", bright),
                                        R"(<maskMin content="0"/><maskMax content="1"/>)"),
                                 ctTarget);
  expectCurve(look.preset.transferFunction, -1000, 3000, 1e-6,
              [](double x) { return darkToBright(x, stretched(0.35), stretched(0.8)); });
  EXPECT_TRUE(isTold(look.changes, "stretched"));
  EXPECT_EQ(look.preset.name, "demo");
}

TEST(InviwoLook, absoluteValuesStayWhereTheyAre) {
  const ReadLook look = onlyLook(inviwo("1", inviwoPoint("900", bright) + inviwoPoint("-250.5", dark)));
  expectCurve(look.preset.transferFunction, -300, 1000, 1e-6,
              [](double x) { return darkToBright(x, -250.5, 900.0); });
  EXPECT_TRUE(look.changes.empty());
}

TEST(InviwoLook, theFirstGenerationReadsToo) {
  const ReadLook look =
      onlyLook("\xEF\xBB\xBF<?xml version=\"1.0\" ?>\n<InviwoTreeData version=\"1.0\"><!-- do not edit -->"
               "<maskMin content=\"0\" /><maskMax content=\"1\" /><dataPoints>"
               "<point><pos x=\"0.25\" y=\"0\" /><rgba x=\"0.2\" y=\"0\" z=\"0\" w=\"0\" /></point>"
               "<point><pos x=\"0.75\" y=\"0.7\" /><rgba x=\"1\" y=\"1\" z=\"0.9\" /></point>"
               "</dataPoints><interpolationType_ content=\"0\" /></InviwoTreeData>",
               ctTarget);
  expectCurve(look.preset.transferFunction, -1000, 3000, 1e-6,
              [](double x) { return darkToBright(x, stretched(0.25), stretched(0.75)); });
}

TEST(InviwoLook, outsideItsMaskNothingIsSeen) {
  const ReadLook look = onlyLook(inviwo("1", inviwoPoint("0", dark) + inviwoPoint("100", bright),
                                        R"(<maskMin content="20"/><maskMax content="150"/>)"));
  expectCurve(look.preset.transferFunction, 0, 200, 1e-6, [](double x) {
    Rgba rgba = darkToBright(std::min(std::max(x, 20.0), 150.0), 0.0, 100.0);
    rgba[3] = x >= 20.0 && x < 150.0 ? rgba[3] : 0.0;
    return rgba;
  });
  EXPECT_TRUE(isTold(look.changes, "mask"));
  EXPECT_NE(refusal(inviwo("1", inviwoPoint("0", dark), R"(<maskMin content="2"/><maskMax content="1"/>)"))
                .find("mask"),
            std::string::npos);
}

TEST(InviwoLook, pointsAtOneValueAreAStep) {
  const ReadLook look = onlyLook(inviwo("1", inviwoPoint("50", dark) + inviwoPoint("50", bright)));
  expectCurve(look.preset.transferFunction, 0, 100, 1e-6, [](double x) {
    return x < 50.0 ? Rgba{0.2, 0, 0, 0} : Rgba{1, 1, 0.9, 0.7};
  });
}

TEST(InviwoLook, whatIsNoFunctionIsRefused) {
  EXPECT_NE(refusal(inviwo("1", "")).find("no points"), std::string::npos);
  EXPECT_NE(refusal(inviwo("1", inviwoPoint("nan", dark))), "");
  EXPECT_NE(refusal(inviwo("1", inviwoPoint("1e999", dark))), "");
  EXPECT_NE(refusal(inviwo("1", inviwoPoint("1,5", dark))), "");
  EXPECT_NE(refusal(inviwo("1", inviwoPoint("1", R"(x="inf" y="0" z="0" w="0")"))), "");
  EXPECT_NE(refusal("<InviwoWorkspace version=\"3\"><ProcessorNetwork/></InviwoWorkspace>").find("Inviwo"),
            std::string::npos);
  const std::string whole = inviwo("1", inviwoPoint("1", dark));
  EXPECT_NE(refusal(whole.substr(0, whole.size() / 2)), "");
}

const std::string voreenKeys = R"(
  <key type="TransFuncMappingKey"><intensity value="0.25"/><split value="false"/><colorL r="51" g="0" b="0" a="0"/></key>
  <key type="TransFuncMappingKey"><intensity value="0.5"/><split value="true"/><colorL r="255" g="0" b="0" a="51"/>
    <colorR r="0" g="0" b="255" a="255"/></key>
  <key type="TransFuncMappingKey"><intensity value="0.75"/><split value="false"/><colorL r="0" g="0" b="0" a="102"/></key>)";

std::string voreen(const std::string& head, const std::string& keys = voreenKeys) {
  return "<?xml version=\"1.0\" ?>\n<VoreenData version=\"1\">\n<TransFuncIntensity "
         "type=\"TransFuncIntensity\">" +
         head + "<Keys>" + keys + "</Keys></TransFuncIntensity></VoreenData>\n";
}

// The keys above at 0..1 of the domain.
Rgba voreenAt(double t) {
  if (t < 0.5)
    return {ramp(t, 0.25, 0.2, 0.5, 1.0), 0.0, 0.0, ramp(t, 0.25, 0.0, 0.5, 0.2)};
  return {0.0, 0.0, ramp(t, 0.5, 1.0, 0.75, 0.0), ramp(t, 0.5, 1.0, 0.75, 0.4)};
}

TEST(VoreenLook, splitKeysAreSteps) {
  const ReadLook look = onlyLook(voreen(
      R"(<alphaMode value="1"/><gammaValue value="1"/><domain x="100" y="300"/><threshold x="0" y="1"/>)"));
  expectCurve(look.preset.transferFunction, 100, 300, 1e-6,
              [](double x) { return voreenAt((x - 100.0) / 200.0); });
  EXPECT_TRUE(look.changes.empty());
}

TEST(VoreenLook, theDomainNeverFittedIsStretched) {
  const ReadLook look = onlyLook(voreen(R"(<domain x="0" y="1"/>)"), ctTarget);
  expectCurve(look.preset.transferFunction, -1000, 3000, 1e-6,
              [](double x) { return voreenAt((x + 1000.0) / 4000.0); });
  EXPECT_TRUE(isTold(look.changes, "stretched"));
}

TEST(VoreenLook, thresholdsOfBothKindsHide) {
  for (const char* threshold :
       {R"(<threshold x="0.4" y="0.6"/>)", R"(<lower value="0.4"/><upper value="0.6"/>)"}) {
    const ReadLook look = onlyLook(voreen(std::string(R"(<domain x="0" y="100"/>)") + threshold));
    expectCurve(look.preset.transferFunction, 0, 100, 1e-6, [](double x) {
      Rgba rgba = voreenAt(std::min(std::max(x, 40.0), 60.0) / 100.0);
      rgba[3] = x >= 40.0 && x < 60.0 ? rgba[3] : 0.0;
      return rgba;
    });
    EXPECT_TRUE(isTold(look.changes, "threshold"));
  }
}

TEST(VoreenLook, gammaIsSampledWithinTheStatedError) {
  for (const double gamma : {0.2, 0.7, 1.0000001, 2.2, 9.0}) {
    const ReadLook look =
        onlyLook(voreen("<domain x=\"0\" y=\"100\"/><gammaValue value=\"" + std::to_string(gamma) + "\"/>"));
    const double step = std::pow(0.5, 1.0 / gamma);
    expectCurve(look.preset.transferFunction, 0, 100, 0.01, [&](double x) {
      const double t = std::min(std::max(x / 100.0, 0.0), 1.0);
      const double s = std::pow(t, gamma);
      return voreenAt(std::abs(t - step) < 1e-12 ? 0.5 : s);
    });
    EXPECT_LT(look.preset.transferFunction.points.size(), 200u);
  }
}

TEST(VoreenLook, opacityModesAreKept) {
  const ReadLook opaque = onlyLook(voreen(R"(<domain x="0" y="100"/><alphaMode value="2"/>)"));
  expectCurve(opaque.preset.transferFunction, 0, 100, 1e-6, [](double x) {
    Rgba rgba = voreenAt(x / 100.0);
    rgba[3] = x < 25.0 ? 0.0 : 1.0;
    return rgba;
  });
  const ReadLook clear = onlyLook(voreen(R"(<domain x="0" y="100"/><alphaMode value="0"/>)"));
  EXPECT_EQ(largestOpacityWithin(clear.preset.transferFunction, 0, 100), 0.0);
}

TEST(VoreenLook, damageIsRefused) {
  EXPECT_NE(refusal(voreen(R"(<domain x="3" y="3"/>)")), "");
  EXPECT_NE(refusal(voreen(R"(<domain x="0" y="9"/><gammaValue value="nan"/>)")), "");
  EXPECT_NE(refusal(voreen(R"(<domain x="0" y="9"/><threshold x="0.8" y="0.2"/>)")), "");
  EXPECT_NE(refusal(voreen(R"(<domain x="0" y="9"/>)", "")), "");
  EXPECT_NE(
      refusal(voreen(R"(<domain x="0" y="9"/>)", "<key><intensity value=\"nan\"/><colorL r=\"0\" g=\"0\" "
                                                 "b=\"0\" a=\"0\"/></key>")),
      "");
  EXPECT_NE(refusal("<VoreenData version=\"1\"><TransFuncIntensityGradient/></VoreenData>").find("Voreen"),
            std::string::npos);
}

const std::string mitkHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<Version TransferfunctionVersion=\"1\" />\n";

std::string mitk(const std::string& opacities, const std::string& gradients, const std::string& colors) {
  return mitkHead + "<TransferFunction><ScalarOpacity>" + opacities + "</ScalarOpacity><GradientOpacity>" +
         gradients + "</GradientOpacity><Color>" + colors + "</Color></TransferFunction>\n";
}

const std::string mitkOpacities = R"(<point x="900" y="0.7"/><point x="100" y="0"/>)";
const std::string mitkColors = R"(<point x="200" r="0.2" g="0" b="0" midpoint="0.25" sharpness="0"/>
  <point x="600" r="1" g="1" b="0.9" midpoint="0.5" sharpness="0"/>)";

TEST(MitkLook, twoRootsAndTwoCurvesBecomeOne) {
  const ReadLook look =
      onlyLook(mitk(mitkOpacities, R"(<point x="0" y="1"/><point x="255" y="1"/>)", mitkColors), ctTarget);
  expectCurve(look.preset.transferFunction, 100, 900, 1e-6, [](double x) {
    // Half of the change of colour is done after a quarter of the way.
    const double done = x < 300.0 ? ramp(x, 200, 0.0, 300, 0.5) : ramp(x, 300, 0.5, 600, 1.0);
    return Rgba{0.2 + 0.8 * done, done, 0.9 * done, ramp(x, 100, 0.0, 900, 0.7)};
  });
  EXPECT_FALSE(look.preset.gradientOpacity);
}

TEST(MitkLook, gradientsAreConvertedByTheSpacing) {
  const ReadLook look =
      onlyLook(mitk(mitkOpacities, R"(<point x="14" y="0"/><point x="70" y="1"/>)", mitkColors), ctTarget);
  ASSERT_TRUE(look.preset.gradientOpacity);
  ASSERT_EQ(look.preset.gradientOpacity->points.size(), 2u);
  EXPECT_NEAR(look.preset.gradientOpacity->points[0].gradient, 20.0, 1e-9); // 14 per voxel of 0.7 mm
  EXPECT_NEAR(look.preset.gradientOpacity->points[1].gradient, 100.0, 1e-9);
  EXPECT_TRUE(isTold(look.changes, "0.7 mm"));
}

TEST(MitkLook, damageIsRefused) {
  EXPECT_NE(refusal(mitk("", "", mitkColors)).find("no points"), std::string::npos);
  EXPECT_NE(refusal(mitk(mitkOpacities, "", "")).find("no points"), std::string::npos);
  EXPECT_NE(refusal(mitk(R"(<point x="1"/>)", "", mitkColors)).find("\"y\""), std::string::npos);
  EXPECT_NE(refusal(mitk(R"(<point x="nan" y="1"/>)", "", mitkColors)), "");
  EXPECT_NE(refusal(mitk(mitkOpacities, R"(<point x="inf" y="1"/>)", mitkColors)), "");
  const std::string whole = mitk(mitkOpacities, "", mitkColors);
  EXPECT_NE(refusal(whole.substr(0, whole.size() - 30)), "");
}

std::string clut(const std::string& range) {
  return range +
         "[INT]\r\nnumnodes=3\r\n[BYT]\r\nnodeintensity0=0\r\nnodeintensity1 = 51\r\nnodeintensity2=255\r\n"
         "[RGBA255]\r\nnodergba0=51|0|0|0\r\nnodergba1=255|0|102|51\r\nnodergba2=255|255|204|153\r\n";
}

// Between 0 and 1 of the range.
Rgba clutAt(double t) {
  return {ramp(t, 0.0, 0.2, 0.2, 1.0), ramp(t, 0.2, 0.0, 1.0, 1.0),
          t < 0.2 ? ramp(t, 0.0, 0.0, 0.2, 0.4) : ramp(t, 0.2, 0.4, 1.0, 0.8),
          t < 0.2 ? ramp(t, 0.0, 0.0, 0.2, 0.2) : ramp(t, 0.2, 0.2, 1.0, 0.6)};
}

TEST(MricroglLook, nodesLieBetweenItsLimits) {
  const ReadLook look = onlyLook(clut("[FLT]\r\nmin=-100.5\r\nmax=900\r\n"));
  expectCurve(look.preset.transferFunction, -100.5, 900, 1e-6,
              [](double x) { return clutAt((x + 100.5) / 1000.5); });
  EXPECT_TRUE(look.changes.empty());
}

TEST(MricroglLook, withoutLimitsItIsStretched) {
  for (const char* range : {"[FLT]\nmin=0\nmax=0\n", ""}) {
    const ReadLook look = onlyLook(clut(range), ctTarget);
    expectCurve(look.preset.transferFunction, -1000, 3000, 1e-6,
                [](double x) { return clutAt((x + 1000.0) / 4000.0); });
    EXPECT_TRUE(isTold(look.changes, "stretched"));
  }
}

TEST(MricroglLook, contradictionsAreRefusedOrTold) {
  std::string more = clut("[FLT]\nmin=0\nmax=10\n");
  more.replace(more.find("numnodes=3"), 10, "numnodes=2");
  const ReadLook two = onlyLook(more);
  EXPECT_EQ(two.preset.transferFunction.points.size(), 2u);
  EXPECT_TRUE(isTold(two.changes, "more points"));
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = clut("[FLT]\nmin=0\nmax=10\n");
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(refusal(with("numnodes=3", "numnodes=4")), "");
  EXPECT_NE(refusal(with("numnodes=3", "numnodes=4000000000")), "");
  EXPECT_NE(refusal(with("numnodes=3", "numnodes=nan")), "");
  EXPECT_NE(refusal(with("max=10", "max=-10")), "");
  EXPECT_NE(refusal(with("max=10", "max=inf")), "");
  EXPECT_NE(refusal(with("=255\r\n[RGBA", "=256\r\n[RGBA")), "");
  EXPECT_NE(refusal(with("255|255|204|153", "255|255|204")), "");
  EXPECT_NE(refusal(with("255|255|204|153", "255|255|204|153|1")), "");
  EXPECT_NE(refusal(with("255|255|204|153", "255|255|2,4|153")), "");
  const std::string tooBright = with("255|255|204|153", "255|255|204|300");
  EXPECT_TRUE(isTold(onlyLook(tooBright).changes, "limited"));
}

TEST(NiivueLook, isTheSameMap) {
  const ReadLook look = onlyLook(
      R"({"min":-100.5,"max":900,"R":[51,255,255],"G":[0,0,255],"B":[0,102,204],"A":[0,51,153],"I":[0,51,255]})");
  expectCurve(look.preset.transferFunction, -100.5, 900, 1e-6,
              [](double x) { return clutAt((x + 100.5) / 1000.5); });
  const ReadLook relative =
      onlyLook(R"({"R":[51,255,255],"G":[0,0,255],"B":[0,102,204],"A":[0,51,153],"I":[0,51,255]})", ctTarget);
  expectCurve(relative.preset.transferFunction, -1000, 3000, 1e-6,
              [](double x) { return clutAt((x + 1000.0) / 4000.0); });
}

TEST(NiivueLook, damageIsRefused) {
  EXPECT_NE(refusal(R"({"R":[1],"G":[1],"B":[1],"A":[1],"I":[]})"), "");
  EXPECT_NE(refusal(R"({"R":[],"G":[],"B":[],"A":[],"I":[]})"), "");
  EXPECT_NE(refusal(R"({"R":[1],"G":[1],"B":[1],"I":[0]})").find("\"A\""), std::string::npos);
  EXPECT_NE(refusal(R"({"R":["1"],"G":[1],"B":[1],"A":[1],"I":[0]})"), "");
  EXPECT_NE(refusal(R"({"R":[1],"G":[1],"B":[1],"A":[1],"I":[0],"labels":["bone"]})").find("labels"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"R":[1],"G":[1],"B":[1],"A":[1],"I":[0]}])"), "");
  EXPECT_NE(refusal(R"({"R":[1],"G":[1],"B":[1],"A":[1],"I":[0])"), "");
}

// A table whose rows lie on straight lines between a few, as of a curve.
std::string table(int rows, const std::function<Rgba(double)>& curve) {
  std::string text = std::to_string(rows) + "\r\n";
  for (int row = 0; row < rows; ++row) {
    for (const double part : curve(row / (rows - 1.0)))
      text += std::to_string(part) + " ";
    text += "\r\n";
  }
  return text;
}

TEST(ImageVisLook, rowsBecomeFewPointsWithinALevel) {
  const auto curve = [](double t) {
    return Rgba{ramp(t, 0.3, 0.0, 0.6, 1.0), 0.5, 0.5 + 0.5 * std::sin(9.0 * t),
                ramp(t, 0.8, 0.0, 0.80001, 0.9)};
  };
  for (const int rows : {256, 4096}) {
    const ReadLook look = onlyLook(table(rows, curve), ctTarget);
    const TransferFunction& function = look.preset.transferFunction;
    EXPECT_LT(function.points.size(), 60u);
    EXPECT_TRUE(isTold(look.changes, std::to_string(rows) + " rows"));
    for (int row = 0; row < rows; ++row) {
      const Classified seen = classify(function, stretched(row / (rows - 1.0)));
      const Rgba want = curve(row / (rows - 1.0));
      EXPECT_NEAR(seen.color.r, want[0], 1.0 / 255.0 + 1e-6);
      EXPECT_NEAR(seen.color.b, want[2], 1.0 / 255.0 + 1e-6);
      EXPECT_NEAR(seen.opacity, want[3], 1.0 / 255.0 + 1e-6);
    }
  }
}

TEST(ImageVisLook, wrongLengthsAreRefused) {
  EXPECT_NE(refusal("3\n0 0 0 0\n1 1 1 1\n", ctTarget).find("2 rows"), std::string::npos);
  EXPECT_NE(refusal("2\n0 0 0 0\n1 1 1 1\n1 1 1 1\n", ctTarget).find("3 rows"), std::string::npos);
  EXPECT_NE(refusal("2\n0 0 0 0\n1 1 1\n", ctTarget), "");
  EXPECT_NE(refusal("2\n0 0 0 0\n1 1 nan 1\n", ctTarget), "");
  EXPECT_NE(refusal("2\n0 0 0 0\n1 1 x 1\n", ctTarget), "");
}

TEST(ImageVisLook, aMillionRowsAreReadInTime) {
  // Noise as large as the tolerance: the worst for what looks for straight lines.
  unsigned state = 1;
  const std::string text = table(1 << 20, [&](double) {
    state = state * 1664525u + 1013904223u;
    const double noise = 0.5 + 0.004 * (state >> 16) / 65536.0;
    return Rgba{noise, noise, noise, noise};
  });
  const ReadLook look = onlyLook(text, ctTarget);
  EXPECT_LT(look.preset.transferFunction.points.size(), 100000u);
}

TEST(ResearchLooks, aMillionPointsAreRefusedInTime) {
  std::string points, keys, numbers = "[0";
  for (int i = 0; i < 1000000; ++i) {
    points +=
        "<Point><pos content=\"" + std::to_string(i) + "\"/><rgba x=\"0\" y=\"0\" z=\"0\" w=\"0\"/></Point>";
    keys += "<key><intensity value=\"0.5\"/><colorL r=\"0\" g=\"0\" b=\"0\" a=\"0\"/></key>";
    numbers += ",1";
  }
  numbers += "]";
  EXPECT_NE(refusal(inviwo("1", points)), "");
  EXPECT_NE(refusal(voreen("<domain x=\"0\" y=\"2\"/>", keys)), "");
  EXPECT_NE(refusal("{\"min\":0,\"max\":1,\"R\":" + numbers + ",\"G\":" + numbers + ",\"B\":" + numbers +
                    ",\"A\":" + numbers + ",\"I\":" + numbers + "}"),
            "");
}

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
