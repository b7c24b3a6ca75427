// SPDX-License-Identifier: GPL-3.0-or-later
// Where the light is and what it casts shadows of, in the panel: chosen in one go, dragged, turned.
#include "widgets/shading/LightSection.h"
#include "scene/light/LightPresets.h"
#include "scene/light/LightingTerms.h"
#include "scene/view/Camera.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/shading/LightBall.h"

#include <QComboBox>
#include <QTest>

#include <gtest/gtest.h>

namespace limn {
namespace {

bool isNear(const glm::dvec3& a, const glm::dvec3& b, double most = 1e-9) {
  return glm::distance(a, b) < most;
}

class LightSectionTest : public testing::Test {
protected:
  LightSectionTest() {
    m_camera.position = {300.0, -400.0, 100.0};
    m_section.resize(320, 900);
    m_section.setCamera(m_camera);
    m_section.setShading(m_shading);
    m_section.show();
    QObject::connect(&m_section, &ShadingSection::shadingEdited, &m_section,
                     [this](const Shading& shading, const Gesture& gesture) {
                       m_shading = shading;
                       m_gestures.push_back(gesture);
                     });
  }

  LightBall& ball() { return *m_section.findChild<LightBall*>(); }
  void choose(const char* row, int index) {
    QComboBox* box = rowNamed<ChoiceRow>(m_section, row)->box();
    box->setCurrentIndex(index);
    emit box->activated(index);
  }
  int chosen(const char* row) { return rowNamed<ChoiceRow>(m_section, row)->box()->currentIndex(); }
  bool isOn(const char* slider) { return rowNamed<ValueSlider>(m_section, slider)->isEnabled(); }
  // A part of the ball's radius to the right and upwards.
  QPoint onBall(double right, double up) {
    const double radius = 0.5 * (ball().width() - 16.0);
    return (QPointF(ball().rect().center()) + QPointF(0.5, 0.5) + radius * QPointF(right, -up)).toPoint();
  }

  Camera m_camera;
  Shading m_shading;
  LightSection m_section;
  std::vector<Gesture> m_gestures;
};

TEST_F(LightSectionTest, aLightIsChosenInOneGoAndToldApartFromOnesOwn) {
  EXPECT_EQ(chosen("Light"), 0);
  const double reflected = m_shading.diffuse;
  choose("Light", 1);
  ASSERT_EQ(m_gestures.size(), 1u);
  EXPECT_EQ(lightPresetOf(m_shading), LightPreset::studio);
  EXPECT_GT(m_shading.shadow.strength, 0.0);
  EXPECT_GT(m_shading.occlusion.strength, 0.0);
  EXPECT_EQ(m_shading.lightAxes, LightAxes::camera);
  EXPECT_EQ(m_shading.diffuse, reflected); // how tissue answers is not the light's
  EXPECT_EQ(chosen("Lamp position"), 1);
  QTest::keyClick(rowNamed<ValueSlider>(m_section, "Shadows")->findChild<TrackSlider*>(), Qt::Key_Home);
  EXPECT_EQ(m_shading.shadow.strength, 0.0);
  EXPECT_EQ(rowNamed<ChoiceRow>(m_section, "Light")->box()->currentText(), QStringLiteral("My own"));
  choose("Light", 0);
  EXPECT_EQ(m_shading, Shading());
}

TEST_F(LightSectionTest, theHeadlightComesBackAsItWasWhateverWasChangedInBetween) {
  m_shading.ambientIntensity = 0.28; // as the built-in presets have it
  m_shading.lightIntensity = 0.7;
  m_section.setShading(m_shading);
  const Shading before = m_shading;
  choose("Light", 2);
  const Shading soft = m_shading;
  EXPECT_EQ(lightPresetOf(soft), LightPreset::softStudio);
  m_shading.lightIntensity = 1.5; // still that light, but stronger
  m_section.setShading(m_shading);
  choose("Light", 0);
  EXPECT_EQ(m_shading, before);
  choose("Light", 2);
  EXPECT_EQ(m_shading, soft);
  m_shading.shadow.strength = 0.4; // and now one of one's own
  m_shading.ambientIntensity = 0.1;
  m_section.setShading(m_shading);
  EXPECT_EQ(lightPresetOf(m_shading), std::nullopt);
  choose("Light", 0);
  EXPECT_EQ(m_shading, before);
}

TEST_F(LightSectionTest, theLampIsDraggedAroundTheBall) {
  QTest::mousePress(&ball(), Qt::LeftButton, {}, onBall(0.6, 0.0));
  QTest::mouseMove(&ball(), onBall(0.0, 0.8));
  QTest::mouseRelease(&ball(), Qt::LeftButton, {}, onBall(0.0, 0.8));
  ASSERT_GE(m_gestures.size(), 2u);
  EXPECT_EQ(m_gestures.front().id, m_gestures.back().id); // one step back
  EXPECT_EQ(m_shading.lightAxes, LightAxes::camera);      // off the viewer it turns with the view
  EXPECT_TRUE(isNear(seenFromViewer(m_shading, m_camera), {0.0, 0.8, 0.6}, 0.05));
  EXPECT_TRUE(isOn("Shadows"));
  QTest::mouseDClick(&ball(), Qt::LeftButton, {}, onBall(0.0, 0.8));
  EXPECT_TRUE(isNear(seenFromViewer(m_shading, m_camera), {0.0, 0.0, 1.0}));
}

TEST_F(LightSectionTest, besideTheBallTheLampGoesAlongItsRim) {
  QTest::mouseClick(&ball(), Qt::LeftButton, {}, {1, ball().height() / 2});
  EXPECT_TRUE(isNear(seenFromViewer(m_shading, m_camera), {-1.0, 0.0, 0.0}, 0.05));
}

TEST_F(LightSectionTest, arrowKeysMoveTheLamp) {
  ball().setFocus();
  QTest::keyClick(&ball(), Qt::Key_Right);
  QTest::keyClick(&ball(), Qt::Key_Up);
  const glm::dvec3 place = seenFromViewer(m_shading, m_camera);
  EXPECT_GT(place.x, 0.05);
  EXPECT_GT(place.y, 0.05);
  EXPECT_NEAR(glm::length(place), 1.0, 1e-9);
}

TEST_F(LightSectionTest, anotherPositionLeavesTheLampWhereItIsSeen) {
  choose("Light", 1);
  const glm::dvec3 seen = seenFromViewer(m_shading, m_camera);
  const glm::dvec3 travels = *lightTravels(m_shading, m_camera);
  choose("Lamp position", 2);
  EXPECT_EQ(m_shading.lightAxes, LightAxes::world);
  EXPECT_TRUE(isNear(*m_shading.lightDirection, travels));
  // The patient turns under a fixed lamp.
  m_camera.position = {0.0, 500.0, 0.0};
  m_section.setCamera(m_camera);
  EXPECT_FALSE(isNear(ball().place(), seen, 0.1));
  choose("Lamp position", 1);
  EXPECT_EQ(m_shading.lightAxes, LightAxes::camera);
  EXPECT_TRUE(isNear(*lightTravels(m_shading, m_camera), travels));
  choose("Lamp position", 0);
  EXPECT_FALSE(m_shading.lightDirection);
}

TEST_F(LightSectionTest, aLampAtTheViewerSaysThatItCastsNoShadow) {
  EXPECT_FALSE(isOn("Shadows"));
  EXPECT_TRUE(
      rowNamed<ValueSlider>(m_section, "Shadows")->toolTip().contains(QStringLiteral("casts no shadow")));
  EXPECT_TRUE(isOn("Dark hollows"));
  QTest::keyClick(rowNamed<ValueSlider>(m_section, "Dark hollows")->findChild<TrackSlider*>(), Qt::Key_End);
  EXPECT_EQ(m_shading.occlusion.strength, 1.0);
}

TEST_F(LightSectionTest, anglesOfALampThatTurnsAreTheViewers) {
  choose("Lamp position", 1);
  // 90° to the right of the viewer, at its height: light travels to the left.
  EXPECT_TRUE(isNear(travelDirection({90.0, 0.0}, LightAxes::camera), {-1.0, 0.0, 0.0}));
  EXPECT_TRUE(isNear(travelDirection({0.0, 0.0}, LightAxes::camera), {0.0, 0.0, 1.0}));
  EXPECT_TRUE(isNear(travelDirection({0.0, 90.0}, LightAxes::camera), {0.0, -1.0, 0.0}));
  const LightAngles back =
      lightAngles(travelDirection({-120.0, 35.0}, LightAxes::camera) * 3.0, LightAxes::camera);
  EXPECT_NEAR(back.azimuthDeg, -120.0, 1e-9);
  EXPECT_NEAR(back.elevationDeg, 35.0, 1e-9);
}

} // namespace
} // namespace limn
