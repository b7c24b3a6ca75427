// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/files/exports/SurfaceDialog.h"
#include "support/FileBytes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QMenuBar>
#include <QProgressBar>
#include <QPushButton>

// A surface, exported in the program's window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class SurfaceWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(open(QStringLiteral("phantom:6")));
    ASSERT_TRUE(rest());
  }

  // As a user does who has no mouse: Alt+F, X.
  void ask() {
    // A display without a window manager may give the keyboard to nobody when a dialog goes.
    ASSERT_TRUE(test::waitUntil([this] {
      if (!window->isActiveWindow())
        window->activateWindow();
      return window->isActiveWindow();
    }));
    QTest::keyClick(window.get(), Qt::Key_F, Qt::AltModifier);
    ASSERT_TRUE(test::waitUntil([] { return QApplication::activePopupWidget() != nullptr; }));
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_X);
    ASSERT_TRUE(test::waitUntil([this] {
      return window->findChild<SurfaceDialog*>() && dialog().isActiveWindow() && exportButton().isEnabled();
    }));
  }

  SurfaceDialog& dialog() const { return *window->findChild<SurfaceDialog*>(); }
  QPushButton& exportButton() const {
    return *dialog().findChild<QPushButton*>(QStringLiteral("surfaceExport"));
  }
  QString said() const { return dialog().findChild<QLabel*>(QStringLiteral("surfaceSays"))->text(); }

  double value() const {
    return dialog().findChild<QDoubleSpinBox*>(QStringLiteral("surfaceValue"))->value();
  }

  void type(const char* name, const QString& text) const {
    auto* field = dialog().findChild<QDoubleSpinBox*>(QLatin1String(name));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text + QStringLiteral("\t"));
  }

  void exportTo(const char* name) {
    typeName(pathTo(name));
    QTest::mouseClick(&exportButton(), Qt::LeftButton);
  }
};

TEST_F(SurfaceWindow, isToldBeforeAndMeasuredAfterwards) {
  ask();
  EXPECT_TRUE(said().startsWith(QStringLiteral("About "))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("(LPS)")));
  exportTo("skull.stl");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_TRUE(said().startsWith(QStringLiteral("Saved skull.stl: "))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("It is watertight"))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("mm from the isosurface"))) << said().toStdString();
  EXPECT_GT(fs::file_size(folder.path() / "skull.stl"), 10'000u);
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(SurfaceWindow, isWhatTheCommandLineMakes) {
  ask();
  type("surfaceValue", QStringLiteral("500"));
  type("surfaceSmallest", QStringLiteral("0"));
  type("surfaceTolerance", QStringLiteral("0"));
  ASSERT_TRUE(test::waitUntil([this] { return exportButton().isEnabled(); }));
  exportTo("window.ply");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  SurfaceOrder order;
  order.isovalue = 500.0;
  exportSurfaces(scene(), {order}, folder.path() / "command.ply");
  EXPECT_EQ(test::bytesOfFile(folder.path() / "window.ply"),
            test::bytesOfFile(folder.path() / "command.ply"));
}

TEST_F(SurfaceWindow, beginsWithWhatTheSceneShows) {
  ask();
  EXPECT_EQ(value(), 300.0);
  dialog().close();
  curves().valueEditor()->canvas()->setPinnedValue(420.0);
  ask();
  EXPECT_EQ(value(), 420.0);
  EXPECT_TRUE(labelSays(QStringLiteral("pinned on the curve")));
  dialog().close();
  Scene isosurface = scene();
  isosurface.projection = Projection::isosurface;
  isosurface.isovalue = -150.0;
  EXPECT_EQ(firstValue(isosurface, 420.0, std::nullopt), (FirstValue{-150.0, ValueOrigin::isosurface}));
  EXPECT_EQ(firstValue(scene(), std::nullopt, 1),
            (FirstValue{scene().transferFunction.points[1].value, ValueOrigin::point}));
}

TEST_F(SurfaceWindow, saysWhyThereIsNone) {
  ask();
  type("surfaceValue", QStringLiteral("90000"));
  ASSERT_TRUE(test::waitUntil([this] { return said().startsWith(QStringLiteral("There is no surface")); }));
  EXPECT_FALSE(exportButton().isEnabled());
  type("surfaceValue", QStringLiteral("300"));
  EXPECT_TRUE(test::waitUntil([this] { return exportButton().isEnabled(); }));
}

TEST_F(SurfaceWindow, isEstimatedAnewWhenTheCropChanges) {
  ask();
  const QString before = said();
  session().setCrop({{0.0, 0.0, 0.5}, {1.0, 1.0, 1.0}}, Gesture{});
  EXPECT_TRUE(test::waitUntil([&] { return exportButton().isEnabled() && said() != before; }));
}

TEST_F(SurfaceWindow, isNotMadeForAPlaceThatTakesNoFile) {
  ask();
  exportTo("none/skull.stl");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_TRUE(said().contains(QStringLiteral("there is no folder"))) << said().toStdString();
  EXPECT_EQ(dialog().findChild<QProgressBar*>()->value(), 0) << "nothing was worked at";
}

TEST_F(SurfaceWindow, isCancelledByEscAndLeavesNothing) {
  ask();
  type("surfaceTolerance", QStringLiteral("0.5"));
  auto* cells = dialog().findChild<QComboBox*>(QStringLiteral("surfaceCells"));
  cells->setFocus();
  QTest::keyClick(cells, Qt::Key_End);
  emit cells->activated(cells->currentIndex());
  ASSERT_TRUE(test::waitUntil([this] { return exportButton().isEnabled(); }));
  exportTo("skull.stl");
  ASSERT_TRUE(dialog().isWorking());
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isWorking());
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_TRUE(said().startsWith(QStringLiteral("Cancelled"))) << said().toStdString();
  ASSERT_TRUE(open(QStringLiteral("phantom:8"))); // after which the work before has ended for sure
  EXPECT_FALSE(dialog().isVisible()) << "it was about another volume";
  EXPECT_FALSE(fs::exists(folder.path() / "skull.stl"));
}

} // namespace
} // namespace limn
