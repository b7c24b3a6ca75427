// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/TourController.h"
#include "app/panels/presets/ThumbnailController.h"
#include "app/picture/CutController.h"
#include "app/picture/RegionController.h"
#include "app/pictures/PicturedWindow.h"
#include "app/pictures/SmallVolumes.h"
#include "widgets/FindWidget.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/MapSection.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/PointFields.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/EffectsPanel.h"
#include "widgets/properties/PropertiesPanel.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QPushButton>

#include <algorithm>
#include <array>

// Pictures of the window and of its parts.

namespace limn {
namespace {

class PanelPictures : public test::PicturedWindow {
protected:
  QDockWidget& raised(const char* name) {
    auto* dock = window->findChild<QDockWidget*>(QLatin1String(name));
    dock->raise();
    QCoreApplication::processEvents();
    return *dock;
  }

  void unfoldOnly(const FoldingSection& wanted) {
    for (FoldingSection* section : window->findChildren<FoldingSection*>())
      section->setFolded(section != &wanted);
    QCoreApplication::processEvents();
  }

  // Where a point of the curve lies in the window; the first that is neither transparent nor opaque.
  QPoint pointOfTheCurve() {
    const TransferFunctionCanvas& canvas = *curves().valueEditor()->canvas();
    for (const ControlPoint& point : canvas.transferFunction().points)
      if (point.opacity > 0.05 && point.opacity < 0.95)
        return canvas
            .mapTo(window.get(), QPointF(xOfValue(canvas.transform(), point.value),
                                         yOfOpacity(canvas.transform(), point.opacity)))
            .toPoint();
    return {};
  }
};

TEST_F(PanelPictures, ofThePageWithoutAVolume) {
  take(QStringLiteral("empty"));
  ASSERT_TRUE(openVolume());
  action("closeVolume").trigger();
  take(QStringLiteral("empty-with-recent"));
}

TEST_F(PanelPictures, ofTheTour) {
  window->findChild<TourController*>()->offer();
  take(QStringLiteral("tour-offered"));
  action("tour").trigger();
  take(QStringLiteral("tour-without-a-volume"));
  ASSERT_TRUE(openVolume());
  auto* next = window->findChild<QPushButton*>(QStringLiteral("tourNext"));
  for (int step = 1; step <= 6; ++step, next->click())
    take(QStringLiteral("tour-%1").arg(step));
}

TEST_F(PanelPictures, ofEveryLayout) {
  ASSERT_TRUE(openVolume());
  take(QStringLiteral("window"));
  for (QActionGroup* group : window->findChildren<QActionGroup*>())
    for (QAction* choice : group->actions())
      if (choice->objectName().startsWith(QLatin1String("layout-"))) {
        choice->trigger();
        take(choice->objectName());
      }
}

TEST_F(PanelPictures, ofARayAndWhatItMeets) {
  ASSERT_TRUE(openVolume());
  action("planes-picture_and_three").trigger();
  action("layout-single").trigger();
  window->findChild<QDockWidget*>(QStringLiteral("rayDock"))->toggleViewAction()->trigger();
  ASSERT_TRUE(rest());
  QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, Qt::ShiftModifier,
                    view().mapTo(window.get(), view().rect().center() + QPoint(0, 20)));
  take(QStringLiteral("ray"));
}

TEST_F(PanelPictures, ofWhatAPointGoverns) {
  ASSERT_TRUE(openVolume());
  action("planes-picture_and_three").trigger();
  action("layout-single").trigger();
  curves().valueEditor()->canvas()->setFocus();
  curves().valueEditor()->canvas()->selectPoints({4});
  QTest::keyClick(window->windowHandle(), Qt::Key_H);
  take(QStringLiteral("point-governs"));
}

TEST_F(PanelPictures, ofTheGallery) {
  ASSERT_TRUE(openVolume());
  window->findChild<PresetBrowser*>()->setGallery(true);
  auto& thumbnails = *window->findChild<ThumbnailController*>();
  thumbnails.drawNow();
  ASSERT_TRUE(test::waitUntil([&] { return thumbnails.isComplete(); }));
  take(QStringLiteral("gallery"));
}

TEST_F(PanelPictures, ofSuggestedBands) {
  ASSERT_TRUE(openVolume("phantom:4")); // as fine as bands need
  action("suggest").trigger();
  const auto offered = [&]() -> QPushButton* {
    for (QPushButton* button : window->findChildren<QPushButton*>())
      if (button->accessibleName().startsWith(QStringLiteral("Use the band")) && button->isEnabled())
        return button;
    return nullptr;
  };
  ASSERT_TRUE(test::waitUntil([&] { return offered() != nullptr; }));
  QWidget& row = *offered()->parentWidget();
  const QPointF centre = QRectF(row.rect()).center();
  QEnterEvent enter(centre, centre, row.mapToGlobal(centre));
  QCoreApplication::sendEvent(&row, &enter); // shows the band
  take(QStringLiteral("suggested-bands"));
}

TEST_F(PanelPictures, ofSlicesBesideThePicture) {
  ASSERT_TRUE(openVolume());
  for (QActionGroup* group : window->findChildren<QActionGroup*>())
    for (QAction* choice : group->actions())
      if (choice->objectName().startsWith(QLatin1String("planes-"))) {
        choice->trigger();
        take(choice->objectName());
      }
  PlaneSettings tinted = session().planes();
  tinted.layout = PlaneLayout::pictureAndThree;
  tinted.isTinted = true;
  session().setPlanes(tinted);
  setLayout(CompareLayout::single);
  take(QStringLiteral("slices-tinted"));
}

TEST_F(PanelPictures, ofEveryTool) {
  ASSERT_TRUE(openVolume());
  for (QActionGroup* group : window->findChildren<QActionGroup*>())
    for (QAction* choice : group->actions())
      if (choice->objectName().startsWith(QLatin1String("tool-"))) {
        choice->trigger();
        take(choice->objectName(), *window->findChild<QToolBar*>());
      }
}

TEST_F(PanelPictures, ofWhatLiesOverThePicture) {
  ASSERT_TRUE(openVolume());
  setLayout(CompareLayout::single);
  action("cropBox").trigger();
  take(QStringLiteral("crop-box"));
  action("cropBox").trigger();
  view().setLoading(0.4, QStringLiteral("Reading head.nii.gz"));
  take(QStringLiteral("loading"));
  view().clearLoading();
  action("pictureOnly").trigger();
  take(QStringLiteral("picture-only"));
}

TEST_F(PanelPictures, ofACutThroughHalfOfTheVolume) {
  ASSERT_TRUE(openVolume());
  action("cropBox").trigger();
  CropBox half;
  half.upper.y = 0.5; // seen from the front
  session().setCrop(half, {nextGestureId(), QStringLiteral("crop")});
  take(QStringLiteral("crop-box-cutting"));
}

// Places are shares of the picture's height from its middle, as the sample lies when it opens.
TEST_F(PanelPictures, ofCutsByHand) {
  ASSERT_TRUE(openVolume());
  setLayout(CompareLayout::single);
  const QRectF picture = view().logicalRect(0);
  const auto at = [&](double x, double y) {
    return view().mapTo(window.get(), (picture.center() + picture.height() * QPointF(x, y)).toPoint());
  };
  const auto moveTo = [&](const QPoint& place) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, place);
  };
  action("tool-scissors").trigger();
  const std::array<QPointF, 8> aroundTheJaw{{{-0.3, 0.16},
                                             {-0.18, 0.2},
                                             {0.0, 0.2},
                                             {0.18, 0.2},
                                             {0.3, 0.16},
                                             {0.3, 0.46},
                                             {0.0, 0.48},
                                             {-0.3, 0.46}}};
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, at(-0.3, 0.16));
  for (const QPointF& corner : aroundTheJaw)
    moveTo(at(corner.x(), corner.y()));
  take(QStringLiteral("cut-line"));
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, at(-0.3, 0.46));
  auto& regions = *window->findChild<RegionController*>();
  ASSERT_TRUE(test::waitUntil([&] { return !regions.isBusy(); }));
  take(QStringLiteral("cut-away"));
  action("undo").trigger();
  action("tool-piece").trigger();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, at(0.0, -0.2));
  auto& cutting = *window->findChild<CutController*>();
  ASSERT_TRUE(test::waitUntil([&] { return !cutting.isBusy(); }));
  take(QStringLiteral("cut-piece"));
}

TEST_F(PanelPictures, ofLooksThatAreCompared) {
  ASSERT_TRUE(openVolume());
  setLayout(CompareLayout::single);
  auto& presets = *window->findChild<PresetBrowser*>();
  emit presets.presetChosen(QStringLiteral("CT muscle"));
  action("takeSnapshot").trigger();
  emit presets.presetChosen(QStringLiteral("CT bone"));
  action("compareSnapshot").trigger();
  auto& thumbnails = *window->findChild<ThumbnailController*>();
  ASSERT_TRUE(rest());
  thumbnails.drawNow();
  ASSERT_TRUE(test::waitUntil([&] { return thumbnails.isComplete(); }));
  take(QStringLiteral("looks-compared"));
}

TEST_F(PanelPictures, ofMessages) {
  ASSERT_TRUE(openVolume());
  ASSERT_TRUE(open(pathTo("missing.nii.gz")));
  take(QStringLiteral("error"));
  test::writeBall(folder.path() / "ball.nrrd", {}, test::BallKind::unknownOrientation);
  ASSERT_TRUE(open(pathTo("ball.nrrd")));
  take(QStringLiteral("unknown-orientation"));
  takeDialogOf("setOrientation", QStringLiteral("dialog-orientation"));
}

TEST_F(PanelPictures, ofEveryPanel) {
  ASSERT_TRUE(openVolume());
  dragAPoint();
  for (const char* name : {"presetDock", "historyDock", "shadingDock", "effectsDock", "accuracyDock"}) {
    QDockWidget& dock = raised(name);
    const QString panel = QStringLiteral("panel-") + dock.windowTitle().toLower();
    take(panel + QStringLiteral("-in-window"));
    take(panel, dock);
  }
}

TEST_F(PanelPictures, ofEverySectionOfTheProperties) {
  ASSERT_TRUE(openVolume());
  raised("shadingDock");
  for (FoldingSection* section : window->findChild<PropertiesPanel*>()->findChildren<FoldingSection*>()) {
    unfoldOnly(*section);
    const QString title = section->findChild<FoldingHeader*>()->accessibleName().toLower();
    take(QStringLiteral("properties-") + QString(title).replace(QLatin1Char(' '), QLatin1Char('-')),
         *section);
  }
}

TEST_F(PanelPictures, ofTheCurves) {
  ASSERT_TRUE(openVolume());
  take(QStringLiteral("curve"), curves());
  const QPoint at = pointOfTheCurve();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, at);
  take(QStringLiteral("curve-point"), curves());
  QTest::mouseDClick(window->windowHandle(), Qt::LeftButton, {}, at);
  auto* popup = window->findChild<PointPopup*>();
  ASSERT_TRUE(popup && test::waitUntil([&] { return popup->isVisible(); }));
  take(QStringLiteral("curve-point-popup"), *popup);
  popup->close();
  const QSize size = window->size();
  window->resize(900, size.height());
  auto* more = curves().valueEditor()->findChild<QToolButton*>(QStringLiteral("moreCurveTools"));
  ASSERT_TRUE(test::waitUntil([&] { return more->isVisible(); }));
  more->click();
  take(QStringLiteral("curve-more-tools"), *QApplication::activePopupWidget());
  take(QStringLiteral("curve-narrow"), curves());
  QApplication::activePopupWidget()->close();
  window->resize(size);
  curves().showGradient(true);
  QCheckBox* use = nullptr;
  for (QCheckBox* box : curves().gradientEditor()->findChildren<QCheckBox*>())
    use = box->text() == QStringLiteral("Use this curve") ? box : use;
  ASSERT_TRUE(use && test::waitUntil([&] { return use->isEnabled(); })); // once the gradients are counted
  use->click();
  take(QStringLiteral("curve-gradient"), curves());
}

TEST_F(PanelPictures, ofTheLabels) {
  ASSERT_TRUE(openVolume());
  test::writeBall(folder.path() / "parts.seg.nrrd", scene().volume->grid(), test::BallKind::labels);
  auto& regions = *window->findChild<RegionController*>();
  regions.openLabels(pathTo("parts.seg.nrrd"));
  ASSERT_TRUE(test::waitUntil([&] { return !regions.isBusy(); }));
  raised("shadingDock");
  for (FoldingSection* section : window->findChild<PropertiesPanel*>()->findChildren<FoldingSection*>())
    if (section->findChild<FoldingHeader*>()->accessibleName() == QStringLiteral("Labels"))
      unfoldOnly(*section);
  take(QStringLiteral("labels"));
}

// Of a coarse phantom, and the map in a smaller window, because it has the pixels of the screen.
TEST_F(PanelPictures, ofMeasuredEffectsAndAccuracy) {
  ASSERT_TRUE(openAlone(QStringLiteral("phantom:16")));
  ASSERT_TRUE(rest());
  QDockWidget& effects = raised("effectsDock");
  view().measureEffects();
  ASSERT_TRUE(test::waitUntil([&] { // however often the panels changed the picture's size meanwhile
    return std::ranges::any_of(effects.findChildren<EffectRowWidget*>(), &EffectRowWidget::showsCost);
  }));
  take(QStringLiteral("panel-effects-measured"), effects);
  QDockWidget& accuracy = raised("accuracyDock");
  auto& panel = *window->findChild<AccuracyPanel*>();
  const auto ends = [&] { return panel.work() == AccuracyWork::none; };
  QTest::mouseClick(widgetNamed<QPushButton>(panel, "Measure error and time"), Qt::LeftButton);
  take(QStringLiteral("panel-accuracy-measuring"), accuracy);
  ASSERT_TRUE(test::waitUntil(ends));
  take(QStringLiteral("panel-accuracy-measured"), *panel.widget());
  window->resize(1000, 700);
  ASSERT_TRUE(rest());
  panel.findChild<MapSection*>()->findChild<QCheckBox*>()->click();
  ASSERT_TRUE(test::waitUntil(ends));
  take(QStringLiteral("map-of-errors"));
}

} // namespace
} // namespace limn
