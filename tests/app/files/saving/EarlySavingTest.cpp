// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/drawing/PictureMaker.h"
#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"

#include <QCheckBox>
#include <QColorSpace>
#include <QImage>
#include <QPushButton>

// A picture that is asked for while it is still refined: its file holds the one that stays on screen, and
// what is known of that one's error.

namespace limn {
namespace {

class EarlySaving : public test::WindowHarness {
protected:
  explicit EarlySaving(Engine engine = Engine::rayCaster) : WindowHarness(engine) {}

  void SetUp() override {
    WindowHarness::SetUp();
    setLayout(CompareLayout::single);
    view().setRefinesAtRest(true); // as people have it
  }

  QToolButton& stop() const { return *window->findChild<QToolButton*>(QStringLiteral("stopWaiting")); }

  // By keys and clicks, without marks.
  void ask() {
    onceAsked<PictureDialog>([](PictureDialog& dialog) {
      for (QCheckBox* mark : dialog.findChildren<QCheckBox*>())
        if (mark->isChecked())
          QTest::mouseClick(mark, Qt::LeftButton, {}, {8, mark->height() / 2});
      EXPECT_EQ(dialog.options().size, PictureOptions::Size::screen);
      EXPECT_FALSE(dialog.options().marks.any());
      QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("pictureSave")), Qt::LeftButton);
    });
    typeName(pathTo("early.png"));
    QTest::keyClick(window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  }

  void expectTheFinishedPicture() {
    ASSERT_TRUE(open(QStringLiteral("phantom:4")));
    ASSERT_FALSE(view().pictureState().resting);
    ask();
    ASSERT_TRUE(test::waitUntil([this] { return isWholePicture(folder.path() / "early.png"); }));
    const PictureState state = view().pictureState();
    EXPECT_TRUE(state.isFinal);
    EXPECT_FALSE(state.refines);
    EXPECT_FALSE(stop().isVisible());
    const QImage shown = view().currentPicture(0).convertToFormat(QImage::Format_RGB32);
    QImage saved(pathTo("early.png"));
    saved.setColorSpace({}); // which the screen's does not tell
    EXPECT_EQ(saved.convertToFormat(QImage::Format_RGB32), shown);
    const std::string text = readImageDescription(folder.path() / "early.png");
    EXPECT_EQ(parseScene(text, "early.png").scene.quality, view().sceneOfRestingImage(0).quality);
    const std::optional<PictureAccuracy> told = accuracyIn(text, "early.png");
    ASSERT_TRUE(told && told->levels && state.sides[0].chance);
    EXPECT_NEAR(*told->levels, state.sides[0].chance->levels, 1e-6);
  }
};

class EarlySavingOnProcessor : public EarlySaving {
protected:
  EarlySavingOnProcessor() : EarlySaving(Engine::cpu) {}
};

TEST_F(EarlySaving, waitsForThePictureThatStays) {
  expectTheFinishedPicture();
}

TEST_F(EarlySavingOnProcessor, waitsForThePictureThatStays) {
  expectTheFinishedPicture();
}

// What the screen does not refine is complete at once; whoever gives refining up meanwhile does not wait on.
TEST_F(EarlySavingOnProcessor, waitsForNothingThatDoesNotCome) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  ask();
  if (view().pictureState().isFinal)
    GTEST_SKIP() << "the picture was final before its name was typed";
  ASSERT_TRUE(rest());
  EXPECT_TRUE(stop().isVisible() || view().pictureState().isFinal);
  window->findChild<QAction*>(QStringLiteral("refineAtRest"))->setChecked(false);
  EXPECT_TRUE(test::waitUntil([this] { return isWholePicture(folder.path() / "early.png"); }));
}

// Seconds may pass: the row tells for what it is waited, and how far that is.
TEST_F(EarlySavingOnProcessor, tellsHowFarItIsAndIsCancelled) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  ask();
  const auto saysRefined = [this] {
    return labelSays(QStringLiteral("Saving early.png once the picture is refined"));
  };
  ASSERT_TRUE(test::waitUntil([&] { return saysRefined() || view().pictureState().isFinal; }));
  if (view().pictureState().isFinal)
    GTEST_SKIP() << "the picture was final at once";
  QTest::mouseClick(&stop(), Qt::LeftButton);
  EXPECT_FALSE(saysRefined());
  ASSERT_TRUE(test::waitUntil([this] { return view().pictureState().isFinal; }));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "early.png"));
}

} // namespace
} // namespace limn
