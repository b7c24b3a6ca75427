// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of Inviwo, Voreen, ImageVis3D, MRIcroGL and niivue. What a curve shall be is computed here from the
// numbers in the texts, by each format's own rule.
#include "CurveOf.h"

namespace limn {
namespace {

using test::ctTarget;
using test::expectCurve;
using test::isTold;
using test::onlyLook;
using test::ramp;
using test::refusal;
using test::Rgba;
using test::stretched;

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

} // namespace
} // namespace limn
