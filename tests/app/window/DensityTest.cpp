// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/shading/LightSection.h"

#include <QDockWidget>
#include <QMouseEvent>
#include <QStatusBar>
#include <QTabBar>
#include <QTreeView>

// How much a new window of 1280×800 pixels has room for.

namespace limn {
namespace {

class Density : public test::WindowHarness {
protected:
  void SetUp() override {
    // A window that had another size before divides itself differently.
    window = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
    window->resize(1280, 800);
    window->view().setRefinesAtRest(false);
    window->show();
    WindowHarness::SetUp();
    ASSERT_TRUE(open(QStringLiteral("phantom:4")));
    QCoreApplication::processEvents();
  }

  QDockWidget& dock(const char* name) const { return *window->findChild<QDockWidget*>(QLatin1String(name)); }

  // How often the window says a dock's name, as a tab and above it.
  int headings(const QString& name) const {
    int count = 0;
    for (const QTabBar* tabs : window->findChildren<QTabBar*>())
      for (int i = 0; !tabs->visibleRegion().isEmpty() && i < tabs->count(); ++i)
        count += tabs->tabText(i) == name;
    for (const QDockWidget* one : window->findChildren<QDockWidget*>())
      count += one->windowTitle() == name && !one->visibleRegion().isEmpty() && !one->titleBarWidget();
    return count;
  }
};

// The picture has the room: who shapes a curve in detail drags its panel higher, or folds the others.
TEST_F(Density, thePlotIsAtLeast80PixelsHigh) {
  EXPECT_GE(curves().valueEditor()->canvas()->transform().plot.height(), 80.0);
}

TEST_F(Density, sixPresetsAreSeenWhole) {
  auto* list = window->findChild<QTreeView*>(QStringLiteral("presetList"));
  ASSERT_TRUE(list);
  int whole = 0;
  for (QModelIndex index = list->model()->index(0, 0); index.isValid(); index = list->indexBelow(index))
    whole += !index.data(presetRole::isGroup).toBool() &&
             list->viewport()->rect().contains(list->visualRect(index));
  EXPECT_GE(whole, 6);
}

TEST_F(Density, theWholeNoteOfThePresetUnderThePointerStandsInTheStatusBar) {
  auto* list = window->findChild<QTreeView*>(QStringLiteral("presetList"));
  const QModelIndex first = list->indexBelow(list->model()->index(0, 0));
  const auto moveTo = [list](const QPointF& at) { // whatever was pressed in a test before
    QMouseEvent move(QEvent::MouseMove, at, list->viewport()->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     {});
    QApplication::sendEvent(list->viewport(), &move);
  };
  moveTo(list->visualRect(first.parent()).center()); // the title of the group
  EXPECT_EQ(window->statusBar()->currentMessage(), QString());
  moveTo(list->visualRect(first).center());
  const QString note = first.data(presetRole::note).toString();
  EXPECT_GT(note.size(), 40) << "more than the list has room for";
  EXPECT_EQ(window->statusBar()->currentMessage(), note);
  moveTo(list->visualRect(first.parent()).center());
  EXPECT_EQ(window->statusBar()->currentMessage(), QString());
}

TEST_F(Density, thePanelsBesideThePictureGrowUnderTheMouse) {
  QWindow* handle = window->windowHandle();
  const auto drag = [&](const QPoint& edge, int by) {
    QTest::mousePress(handle, Qt::LeftButton, {}, edge);
    for (int step = 1; step <= 4; ++step)
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, edge + QPoint(by * step / 4, 0));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, edge + QPoint(by, 0));
    QCoreApplication::processEvents();
  };
  for (const auto& [name, way] : {std::pair("presetDock", 1), std::pair("shadingDock", -1)}) {
    const int before = dock(name).width();
    const QRect place = dock(name).geometry();
    drag({way > 0 ? place.right() + 2 : place.left() - 2, place.center().y()}, 80 * way);
    EXPECT_EQ(dock(name).width(), before + 80) << name;
  }
}

TEST_F(Density, aPropertyWithOneNumberTakesOneLine) {
  const auto sliders = window->findChild<LightSection*>()->findChildren<ValueSlider*>();
  ASSERT_EQ(sliders.size(), 7);
  for (const ValueSlider* slider : sliders)
    EXPECT_LE(slider->height(), 28) << "as high as the field in it";
}

TEST_F(Density, noHeadingIsSaidTwice) {
  for (const char* name : {"shadingDock", "effectsDock", "accuracyDock"}) {
    dock(name).raise();
    QCoreApplication::processEvents();
    EXPECT_EQ(headings(dock(name).windowTitle()), 1) << name;
  }
  EXPECT_EQ(headings(dock("presetDock").windowTitle()), 1) << "its tab";
  EXPECT_EQ(headings(dock("curveDock").windowTitle()), 0) << "its axes say what it is";
}

TEST_F(Density, theTabsAtTheRightHaveRoomForTheirWords) {
  for (const char* name : {"effectsDock", "accuracyDock", "shadingDock"}) {
    dock(name).raise();
    QCoreApplication::processEvents();
    for (const QTabBar* tabs : window->findChildren<QTabBar*>())
      for (int i = 0; !tabs->visibleRegion().isEmpty() && i < tabs->count(); ++i)
        EXPECT_GE(tabs->tabRect(i).width(), tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)))
            << tabs->tabText(i).toStdString() << " while " << name << " lies on top";
  }
}

TEST_F(Density, aTabAtTheRightLeavesThePictureAsItIs) {
  const QRect before = static_cast<QWidget&>(view()).geometry();
  for (const char* name : {"effectsDock", "accuracyDock", "shadingDock"}) {
    dock(name).raise();
    ASSERT_TRUE(test::waitUntil([&] { return dock(name).widget()->isVisible(); }));
    for (FoldingSection* section : dock(name).findChildren<FoldingSection*>())
      section->setFolded(!section->isFolded());
    QCoreApplication::processEvents();
    EXPECT_EQ(static_cast<QWidget&>(view()).geometry(), before) << name;
    auto* panel = dock(name).findChild<SectionPanel*>();
    EXPECT_GE(panel->viewport()->width(), panel->widget()->minimumSizeHint().width())
        << "nothing of " << name << " is cut off";
  }
}

TEST_F(Density, aPanelWithoutTabsHasItsTitle) {
  dock("effectsDock").hide();
  dock("accuracyDock").hide();
  ASSERT_TRUE(test::waitUntil([&] { return dock("shadingDock").titleBarWidget() == nullptr; }));
  // The tabs go when the docks are next laid out.
  EXPECT_TRUE(test::waitUntil([&] { return headings(QStringLiteral("Properties")) == 1; }));
  dock("accuracyDock").show();
  ASSERT_TRUE(test::waitUntil([&] { return dock("shadingDock").titleBarWidget() != nullptr; }));
  EXPECT_EQ(headings(QStringLiteral("Accuracy")), 1);
}

TEST_F(Density, aFloatingPanelHasItsTitle) {
  for (const char* name : {"curveDock", "effectsDock"}) {
    dock(name).setFloating(true);
    EXPECT_TRUE(test::waitUntil([&] { return dock(name).titleBarWidget() == nullptr; })) << name;
    dock(name).setFloating(false);
    EXPECT_TRUE(test::waitUntil([&] { return dock(name).titleBarWidget() != nullptr; })) << name;
  }
}

} // namespace
} // namespace limn
