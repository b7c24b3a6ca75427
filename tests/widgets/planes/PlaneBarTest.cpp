// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneHost.h"

#include "widgets/controls/NumberField.h"
#include "widgets/planes/PlaneBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include <gtest/gtest.h>

namespace limn {
namespace {

template <class Widget>
Widget* named(const QWidget& parent, const QString& accessibleName) {
  for (Widget* widget : parent.findChildren<Widget*>())
    if (widget->accessibleName() == accessibleName)
      return widget;
  return nullptr;
}

QToolButton* buttonSaying(const QWidget& parent, const QString& text) {
  for (QToolButton* button : parent.findChildren<QToolButton*>())
    if (button->text() == text)
      return button;
  return nullptr;
}

class PlaneBarTest : public testing::Test {
protected:
  PlaneBarTest() : host(test::contentOf(phantomVolume({.spacingMm = 16.0}))) {
    host.widget.resize(800, 40);
    host.widget.show();
  }

  void type(const QString& name, const QString& text) {
    auto* field = named<NumberField>(host.widget, name);
    ASSERT_NE(field, nullptr) << name.toStdString();
    auto* line = field->findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
  }

  // Chooses from the menu of a button, by the start of the text.
  bool choose(const QString& button, const QString& text) {
    QMenu* menu = buttonSaying(host.widget, button)->menu();
    emit menu->aboutToShow();
    for (QAction* action : menu->actions())
      if (action->text().startsWith(text)) {
        action->trigger();
        return true;
      }
    return false;
  }

  test::PlaneHost<PlaneBar> host;
};

TEST_F(PlaneBarTest, windowsAreTyped) {
  type(QStringLiteral("Window width"), QStringLiteral("80"));
  type(QStringLiteral("Window level"), QStringLiteral("40"));
  EXPECT_EQ(host.settings().window, (GreyWindow{40.0, 80.0}));
  type(QStringLiteral("Window width"), QStringLiteral("0"));
  EXPECT_EQ(host.settings().window, (GreyWindow{40.0, 80.0})) << "no width is none";
  EXPECT_FALSE(named<NumberField>(host.widget, QStringLiteral("Window width"))->refusal().isEmpty());
}

TEST_F(PlaneBarTest, aWindowThatShowsNothingIsRefusedWithWhatFits) {
  type(QStringLiteral("Window level"), QStringLiteral("40"));
  const PlaneSettings before = host.settings();
  type(QStringLiteral("Window level"), QStringLiteral("9999999"));
  EXPECT_EQ(host.settings().window, before.window) << "the phantom ends below 1000 HU";
  auto* level = named<NumberField>(host.widget, QStringLiteral("Window level"));
  const ValueRange values = host.content.volume->range();
  EXPECT_TRUE(level->refusal().contains(level->textFromValue(values.highest)))
      << level->refusal().toStdString();
  type(QStringLiteral("Window width"), QStringLiteral("9999999"));
  EXPECT_EQ(host.settings().window, before.window);
  // A window from elsewhere that lies outside is shown as it is.
  host.content.settings.window = GreyWindow{5000.0, 80.0};
  host.widget.setContent(host.content);
  EXPECT_EQ(level->number(), 5000.0);
  EXPECT_EQ(level->value(), 5000.0);
}

// Of values between 0 and 1, whatever width was typed.
TEST_F(PlaneBarTest, theLevelIsSaidAsExactlyAsTheValuesNeed) {
  Grid grid;
  grid.dims = {4, 4, 4};
  std::vector<float> values(64);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(i) / 63.0f;
  host.content = test::contentOf(
      std::make_shared<const Volume>(grid, VoxelArray(values), Rescale{}, std::nullopt, VolumeInfo{}));
  host.content.settings.window = GreyWindow{0.234, 99999.0};
  host.widget.setContent(host.content);
  const auto* level = named<NumberField>(host.widget, QStringLiteral("Window level"));
  EXPECT_EQ(level->text(), QLocale().toString(0.234));
  type(QStringLiteral("Window width"), QStringLiteral("0.5"));
  EXPECT_EQ(host.settings().window, (GreyWindow{0.234, 0.5})) << "and the way back is open";
}

TEST_F(PlaneBarTest, windowsOfTissuesAreChosenWhereValuesAreHounsfieldUnits) {
  const std::pair<const char*, GreyWindow> windows[] = {{"Soft tissue", {40.0, 400.0}},
                                                        {"Lung", {-600.0, 1500.0}},
                                                        {"Bone", {400.0, 1800.0}},
                                                        {"Brain", {40.0, 80.0}}};
  for (const auto& [name, window] : windows) {
    ASSERT_TRUE(choose(QStringLiteral("Window"), QLatin1String(name))) << name;
    EXPECT_EQ(host.settings().window, window) << name;
  }
  ASSERT_TRUE(choose(QStringLiteral("Window"), QStringLiteral("Full range")));
  EXPECT_EQ(host.settings().window, fullWindow(host.content.volume->range()));

  host.content = test::contentOf(test::countingVolume({6, 5, 4}, glm::dvec3(1.0)));
  host.widget.setContent(host.content);
  EXPECT_FALSE(choose(QStringLiteral("Window"), QStringLiteral("Lung"))) << "these are no Hounsfield units";
  EXPECT_TRUE(choose(QStringLiteral("Window"), QStringLiteral("As at first")));
  host.content.firstWindow = {600.0, 1200.0};
  host.widget.setContent(host.content);
  ASSERT_TRUE(choose(QStringLiteral("Window"), QStringLiteral("Dark tissue")));
  EXPECT_EQ(host.settings().window, (GreyWindow{300.0, 600.0}));
  ASSERT_TRUE(choose(QStringLiteral("Window"), QStringLiteral("Bright tissue")));
  EXPECT_EQ(host.settings().window, (GreyWindow{900.0, 600.0}));
}

TEST_F(PlaneBarTest, slabTintAndInterpolationAreChosen) {
  auto* mode = named<QComboBox>(host.widget, QStringLiteral("Slab shows"));
  ASSERT_NE(mode, nullptr);
  EXPECT_FALSE(mode->isEnabled()) << "of a plane there is no mean";
  type(QStringLiteral("Slab thickness in mm"), QStringLiteral("12.5"));
  EXPECT_EQ(host.settings().slab.thicknessMm, 12.5);
  EXPECT_TRUE(mode->isEnabled());
  mode->setFocus();
  QTest::keyClick(mode, Qt::Key_Down);
  EXPECT_EQ(host.settings().slab.mode, Slab::Mode::maximum);
  QTest::mouseClick(buttonSaying(host.widget, QStringLiteral("Tint")), Qt::LeftButton);
  EXPECT_TRUE(host.settings().isTinted);
  ASSERT_TRUE(choose(QStringLiteral("More"), QStringLiteral("Interpolate")));
  EXPECT_EQ(host.settings().interpolation, PlaneInterpolation::nearest);
  ASSERT_TRUE(choose(QStringLiteral("More"), QStringLiteral("Outline")));
  EXPECT_FALSE(host.settings().outlinesRegion);
}

TEST_F(PlaneBarTest, allOfItIsSeenInNarrowWindows) {
  for (const int width : {800, 380, 338}) {
    host.widget.resize(width, host.widget.heightAt(width));
    QApplication::processEvents();
    for (const QToolButton* button : host.widget.findChildren<QToolButton*>()) {
      const QRect place(button->mapTo(&host.widget, QPoint(0, 0)), button->size());
      EXPECT_TRUE(host.widget.rect().contains(place)) << button->text().toStdString() << ' ' << width;
      EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString() << ' ' << width;
    }
    for (const QLabel* label : host.widget.findChildren<QLabel*>())
      EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString() << ' ' << width;
    const auto* mode = host.widget.findChild<QComboBox*>();
    EXPECT_GE(mode->width(), mode->sizeHint().width()) << width;
  }
}

TEST(PlaneDeckWidget, givesItsToolsToAllSlices) {
  auto* picture = new QWidget;
  PlaneContent content = test::contentOf(test::countingVolume({20, 20, 20}, glm::dvec3(1.0)));
  content.settings.layout = PlaneLayout::pictureAndThree;
  test::PlaneHost<PlaneDeck> host(content, *picture);
  host.widget.resize(700, 500);
  host.widget.show();
  QTest::mouseClick(named<QToolButton>(host.widget, QStringLiteral("Distance (D)")), Qt::LeftButton);
  for (const PatientPlane plane : patientPlanes) {
    PlaneView& view = *host.widget.view(plane);
    test::drag(view, {60, 60}, {100, 60});
    ASSERT_FALSE(host.measurements().empty());
    EXPECT_EQ(host.measurements().back().plane, plane);
  }
  EXPECT_EQ(host.measurements().size(), 3u);
  QTest::keyClick(host.widget.view(PatientPlane::axial), Qt::Key_Escape);
  test::drag(*host.widget.view(PatientPlane::coronal), {60, 40}, {70, 40});
  EXPECT_TRUE(host.settings().crosshairMm) << "Esc returned to the crosshair everywhere";
}

TEST(PlaneDeckWidget, oneButtonHasAllToolsThatMeasureAndKeepsTheLast) {
  auto* picture = new QWidget;
  PlaneContent content = test::contentOf(test::countingVolume({20, 20, 20}, glm::dvec3(1.0)));
  content.settings.layout = PlaneLayout::pictureAndThree;
  test::PlaneHost<PlaneDeck> host(content, *picture);
  host.widget.resize(700, 500);
  host.widget.show();
  auto* button = host.widget.findChild<QToolButton*>(QStringLiteral("measureTool"));
  ASSERT_NE(button, nullptr);
  EXPECT_FALSE(button->isChecked());
  host.widget.findChild<QAction*>(QStringLiteral("plane-tool-ellipse"))->trigger();
  EXPECT_TRUE(button->isChecked());
  EXPECT_EQ(button->accessibleName(), QStringLiteral("Ellipse (E)"));
  test::drag(*host.widget.view(PatientPlane::axial), {60, 60}, {100, 90});
  ASSERT_EQ(host.measurements().size(), 1u);
  EXPECT_EQ(host.measurements().front().kind, Measurement::Kind::ellipse);
  QTest::keyClick(host.widget.view(PatientPlane::axial), Qt::Key_Escape);
  EXPECT_FALSE(button->isChecked());
  QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(8, button->height() / 2));
  EXPECT_TRUE(button->isChecked());
  test::drag(*host.widget.view(PatientPlane::coronal), {60, 60}, {100, 90});
  EXPECT_EQ(host.measurements().back().kind, Measurement::Kind::ellipse) << "the tool that measured last";
}

TEST(PlaneDeckWidget, aClickInOneSliceMovesTheOthers) {
  auto* picture = new QWidget;
  PlaneContent content = test::contentOf(test::countingVolume({40, 40, 40}, glm::dvec3(1.0)));
  content.settings.layout = PlaneLayout::pictureAndThree;
  test::PlaneHost<PlaneDeck> host(content, *picture);
  host.widget.resize(700, 500);
  host.widget.show();
  PlaneView& axial = *host.widget.view(PatientPlane::axial);
  QTest::mouseClick(&axial, Qt::LeftButton, {}, pointOf(axial.frame(), {8.0, 30.0, 19.0}).toPoint());
  const glm::dvec3 crosshair = crosshairOf(host.content);
  EXPECT_NEAR(crosshair.x, 8.0, 0.2);
  const PlaneView& sagittal = *host.widget.view(PatientPlane::sagittal);
  EXPECT_EQ(sagittal.frame().grid.originMm.x, crosshair.x) << "the slice through it";
  EXPECT_EQ(host.widget.view(PatientPlane::coronal)->frame().grid.originMm.y, crosshair.y);
  EXPECT_FALSE(sagittal.visibleRegion().isEmpty());
}

} // namespace
} // namespace limn
