// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/PropertiesPanel.h"
#include "support/Waiting.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/shading/LightSection.h"
#include "widgets/shading/ShadingSection.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace limn {
namespace {

class PropertiesPanelTest : public testing::Test {
protected:
  PropertiesPanelTest() {
    m_panel.resize(320, 1200);
    m_panel.show();
    for (ShadingSection* section : m_panel.findChildren<ShadingSection*>())
      section->setFolded(false);
    QObject::connect(
        &m_panel, &PropertiesPanel::shadingEdited, &m_panel,
        [this](const Shading& shading, const Gesture& gesture) { m_edits.emplace_back(shading, gesture); });
  }

  PropertiesPanel m_panel;
  std::vector<std::pair<Shading, Gesture>> m_edits;
};

Shading unusual() {
  Shading shading;
  shading.model = ShadingModel::robust;
  shading.ambient = 0.123456789;
  shading.exponent = 77.7;
  shading.exponentRange = {2.0, 99.0};
  shading.opacityRange = {0.5, 7.5};
  shading.gradientReference = PercentileReference{98.7654321};
  shading.gradientCurve = {GradientCurve::Type::gamma, 0.5};
  shading.significance.reset();
  shading.knee.reset();
  shading.lightDirection = glm::dvec3(0.3, 0.4, -0.5);
  shading.twoSided = true;
  return shading;
}

TEST_F(PropertiesPanelTest, everyChoiceIsWideEnoughForItsText) {
  for (const QComboBox* box : m_panel.findChildren<QComboBox*>())
    EXPECT_GE(box->width(), box->sizeHint().width()) << box->accessibleName().toStdString();
}

// A notch of the wheel as the window system tells it, which gives the keyboard to what takes it by the wheel.
void turnWheelOver(QWidget& widget) {
  const QPointF at = QRectF(widget.rect()).center();
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QSpontaneKeyEvent::setSpontaneous(&event);
  qApp->notify(&widget, &event);
}

TEST_F(PropertiesPanelTest, theWheelScrollsOverWhatDoesNotHaveTheKeyboardAndChangesNothing) {
  m_panel.resize(320, 400);
  ASSERT_TRUE(QTest::qWaitForWindowActive(&m_panel));
  QCoreApplication::processEvents();
  QScrollBar& bar = *m_panel.verticalScrollBar();
  ASSERT_GT(bar.maximum(), 0);
  const auto expectScrolls = [&bar](QWidget& below, const QWidget& control) {
    bar.setValue(0);
    turnWheelOver(below);
    EXPECT_GT(bar.value(), 0) << control.accessibleName().toStdString();
    EXPECT_FALSE(control.hasFocus()) << control.accessibleName().toStdString();
  };
  const auto isThere = [](const QWidget* control) { return control->isVisible() && control->isEnabled(); };
  NumberField* turned = nullptr;
  for (NumberField* field : m_panel.findChildren<NumberField*>())
    if (isThere(field)) {
      expectScrolls(*field->findChild<QLineEdit*>(), *field);
      if (!turned && field->number() > field->minimum())
        turned = field;
    }
  for (QComboBox* box : m_panel.findChildren<QComboBox*>())
    if (isThere(box))
      expectScrolls(*box, *box);
  for (TrackSlider* slider : m_panel.findChildren<TrackSlider*>())
    if (isThere(slider))
      expectScrolls(*slider, *slider);
  EXPECT_TRUE(m_edits.empty());
  ASSERT_NE(turned, nullptr);
  turned->setFocus();
  bar.setValue(0);
  const double before = turned->number();
  ASSERT_TRUE(m_panel.isScrolling());
  turnWheelOver(*turned);
  EXPECT_EQ(turned->number(), before) << "it came under the pointer as the panel scrolled";
  EXPECT_GT(bar.value(), 0);
  ASSERT_TRUE(test::waitUntil([this] { return !m_panel.isScrolling(); }));
  turnWheelOver(*turned);
  EXPECT_LT(turned->number(), before) << "who has gone to a field may turn the wheel there";
}

TEST_F(PropertiesPanelTest, settingEmitsNothing) {
  int quality = 0;
  QObject::connect(&m_panel, &PropertiesPanel::qualityEdited, &m_panel, [&] { ++quality; });
  m_panel.setShading(unusual());
  m_panel.setModelsShown({ShadingModel::classic, ShadingModel::robust});
  Quality fine;
  fine.stepVoxels = 0.123;
  m_panel.setQuality(fine);
  m_panel.setShading({});
  EXPECT_TRUE(m_edits.empty());
  EXPECT_EQ(quality, 0);
}

TEST_F(PropertiesPanelTest, oneEditChangesOneNumberAndLeavesTheOthersExact) {
  m_panel.setShading(unusual());
  m_panel.setModelsShown({ShadingModel::robust});
  auto* diffuse = rowNamed<ValueSlider>(m_panel, "Diffuse (kd)");
  ASSERT_NE(diffuse, nullptr);
  diffuse->findChild<NumberField*>()->setFocus();
  diffuse->findChild<NumberField*>()->selectAll();
  QTest::keyClicks(diffuse->findChild<NumberField*>(), QLocale().toString(0.5));
  QTest::keyClick(diffuse->findChild<NumberField*>(), Qt::Key_Return);
  ASSERT_EQ(m_edits.size(), 1u);
  Shading expected = unusual();
  expected.diffuse = 0.5;
  EXPECT_EQ(m_edits.front().first, expected);
}

TEST_F(PropertiesPanelTest, theModelIsChosenFromTheList) {
  auto* model = rowNamed<ChoiceRow>(m_panel, "Model");
  model->box()->setFocus();
  QTest::keyClick(model->box(), Qt::Key_Down);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(m_edits.front().first.model, ShadingModel::enhanced);
}

TEST_F(PropertiesPanelTest, theRangeOfSharpnessIsOneSliderWithTwoHandles) {
  m_panel.setModelsShown({ShadingModel::enhanced});
  auto* range = rowNamed<RangeSlider>(m_panel, "Highlight sharpness (SP)");
  ASSERT_NE(range, nullptr);
  range->findChild<TrackSlider*>()->setFocus();
  QTest::keyClick(range->findChild<TrackSlider*>(), Qt::Key_Tab); // to the second handle
  QTest::keyClick(range->findChild<TrackSlider*>(), Qt::Key_End);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(m_edits.front().first.exponentRange, (CoefficientRange{1.0, 1024.0}));
}

TEST_F(PropertiesPanelTest, controlsOfModelsNotShownAreDisabledWithTheReason) {
  auto* sharpness = rowNamed<ValueSlider>(m_panel, "Highlight sharpness (SP)");
  auto* emphasis = rowNamed<RangeSlider>(m_panel, "Boundary emphasis (O)");
  m_panel.setModelsShown({ShadingModel::classic});
  EXPECT_TRUE(sharpness->isEnabled());
  EXPECT_FALSE(emphasis->isEnabled());
  EXPECT_TRUE(emphasis->toolTip().contains(QStringLiteral("enhanced and robust")));
  m_panel.setModelsShown({ShadingModel::robust});
  EXPECT_FALSE(sharpness->isEnabled());
  EXPECT_TRUE(emphasis->isEnabled());
  m_panel.setModelsShown({ShadingModel::none});
  EXPECT_FALSE(rowNamed<ValueSlider>(m_panel, "Ambient (ka)")->isEnabled());
}

// Of enhanced and robust, physical light has the sharpness of highlights on its surfaces, if there are any.
TEST_F(PropertiesPanelTest, physicalLightDisablesWhatItDoesNotUse) {
  auto* range = rowNamed<RangeSlider>(m_panel, "Highlight sharpness (SP)");
  const auto heading = [this](const char* text) -> QLabel* {
    for (auto* label : m_panel.findChildren<QLabel*>())
      if (label->text() == QLatin1String(text))
        return label;
    return nullptr;
  };
  m_panel.setModelsShown({ShadingModel::physical});
  const auto show = [this](double surface, double gloss) {
    Shading shading;
    shading.model = ShadingModel::physical;
    shading.physical.surface = surface;
    shading.physical.specularShare = gloss;
    m_panel.setShading(shading);
  };
  show(0.5, 0.5);
  EXPECT_TRUE(range->isEnabled());
  ASSERT_TRUE(heading("Enhanced, robust and physical"));
  EXPECT_TRUE(heading("Enhanced, robust and physical")->isEnabled());
  EXPECT_FALSE(rowNamed<RangeSlider>(m_panel, "Boundary emphasis (O)")->isEnabled());
  for (const auto& [surface, gloss] : {std::pair(0.0, 0.5), std::pair(0.5, 0.0)}) {
    show(surface, gloss);
    EXPECT_FALSE(range->isEnabled());
    EXPECT_TRUE(range->toolTip().contains(QStringLiteral("surfaces with gloss alone")));
    EXPECT_FALSE(heading("Enhanced, robust and physical")->isEnabled());
  }
  m_panel.setModelsShown({ShadingModel::enhanced});
  EXPECT_TRUE(range->isEnabled());
  ASSERT_TRUE(heading("Enhanced and robust"));
  EXPECT_TRUE(heading("Enhanced and robust")->isEnabled());
}

TEST_F(PropertiesPanelTest, aComparisonEnablesWhatEitherModelUses) {
  m_panel.setModelsShown({ShadingModel::classic, ShadingModel::enhanced}); // the scene's model is classic
  EXPECT_TRUE(rowNamed<ValueSlider>(m_panel, "Highlight sharpness (SP)")->isEnabled());
  EXPECT_TRUE(rowNamed<RangeSlider>(m_panel, "Boundary emphasis (O)")->isEnabled());
}

TEST_F(PropertiesPanelTest, besideALookThatIsKeptOnlyWhatTheOtherSideUsesIsEdited) {
  const auto* sharpness = rowNamed<ValueSlider>(m_panel, "Highlight sharpness (SP)");
  const auto* emphasis = rowNamed<RangeSlider>(m_panel, "Boundary emphasis (O)");
  const auto* said = m_panel.findChild<QLabel*>(QStringLiteral("keptLook"));
  ASSERT_TRUE(sharpness && emphasis && said);
  EXPECT_FALSE(said->isVisible());
  m_panel.setModelsShown({ShadingModel::classic, ShadingModel::enhanced}, QStringLiteral("CT <skin>"));
  EXPECT_FALSE(sharpness->isEnabled()) << "it would change neither side";
  EXPECT_TRUE(sharpness->toolTip().contains(QStringLiteral("swap the sides")));
  EXPECT_TRUE(emphasis->isEnabled());
  EXPECT_TRUE(said->isVisible());
  EXPECT_TRUE(said->text().startsWith(QStringLiteral("\"CT <skin>\" at the left stays as it is")));
  EXPECT_TRUE(rowNamed<ChoiceRow>(m_panel, "Model, left")->isVisible()) << "the model is chosen there, too";
  m_panel.setModelsShown({ShadingModel::classic, ShadingModel::enhanced});
  EXPECT_TRUE(sharpness->isEnabled()) << "two models of one look";
  EXPECT_FALSE(said->isVisible());
}

TEST_F(PropertiesPanelTest, howFarPicturesAreSavedIsSetForALookThatIsKeptToo) {
  const auto* until = rowNamed<ChoiceRow>(m_panel, "Drawn until");
  const auto* density = rowNamed<ValueSlider>(m_panel, "Density");
  ASSERT_TRUE(until && density);
  m_panel.setModelsShown({ShadingModel::physical, ShadingModel::enhanced}, QStringLiteral("CT skin"));
  EXPECT_TRUE(until->isEnabled());
  EXPECT_FALSE(density->isEnabled());
  m_panel.setModelsShown({ShadingModel::classic, ShadingModel::enhanced}, QStringLiteral("CT skin"));
  EXPECT_FALSE(until->isEnabled());
}

TEST_F(PropertiesPanelTest, aComparisonHasAModelForEachSideEvenWhereNothingIsLit) {
  m_panel.show();
  EXPECT_TRUE(rowNamed<ChoiceRow>(m_panel, "Model")->isVisible());
  EXPECT_FALSE(rowNamed<ChoiceRow>(m_panel, "Model, right")->isVisible());
  std::vector<std::pair<int, ShadingModel>> chosen;
  QObject::connect(&m_panel, &PropertiesPanel::modelChosen, &m_panel,
                   [&](int side, ShadingModel model) { chosen.emplace_back(side, model); });
  m_panel.setModelsShown({ShadingModel::classic, ShadingModel::robust});
  EXPECT_FALSE(rowNamed<ChoiceRow>(m_panel, "Model")->isVisible());
  auto* right = rowNamed<ChoiceRow>(m_panel, "Model, right");
  ASSERT_TRUE(right->isVisible() && right->isEnabled());
  EXPECT_EQ(right->box()->currentIndex(), static_cast<int>(ShadingModel::robust));
  right->box()->setFocus();
  QTest::keyClick(right->box(), Qt::Key_Up);
  auto* left = rowNamed<ChoiceRow>(m_panel, "Model, left");
  left->box()->setFocus();
  QTest::keyClick(left->box(), Qt::Key_Up);
  EXPECT_EQ(chosen, (std::vector<std::pair<int, ShadingModel>>{{1, ShadingModel::enhanced},
                                                               {0, ShadingModel::none}}));
  EXPECT_TRUE(m_edits.empty()) << "the scene's own model is another matter";
}

TEST_F(PropertiesPanelTest, aDoubleClickOnANameResets) {
  Shading shading;
  shading.opacityRange = {1.0, 1.0};
  m_panel.setShading(shading);
  m_panel.setModelsShown({ShadingModel::enhanced});
  QTest::mouseDClick(rowNamed<RangeSlider>(m_panel, "Boundary emphasis (O)")->findChild<ResetLabel*>(),
                     Qt::LeftButton);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(m_edits.front().first, Shading{});
}

TEST_F(PropertiesPanelTest, aDragIsOneGesture) {
  auto* slider = rowNamed<ValueSlider>(m_panel, "Highlight sharpness (SP)")->findChild<TrackSlider*>();
  const QPoint from = slider->handleCentre(0).toPoint();
  QTest::mousePress(slider, Qt::LeftButton, {}, from);
  for (const int dx : {5, 10, 15}) {
    const QPoint at = from + QPoint(dx, 0);
    QMouseEvent event(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(slider, &event);
  }
  QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(15, 0));
  ASSERT_EQ(m_edits.size(), 3u);
  EXPECT_EQ(m_edits.front().second.id, m_edits.back().second.id);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("change highlight sharpness (SP)"));
}

TEST_F(PropertiesPanelTest, qualityIsEditedOnItsOwn) {
  std::vector<Quality> edits;
  QObject::connect(&m_panel, &PropertiesPanel::qualityEdited, &m_panel,
                   [&](const Quality& quality) { edits.push_back(quality); });
  Quality quality;
  quality.jitter = true;
  m_panel.setQuality(quality);
  auto* step = rowNamed<ValueSlider>(m_panel, "Step");
  step->findChild<NumberField*>()->setFocus();
  step->findChild<NumberField*>()->selectAll();
  QTest::keyClicks(step->findChild<NumberField*>(), QStringLiteral("1"));
  QTest::keyClick(step->findChild<NumberField*>(), Qt::Key_Return);
  ASSERT_EQ(edits.size(), 1u);
  quality.stepVoxels = 1.0;
  EXPECT_EQ(edits.front(), quality);
}

TEST_F(PropertiesPanelTest, aStepOfOneIsOneVoxel) {
  auto& field = *rowNamed<ValueSlider>(m_panel, "Step")->findChild<NumberField*>();
  const auto typed = [&field](const char* keys) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QString::fromLatin1(keys));
    QTest::keyClick(&field, Qt::Key_Return);
    return field.text();
  };
  const QSize before = field.sizeHint();
  EXPECT_EQ(typed("1"), QStringLiteral("1\u00a0voxel"));
  EXPECT_EQ(field.sizeHint(), before) << "the row stays as it is";
  EXPECT_EQ(typed("2 voxels"), QStringLiteral("2\u00a0voxels"));
  EXPECT_EQ(typed("1 voxel"), QStringLiteral("1\u00a0voxel"));
  EXPECT_EQ(typed("0.5"), QStringLiteral("0.5\u00a0voxels"));
  Quality quality;
  quality.stepVoxels = 1.0;
  m_panel.setQuality(quality);
  EXPECT_EQ(field.text(), QStringLiteral("1\u00a0voxel"));
}

TEST_F(PropertiesPanelTest, everyControlHasAnAccessibleNameAndAToolTip) {
  const auto hasToolTip = [](const QWidget* widget) {
    for (; widget; widget = widget->parentWidget())
      if (!widget->toolTip().isEmpty())
        return true;
    return false;
  };
  int controls = 0;
  for (const QWidget* widget : m_panel.findChildren<QWidget*>()) {
    const bool control =
        qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
        qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const TrackSlider*>(widget);
    // A view inside a list and a scroll bar's parts are Qt's own.
    if (!control || QString(widget->metaObject()->className()).startsWith(QStringLiteral("QComboBoxPrivate")))
      continue;
    ++controls;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
    EXPECT_TRUE(hasToolTip(widget)) << widget->accessibleName().toStdString();
  }
  EXPECT_GT(controls, 30);
}

TEST(LightAngles, followThePatient) {
  // LPS: in front is -y, so light from the front travels along +y; from the left (+x) along -x; from above
  // along -z.
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-12; };
  EXPECT_TRUE(near(travelDirection({0.0, 0.0}), {0.0, 1.0, 0.0}));
  EXPECT_TRUE(near(travelDirection({90.0, 0.0}), {-1.0, 0.0, 0.0}));
  EXPECT_TRUE(near(travelDirection({0.0, 90.0}), {0.0, 0.0, -1.0}));
  const LightAngles back = lightAngles(travelDirection({-120.0, 35.0}) * 7.0);
  EXPECT_NEAR(back.azimuthDeg, -120.0, 1e-9);
  EXPECT_NEAR(back.elevationDeg, 35.0, 1e-9);
}

} // namespace
} // namespace limn
