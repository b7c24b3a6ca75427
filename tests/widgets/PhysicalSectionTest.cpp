// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of physical light in the panel, and who of the other sections serves it.
#include "widgets/shading/PhysicalSection.h"
#include "scene/light/LightPresets.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/shading/LightSection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <numbers>

namespace limn {
namespace {

class PhysicalSectionTest : public testing::Test {
protected:
  PhysicalSectionTest() {
    m_section.resize(320, 700);
    m_section.setModelsShown({ShadingModel::physical});
    m_section.setShading(m_shading);
    m_section.show();
    QObject::connect(&m_section, &ShadingSection::shadingEdited, &m_section,
                     [this](const Shading& shading, const Gesture& gesture) {
                       m_shading = shading;
                       m_gestures.push_back(gesture);
                     });
  }

  ValueSlider& row(const char* name) { return *rowNamed<ValueSlider>(m_section, name); }
  // To an end of its track.
  const PhysicalLight& press(const char* name, Qt::Key key) {
    QTest::keyClick(row(name).findChild<TrackSlider*>(), key);
    return m_shading.physical;
  }
  void type(const char* name, const char* number) {
    auto* field = row(name).findChild<NumberField*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QString::fromLatin1(number));
    QTest::keyClick(field, Qt::Key_Return);
  }
  void choose(int index) {
    QComboBox* box = rowNamed<ChoiceRow>(m_section, "Drawn until")->box();
    box->setCurrentIndex(index);
    emit box->activated(index);
  }

  Shading m_shading;
  PhysicalSection m_section;
  std::vector<Gesture> m_gestures;
};

TEST_F(PhysicalSectionTest, everySliderChangesItsNumberAlone) {
  // Both ends of each track; those typed go further.
  EXPECT_EQ(press("Density", Qt::Key_End).density, 10.0);
  EXPECT_EQ(press("Forward scatter (g)", Qt::Key_End).anisotropy, 0.95);
  EXPECT_EQ(press("Surfaces", Qt::Key_Home).surface, 0.0);
  EXPECT_EQ(press("Gloss", Qt::Key_End).specularShare, 1.0);
  EXPECT_DOUBLE_EQ(press("Lamp strength", Qt::Key_End).keyIrradiance, 4.0 * std::numbers::pi);
  EXPECT_EQ(press("Lamp size", Qt::Key_End).keyRadiusDeg, 45.0);
  EXPECT_EQ(press("Sky above", Qt::Key_End).sky.above, 2.0);
  EXPECT_EQ(press("Sky below", Qt::Key_Home).sky.below, 0.0);
  EXPECT_EQ(press("Exposure", Qt::Key_Home).exposureEv, -4.0);
  EXPECT_EQ(m_gestures.size(), 9u);
  PhysicalLight expected;
  expected.density = 10.0;
  expected.anisotropy = 0.95;
  expected.surface = 0.0;
  expected.specularShare = 1.0;
  expected.keyIrradiance = m_shading.physical.keyIrradiance;
  expected.keyRadiusDeg = 45.0;
  expected.sky = {0.0, 2.0};
  expected.exposureEv = -4.0;
  EXPECT_EQ(m_shading.physical, expected);
  type("Density", "100");
  EXPECT_EQ(m_shading.physical.density, 100.0);
  type("Density", "250"); // the law ends at 100
  EXPECT_EQ(m_shading.physical.density, 100.0);
  type("Exposure", "-20");
  EXPECT_EQ(m_shading.physical.exposureEv, -20.0);
}

TEST_F(PhysicalSectionTest, anEndIsANumberOfPathsOrLevelsOrSeconds) {
  EXPECT_EQ(m_shading.physical.until, Until(UntilPaths{256}));
  type("Paths a pixel", "40");
  EXPECT_EQ(m_shading.physical.until, Until(UntilPaths{40}));
  choose(1);
  EXPECT_EQ(m_shading.physical.until, Until(UntilLevels{1.0}));
  type("Noise left", "0.5");
  EXPECT_EQ(m_shading.physical.until, Until(UntilLevels{0.5}));
  choose(2);
  type("Time for it", "90");
  EXPECT_EQ(m_shading.physical.until, Until(UntilSeconds{90.0}));
  choose(0);
  EXPECT_EQ(m_shading.physical.until, Until(UntilPaths{256}));
}

TEST_F(PhysicalSectionTest, aSwitchFiltersTheNoiseOfSavedPictures) {
  auto* filter = m_section.findChild<QCheckBox*>();
  ASSERT_TRUE(filter);
  EXPECT_FALSE(filter->isChecked());
  filter->click();
  PhysicalLight expected;
  expected.filtersNoise = true;
  EXPECT_EQ(m_shading.physical, expected);
  EXPECT_EQ(m_gestures.back().text, QStringLiteral("noise filter on"));
  m_section.setShading(Shading{});
  EXPECT_FALSE(filter->isChecked());
  m_section.setModelsShown({ShadingModel::classic});
  EXPECT_FALSE(filter->isEnabled());
}

TEST_F(PhysicalSectionTest, withoutAPhysicalPictureItSaysThatNothingIsUsed) {
  m_section.setModelsShown({ShadingModel::classic, ShadingModel::robust});
  EXPECT_FALSE(m_section.unusedBecause().isEmpty());
  EXPECT_FALSE(row("Density").isEnabled());
  EXPECT_TRUE(row("Density").toolTip().contains(QStringLiteral("no picture is drawn in it")));
  m_section.setModelsShown({ShadingModel::classic, ShadingModel::physical});
  EXPECT_TRUE(m_section.unusedBecause().isEmpty());
  EXPECT_TRUE(row("Density").isEnabled());
}

// What its surfaces and its tone take from the other sections is not said to be unused.
TEST(PhysicalPanel, numbersThatPhysicalLightReadsAreOffered) {
  PropertiesPanel panel;
  panel.setModelsShown({ShadingModel::physical});
  for (const char* name : {"Full effect at", "Weighting", "Lamp position", "Light"})
    EXPECT_TRUE(
        rowNamed<ChoiceRow>(panel, name)->isEnabledTo(rowNamed<ChoiceRow>(panel, name)->parentWidget()))
        << name;
  for (const char* name : {"Soft limit from (k)", "Density", "Smooth normals"})
    EXPECT_TRUE(
        rowNamed<ValueSlider>(panel, name)->isEnabledTo(rowNamed<ValueSlider>(panel, name)->parentWidget()))
        << name;
  EXPECT_FALSE(rowNamed<ValueSlider>(panel, "Shadows")
                   ->isEnabledTo(rowNamed<ValueSlider>(panel, "Shadows")->parentWidget()));
}

// It is told beside the edit, too: a comparison has models of its own, which follow it.
TEST(PhysicalPanel, theLightCalledPhysicalBringsItsModel) {
  PropertiesPanel panel;
  QSignalSpy lights(&panel, &PropertiesPanel::lightChosen);
  Shading shading;
  QObject::connect(&panel, &PropertiesPanel::shadingEdited, &panel,
                   [&](const Shading& edited) { shading = edited; });
  const auto choose = [&](int index) {
    QComboBox* box = rowNamed<ChoiceRow>(*panel.findChild<LightSection*>(), "Light")->box();
    box->setCurrentIndex(index);
    emit box->activated(index);
  };
  panel.setModelsShown({ShadingModel::classic});
  choose(4);
  EXPECT_EQ(shading.model, ShadingModel::physical);
  choose(0);
  EXPECT_EQ(shading.model, Shading().model);
  ASSERT_EQ(lights.size(), 2);
  EXPECT_EQ(lights[0][0].value<LightPreset>(), LightPreset::physical);
  EXPECT_EQ(lights[1][0].value<LightPreset>(), LightPreset::headlight);
  auto* diffuse = rowNamed<ValueSlider>(panel, "Diffuse (kd)")->findChild<TrackSlider*>();
  QTest::keyClick(diffuse, Qt::Key_End);
  EXPECT_EQ(lights.size(), 2) << "a strength is no whole light";
}

} // namespace
} // namespace limn
