// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QTimer>

#include <fstream>

// Where the shading models of the pictures are chosen, in the program's window.

namespace limn {
namespace {

class ModelWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  }

  QToolButton* button(int side) const {
    return window->findChild<QToolButton*>(side == 0 ? QStringLiteral("modelButton")
                                                     : QStringLiteral("rightModelButton"));
  }

  // Clicks the button of a side and chooses the entry of this place, from 1 on, by the keyboard.
  void choose(int side, int entry) {
    QTimer::singleShot(0, window.get(), [entry] {
      QWidget* menu = QApplication::activePopupWidget();
      ASSERT_NE(menu, nullptr);
      for (int key = 0; key < entry; ++key)
        QTest::keyClick(menu, Qt::Key_Down);
      QTest::keyClick(menu, Qt::Key_Return);
    });
    QTest::mouseClick(button(side), Qt::LeftButton);
    QCoreApplication::processEvents();
  }

  std::vector<ShadingModel> shown() {
    std::vector<ShadingModel> models;
    for (const Scene& one : view().scenesOfSides())
      models.push_back(one.shading.model);
    return models;
  }

  using Models = std::vector<ShadingModel>;
};

TEST_F(ModelWindow, aComparisonHasAButtonForEachSideThatChangesItAndEndsNothing) {
  ASSERT_TRUE(button(0)->isVisible() && button(1)->isVisible());
  EXPECT_EQ(button(0)->text(), QStringLiteral("Left: Classic"));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Enhanced"));
  choose(1, 4);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::robust}));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Robust"));
  EXPECT_TRUE(button(1)->menu()->actions()[3]->isChecked());
  setLayout(CompareLayout::wipe);
  choose(0, 1);
  EXPECT_EQ(shown(), (Models{ShadingModel::none, ShadingModel::robust}));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe);
  EXPECT_TRUE(rest());
  ASSERT_EQ(undo().count(), 2);
  EXPECT_EQ(undo().undoText(), QStringLiteral("Left: Unlit"));
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::robust}));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe) << "which is no part of the step";
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  undo().redo();
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Robust"));
}

TEST_F(ModelWindow, physicalLightChosenForASideIsAStepThatIsTakenBack) {
  choose(1, 5);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::physical}));
  EXPECT_EQ(undo().undoText(), QStringLiteral("Right: Physical"));
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Enhanced"));
}

// The driver cannot: the processor draws, coarsely at once, then as many paths again and again.
TEST_F(ModelWindow, physicalLightIsDrawnByTheProcessorWithMorePathsWhileNothingMoves) {
  setLayout(CompareLayout::single);
  ASSERT_TRUE(rest());
  view().setRefinesAtRest(true);
  choose(0, 5);
  EXPECT_EQ(shown(), Models{ShadingModel::physical});
  EXPECT_EQ(button(0)->text(), QStringLiteral("Physical"));
  const auto paths = [this] {
    const PictureState& state = view().pictureState();
    const bool isShown = state.resting && !state.sides.empty() && state.sides[0].paths.has_value();
    return isShown ? state.sides[0].paths->paths : 0;
  };
  ASSERT_TRUE(test::waitUntil([&] { return paths() >= 8; }));
  EXPECT_EQ(view().pictureState().engine, Engine::cpu);
  // The error is found over what was followed, beside the event loop.
  const auto status = [this] { return window->findChild<PictureStatus*>()->text().line(); };
  EXPECT_TRUE(test::waitUntil([&] { return status().contains(QStringLiteral("levels RMS after")); }))
      << status().toStdString();
  // A gesture ends what is followed, and another picture begins.
  const Scene before = scene();
  dragAPoint();
  ASSERT_NE(scene(), before);
  EXPECT_EQ(paths(), 0) << "nothing rests";
  ASSERT_TRUE(test::waitUntil([&] { return paths() > 0; }));
  choose(0, 2);
  EXPECT_EQ(shown(), Models{ShadingModel::classic});
  EXPECT_TRUE(rest());
}

TEST_F(ModelWindow, anImageIsShownAloneAndTheNextVolumeIsComparedAgain) {
  const QString image = pathTo("image.nrrd");
  std::ofstream(image.toStdString()) << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 2 1\n"
                                        "spacings: 1 1 1\nencoding: ascii\n\n0 50 100 150 200 250\n";
  ASSERT_TRUE(open(image));
  EXPECT_EQ(view().compareLayout(), CompareLayout::single);
  EXPECT_EQ(shown(), Models{ShadingModel::none});
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  ASSERT_TRUE(open(image));
  setLayout(CompareLayout::wipe);
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe) << "chosen meanwhile";
}

TEST_F(ModelWindow, aSinglePictureHasOneButton) {
  setLayout(CompareLayout::single);
  EXPECT_TRUE(test::waitUntil([this] { return !button(1)->isVisible(); })); // once the tool bar is laid out
  EXPECT_EQ(button(0)->text(), QStringLiteral("Classic"));
  choose(0, 3);
  EXPECT_EQ(shown(), Models{ShadingModel::enhanced});
  EXPECT_EQ(button(0)->text(), QStringLiteral("Enhanced"));
  EXPECT_EQ(undo().count(), 1);
  undo().undo();
  EXPECT_EQ(button(0)->text(), QStringLiteral("Classic"));
}

TEST_F(ModelWindow, thePropertiesChangeTheSideInQuestion) {
  auto& properties = *window->findChild<PropertiesPanel*>();
  auto* right = rowNamed<ChoiceRow>(properties, "Model, right");
  ASSERT_TRUE(right->isVisible() && right->isEnabled());
  right->box()->setFocus();
  QTest::keyClick(right->box(), Qt::Key_Down);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::robust}));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Robust"));
  setLayout(CompareLayout::single);
  EXPECT_FALSE(right->isVisible());
  EXPECT_TRUE(rowNamed<ChoiceRow>(properties, "Model")->isVisible());
}

} // namespace
} // namespace limn
