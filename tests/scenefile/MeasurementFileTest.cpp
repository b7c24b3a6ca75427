// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/FigureFile.h"
#include "io/scenefile/SessionFile.h"

#include <gtest/gtest.h>

// What was measured, in files.

namespace limn {
namespace {

using Kind = Measurement::Kind;

std::vector<Measurement> everyKind() {
  return {{Kind::distance, PatientPlane::coronal, {{0.1, 0.2, 0.3}, {4, 5, 1.0 / 6.0}}},
          {Kind::angle, std::nullopt, {{1, 2, 3}, {-1e5, 0, 0.7}, {3, 2, 1}}, "Cobb \"L1\" ä", false},
          {Kind::ellipse, PatientPlane::sagittal, {{1, -7, 3}, {1, 0, 0}}, std::string(500, 'x')},
          {Kind::mark, PatientPlane::axial, {{1.0 / 3.0, 2, 3}}, "1"}};
}

std::string measurementRefusal(const std::string& measurements) {
  try {
    parseScene(R"({"limn_scene": 1, "volume": "a", "measurements": )" + measurements + "}", "test.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string sceneTextWith(const std::vector<Measurement>& measurements) {
  SceneDocument document = documentOf({}, "a.nii");
  document.measurements = measurements;
  return sceneToJson(document);
}

TEST(MeasurementFile, sceneFilesKeepThemToTheBit) {
  EXPECT_EQ(parseScene(sceneTextWith(everyKind()), "test.json").measurements, everyKind());
  EXPECT_EQ(sceneTextWith({}).find("measurements"), std::string::npos) << "without any no key";
}

TEST(MeasurementFile, hundredsOfThemComeBack) {
  std::vector<Measurement> many;
  for (int n = 0; n < 500; ++n)
    many.push_back({Kind::mark, std::nullopt, {glm::dvec3(n, -n, n / 7.0)}, std::to_string(n)});
  EXPECT_EQ(parseScene(sceneTextWith(many), "test.json").measurements, many);
}

TEST(MeasurementFile, sessionsAndFiguresKeepThem) {
  SessionDocument session;
  session.scene.volume = "a.nii";
  session.scene.measurements = everyKind();
  EXPECT_EQ(parseSession(sessionToJson(session), "test.json").scene.measurements, everyKind());
  FigureDocument figure;
  figure.panels.resize(2);
  figure.panels[1].plane = PatientPlane::axial;
  for (FigurePanelDocument& panel : figure.panels)
    panel.scene = documentOf({}, "a.nii");
  figure.panels[1].scene.measurements = everyKind();
  const FigureDocument read = parseFigure(figureToJson(figure), "test.json");
  EXPECT_TRUE(read.panels[0].scene.measurements.empty());
  EXPECT_EQ(read.panels[1].scene.measurements, everyKind());
}

constexpr const char* oldSlices =
    R"("slices": {"layout": "picture_and_three",
                  "distance": {"plane": "sagittal", "from_mm": [1, 2, 3], "to_mm": [1, 5, 7]}})";

TEST(MeasurementFile, theOneDistanceOfOldSessionsIsTheFirstMeasurement) {
  const SessionDocument session = parseSession(
      std::string(R"({"limn_session": 1, "scene": {"limn_scene": 1, "volume": "a"}, )") + oldSlices + "}",
      "old.json");
  EXPECT_EQ(session.planes.layout, PlaneLayout::pictureAndThree);
  EXPECT_EQ(session.scene.measurements,
            (std::vector<Measurement>{{Kind::distance, PatientPlane::sagittal, {{1, 2, 3}, {1, 5, 7}}}}));
}

TEST(MeasurementFile, theOneDistanceOfOldFiguresIsInAllOfTheirPanels) {
  const std::string scene = R"("scene": {"limn_scene": 1, "volume": "a"})";
  const FigureDocument figure =
      parseFigure(R"({"limn_figure": 1, "panels": [{"name": "", )" + scene +
                      R"(}, {"name": "", "plane": "sagittal", )" + oldSlices + ", " + scene + "}]}",
                  "old.json");
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].scene, figure.panels[1].scene);
  EXPECT_EQ(figure.panels[0].scene.measurements.size(), 1u);
}

TEST(MeasurementFile, whatIsWrongIsRefusedByName) {
  EXPECT_EQ(measurementRefusal("[]"), "accepted");
  for (const auto& [measurements, named] : std::vector<std::pair<std::string, std::string>>{
           {R"({})", "measurements"},
           {R"([{"places_mm": [[1, 2, 3]]}])", "kind"},
           {R"([{"kind": "volume", "places_mm": [[1, 2, 3]]}])", "kind"},
           {R"([{"kind": "mark"}])", "places_mm"},
           {R"([{"kind": "mark", "places_mm": []}])", "places_mm"},
           {R"([{"kind": "mark", "places_mm": [[1, 2]]}])", "places_mm"},
           {R"([{"kind": "mark", "places_mm": [["a", 2, 3]]}])", "places_mm"},
           {R"([{"kind": "mark", "places_mm": [[1e7, 2, 3]]}])", "places_mm"},
           {R"([{"kind": "distance", "places_mm": [[1, 2, 3]]}])", "places_mm"},
           {R"([{"kind": "angle", "places_mm": [[1, 2, 3], [1, 2, 3]]}])", "places_mm"},
           {R"([{"kind": "ellipse", "places_mm": [[1, 2, 3], [1, 2, 3]]}])", "plane"},
           {R"([{"kind": "mark", "places_mm": [[1, 2, 3]], "plane": "oblique"}])", "plane"},
           {R"([{"kind": "mark", "places_mm": [[1, 2, 3]], "name": 7}])", "name"},
           {R"([{"kind": "mark", "places_mm": [[1, 2, 3]], "shown": 1}])", "shown"},
           {R"([{"kind": "mark", "places_mm": [[1, 2, 3]], "color": "red"}])", "color"},
           {R"([7])", "measurements"}}) {
    EXPECT_NE(measurementRefusal(measurements).find(named), std::string::npos)
        << measurements << ": " << measurementRefusal(measurements);
    EXPECT_NE(measurementRefusal(measurements), "accepted") << measurements;
  }
}

} // namespace
} // namespace limn
