// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Phantom.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/properties/CropSection.h"
#include "widgets/properties/FogSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/shading/GradientSection.h"
#include "widgets/shading/LightSection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace limn {
namespace {

// The panel with the phantom (HU, orientation known), answered as the session answers.
class SceneSections : public testing::Test {
protected:
  SceneSections() {
    m_scene.volume = phantomVolume({8.0, 0.0, 1});
    m_scene.camera = defaultCamera(m_scene.volume->grid());
    m_panel.resize(320, 1600);
    m_panel.show();
    m_panel.setScene(m_scene);
    const auto answer = [this](const Gesture& gesture) {
      m_gestures.push_back(gesture);
      m_panel.setScene(m_scene);
    };
    QObject::connect(&m_panel, &PropertiesPanel::projectionEdited, &m_panel,
                     [=, this](Projection p, const Gesture& g) {
                       m_scene.projection = p;
                       answer(g);
                     });
    QObject::connect(&m_panel, &PropertiesPanel::isovalueEdited, &m_panel,
                     [=, this](double v, const Gesture& g) {
                       m_scene.isovalue = v;
                       answer(g);
                     });
    QObject::connect(&m_panel, &PropertiesPanel::cropEdited, &m_panel,
                     [=, this](const CropBox& c, const Gesture& g) {
                       m_scene.crop = c;
                       answer(g);
                     });
    QObject::connect(&m_panel, &PropertiesPanel::fogEdited, &m_panel,
                     [=, this](const Fog& f, const Gesture& g) {
                       m_scene.fog = f;
                       answer(g);
                     });
    QObject::connect(&m_panel, &PropertiesPanel::qualityEdited, &m_panel,
                     [=, this](const Quality& q, const Gesture& g) {
                       m_scene.quality = q;
                       answer(g);
                     });
  }

  void type(NumberField* field, const QString& number) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, number);
    QTest::keyClick(field, Qt::Key_Return);
  }

  static void choose(ChoiceRow* row, int index) {
    row->box()->setCurrentIndex(index);
    emit row->box()->activated(index);
  }

  bool headerSays(const FoldingSection* section, const QString& text) const {
    for (const QLabel* label : section->findChildren<QLabel*>())
      if (label->text() == text && label->isVisible())
        return true;
    return false;
  }

  Scene m_scene;
  PropertiesPanel m_panel;
  std::vector<Gesture> m_gestures;
};

TEST_F(SceneSections, settingEmitsNothing) {
  m_scene.projection = Projection::isosurface;
  m_scene.crop.lower.x = 0.123456;
  m_scene.fog = {Fog::Mode::exp2, {0.1, 0.2, 0.3}, 0.012345678, 1.5, 20.0};
  m_scene.quality.preintegrated = Preintegration::always;
  m_scene.quality.jitter = true;
  m_panel.setScene(m_scene);
  m_panel.foldUnused();
  m_panel.setScene({});
  EXPECT_TRUE(m_gestures.empty());
}

TEST_F(SceneSections, anotherPanelFoldsAsThisOne) {
  auto* quality = m_panel.findChild<QualitySection*>();
  quality->setFolded(!quality->isFolded());
  auto* fog = m_panel.findChild<FogSection*>();
  fog->setFolded(!fog->isFolded());
  PropertiesPanel other;
  ASSERT_NE(other.folded(), m_panel.folded());
  other.setFolded(m_panel.folded());
  EXPECT_EQ(other.folded(), m_panel.folded());
  EXPECT_EQ(other.findChild<FogSection*>()->isFolded(), fog->isFolded());
  EXPECT_TRUE(m_gestures.empty());
}

TEST_F(SceneSections, theIsovalueShowsWhereASurfaceIsShown) {
  auto* isovalue = rowNamed<ValueSlider>(m_panel, "Surface at");
  auto* projection = rowNamed<ChoiceRow>(m_panel, "Shows");
  EXPECT_FALSE(isovalue->isVisible());
  choose(projection, static_cast<int>(Projection::compositeIsosurface));
  EXPECT_EQ(m_scene.projection, Projection::compositeIsosurface);
  ASSERT_TRUE(isovalue->isVisible());
  EXPECT_EQ(isovalue->findChild<NumberField*>()->suffix(), QString(QChar(0x00a0)) + QStringLiteral("HU"));
  type(isovalue->findChild<NumberField*>(), QStringLiteral("-250"));
  EXPECT_EQ(m_scene.isovalue, -250.0);
  EXPECT_EQ(m_gestures.back().text, QStringLiteral("change value of the surface"));
  choose(projection, static_cast<int>(Projection::mip));
  EXPECT_FALSE(isovalue->isVisible());
}

TEST_F(SceneSections, theTrackOfTheIsovalueIsTheVolumesRange) {
  m_scene.projection = Projection::isosurface;
  m_panel.setScene(m_scene);
  TrackSlider* track = rowNamed<ValueSlider>(m_panel, "Surface at")->findChild<TrackSlider*>();
  track->setFocus();
  QTest::keyClick(track, Qt::Key_Home);
  EXPECT_EQ(m_scene.isovalue, m_scene.volume->range().lowest);
  QTest::keyClick(track, Qt::Key_End);
  EXPECT_EQ(m_scene.isovalue, m_scene.volume->range().highest);
}

TEST_F(SceneSections, anUnlitProjectionDisablesLightAndSaysSo) {
  m_panel.setModelsShown({ShadingModel::enhanced});
  m_scene.projection = Projection::mip;
  m_panel.setScene(m_scene);
  ShadingSection* light = m_panel.findChild<LightSection*>();
  EXPECT_TRUE(headerSays(light, QStringLiteral("unused: this projection is unlit")));
  EXPECT_TRUE(light->isFolded());
  m_scene.projection = Projection::composite;
  m_panel.setScene(m_scene);
  EXPECT_FALSE(headerSays(light, QStringLiteral("unused: this projection is unlit")));
  EXPECT_FALSE(light->isFolded());
  EXPECT_TRUE(m_panel.findChild<GradientSection*>()->isFolded()); // as it was before
}

TEST_F(SceneSections, whatNoModelShownUsesFoldsOnceAndComesBack) {
  ShadingSection* light = m_panel.findChild<LightSection*>();
  m_panel.setModelsShown({ShadingModel::classic});
  EXPECT_TRUE(headerSays(m_panel.findChild<GradientSection*>(), QStringLiteral("unused: not in this model")));
  EXPECT_FALSE(light->isFolded());
  m_panel.setModelsShown({ShadingModel::none});
  EXPECT_TRUE(headerSays(light, QStringLiteral("unused: this model is unlit")));
  EXPECT_TRUE(light->isFolded());
  light->setFolded(false); // somebody wants to see it
  m_panel.setModelsShown({ShadingModel::none});
  EXPECT_FALSE(light->isFolded());
  light->setFolded(true);
  m_panel.setModelsShown({ShadingModel::none, ShadingModel::robust});
  EXPECT_FALSE(light->isFolded());
  EXPECT_TRUE(m_panel.findChild<GradientSection*>()->isFolded()); // as it was before
}

TEST_F(SceneSections, theHeaderOfACropThatCutsNothingSaysOff) {
  CropSection* crop = m_panel.cropSection();
  EXPECT_TRUE(crop->isFolded());
  EXPECT_TRUE(headerSays(crop, QStringLiteral("off")));
  m_scene.crop.upper.z = 0.5;
  m_panel.setScene(m_scene);
  EXPECT_TRUE(headerSays(crop, QLocale().toString(50) + QStringLiteral(" % kept")));
  EXPECT_TRUE(crop->isFolded()); // what somebody folded stays so
  m_panel.foldUnused();
  EXPECT_FALSE(crop->isFolded());
}

TEST_F(SceneSections, aTypedPercentCutsOneSideAndLeavesTheOthersExact) {
  m_scene.crop.lower = {0.0123456789, 0.25, 0.0};
  m_panel.setScene(m_scene);
  m_panel.cropSection()->setFolded(false);
  RangeSlider* range = rowNamed<RangeSlider>(m_panel, "Right–Left");
  ASSERT_NE(range, nullptr);
  type(widgetNamed<NumberField>(*range, "Right–Left, Left"), QStringLiteral("60"));
  EXPECT_EQ(m_scene.crop, (CropBox{{0.0123456789, 0.25, 0.0}, {0.6, 1.0, 1.0}}));
  EXPECT_EQ(m_gestures.back().text, QStringLiteral("crop right–left"));
  QTest::mouseClick(widgetNamed<QPushButton>(*m_panel.cropSection(), "Reset crop"), Qt::LeftButton);
  EXPECT_EQ(m_scene.crop, CropBox{});
  EXPECT_EQ(m_gestures.back().text, QStringLiteral("reset crop"));
  EXPECT_FALSE(widgetNamed<QPushButton>(*m_panel.cropSection(), "Reset crop")->isEnabled());
}

TEST_F(SceneSections, typedMillimetresCutThere) {
  m_panel.cropSection()->setFolded(false);
  RangeSlider* range = rowNamed<RangeSlider>(m_panel, "Right–Left");
  ASSERT_NE(range, nullptr);
  const Grid& grid = m_scene.volume->grid();
  type(widgetNamed<NumberField>(*range, "Right–Left, Right"), QStringLiteral("48 mm"));
  EXPECT_NEAR(m_scene.crop.lower.x * grid.dims.x * grid.spacingMm.x, 48.0, 1e-9);
  EXPECT_EQ(m_scene.crop.upper.x, 1.0);
}

TEST_F(SceneSections, aRangeStopsOneVoxelBeforeItsOtherEnd) {
  m_panel.cropSection()->setFolded(false);
  RangeSlider* range = rowNamed<RangeSlider>(m_panel, "Feet–Head");
  NumberField* head = widgetNamed<NumberField>(*range, "Feet–Head, Head");
  const double before = m_scene.crop.upper.z;
  type(head, QStringLiteral("0"));
  EXPECT_EQ(m_scene.crop.upper.z, before);
  EXPECT_TRUE(head->refusal().contains(QStringLiteral("does not fit: give a number from 2.9")))
      << head->refusal().toStdString();
  auto* track = range->findChild<TrackSlider*>();
  QTest::mousePress(track, Qt::LeftButton, {}, track->handleCentre(1).toPoint());
  QTest::mouseMove(track, track->handleCentre(0).toPoint() - QPoint(20, 0));
  QTest::mouseRelease(track, Qt::LeftButton, {}, track->handleCentre(0).toPoint() - QPoint(20, 0));
  EXPECT_DOUBLE_EQ(m_scene.crop.upper.z, 1.0 / m_scene.volume->grid().dims.z);
  EXPECT_EQ(m_scene.crop.lower.z, 0.0);
  EXPECT_NEAR(widgetNamed<NumberField>(*range, "Feet–Head, Head")->number(), 100.0 * m_scene.crop.upper.z,
              1e-12);
}

TEST_F(SceneSections, fogBeginsVisiblyAndShowsOnlyItsNumbers) {
  FogSection* fog = m_panel.findChild<FogSection*>();
  EXPECT_TRUE(fog->isFolded());
  EXPECT_TRUE(headerSays(fog, QStringLiteral("off")));
  fog->setFolded(false);
  EXPECT_FALSE(rowNamed<ValueSlider>(*fog, "Begins at")->isVisible());
  choose(fog->findChild<ChoiceRow*>(), static_cast<int>(Fog::Mode::exp));
  EXPECT_EQ(m_scene.fog.mode, Fog::Mode::exp);
  EXPECT_GT(m_scene.fog.densityPerMm, 0.0);
  EXPECT_TRUE(rowNamed<ValueSlider>(*fog, "Density (ρ)")->isVisible());
  EXPECT_FALSE(rowNamed<ValueSlider>(*fog, "Full at")->isVisible());
  EXPECT_TRUE(headerSays(fog, QStringLiteral("on")));
  choose(fog->findChild<ChoiceRow*>(), static_cast<int>(Fog::Mode::linear));
  EXPECT_FALSE(rowNamed<ValueSlider>(*fog, "Density (ρ)")->isVisible());
  type(rowNamed<ValueSlider>(*fog, "Full at")->findChild<NumberField*>(), QStringLiteral("1234"));
  EXPECT_EQ(m_scene.fog.endMm, 1234.0);
}

TEST_F(SceneSections, fogSaysWhyItDoesNothing) {
  FogSection* fog = m_panel.findChild<FogSection*>();
  m_scene.fog = {Fog::Mode::exp, {}, 0.0, 0.0, 1000.0};
  m_panel.setScene(m_scene);
  EXPECT_TRUE(headerSays(fog, QStringLiteral("off: its density is 0")));
  m_scene.fog.densityPerMm = 0.01;
  m_scene.projection = Projection::average;
  m_panel.setScene(m_scene);
  EXPECT_TRUE(headerSays(fog, QStringLiteral("unused: this projection has no depth")));
}

TEST_F(SceneSections, preintegrationAndJitterAreEditedOnTheirOwn) {
  m_scene.quality.stepVoxels = 0.123456789;
  m_panel.setScene(m_scene);
  auto* row = m_panel.findChild<QualitySection*>()->findChild<ChoiceRow*>();
  auto* jitter = m_panel.findChild<QualitySection*>()->findChild<QCheckBox*>();
  Quality expected = m_scene.quality;
  EXPECT_FALSE(jitter->isChecked());
  choose(row, static_cast<int>(Preintegration::never));
  expected.preintegrated = Preintegration::never;
  EXPECT_EQ(m_scene.quality, expected);
  QTest::mouseClick(jitter, Qt::LeftButton, {}, {8, jitter->height() / 2});
  expected.jitter = true;
  EXPECT_EQ(m_scene.quality, expected);
}

} // namespace
} // namespace limn
