// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/DialogKeys.h"
#include "app/core/sources/SceneSource.h"
#include "app/files/saving/SavedPicture.h"
#include "widgets/controls/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

TEST_F(SavedPicture, isAsLargeAsAskedFor) {
  lookFromAfar();
  PictureOptions options{.marks = noMarks};
  const QImage shown = saved("shown.png", options);
  EXPECT_EQ(shown.size(), view().size() * view().devicePixelRatioF());
  options.size = PictureOptions::Size::twice;
  EXPECT_EQ(saved("twice.png", options).size(), 2 * shown.size());
  const double onScreen = view().logicalDpiX() * view().devicePixelRatioF();
  EXPECT_NEAR(saved("twice.png", options).dotsPerMeterX(), 2.0 * onScreen / 0.0254, 1.0)
      << "on paper it is as large as on screen";
  options.size = PictureOptions::Size::print;
  options.printCm = 12.7; // 5 inches of 300 dots
  const QImage print = saved("print.png", options);
  EXPECT_EQ(print.width(), 1500);
  EXPECT_NEAR(print.dotsPerMeterX(), 300.0 / 0.0254, 1.0);
  EXPECT_FALSE(readImageDescription(folder.path() / "print.png").empty()) << "it carries its scene";
}

// Before chance has judged it the estimate, as an estimate.
TEST_F(SavedPicture, statesTheAccuracyThatTheWindowTells) {
  ASSERT_TRUE(test::waitUntil([this] {
    const PictureState state = view().pictureState();
    return state.resting && levelsOf(state.sides.front()).has_value();
  }));
  saved("shown.png", {.marks = noMarks});
  const auto told = accuracyIn(readImageDescription(folder.path() / "shown.png"), "shown.png");
  ASSERT_TRUE(told && told->levels);
  EXPECT_GT(*told->levels, 0.0);
  EXPECT_TRUE(told->sentence.starts_with("99.9 % of the pixels ")) << told->sentence;
}

TEST_F(SavedPicture, hasTheGroundThatIsAskedFor) {
  PictureOptions options{.marks = noMarks};
  options.ground = PictureOptions::Ground::transparent;
  const QImage clear = saved("clear.png", options);
  ASSERT_TRUE(clear.hasAlphaChannel());
  EXPECT_EQ(qAlpha(clear.pixel(0, 0)), 0);
  EXPECT_GT(qAlpha(clear.pixel(clear.rect().center())), 200);
  options.ground = PictureOptions::Ground::white;
  EXPECT_EQ(saved("white.png", options).pixelColor(0, 0), QColor(Qt::white));
}

TEST_F(SavedPicture, saysWhereItsFormatKnowsNoTransparentGround) {
  lookFromAfar();
  PictureOptions options{.marks = noMarks};
  options.ground = PictureOptions::Ground::transparent;
  messages().hide();
  saved("clear.png", options);
  EXPECT_FALSE(messages().isVisible());
  for (const PictureOptions::Size size : {PictureOptions::Size::screen, PictureOptions::Size::twice}) {
    options.size = size;
    saved("ground.jpg", options);
    EXPECT_TRUE(messages().isVisible());
    EXPECT_TRUE(messages().sentence().startsWith(QStringLiteral("ground.jpg has the ground of the screen")))
        << messages().sentence().toStdString();
    messages().hide();
  }
}

TEST_F(SavedPicture, takesTheMarksAlongThatAreAskedFor) {
  PictureOptions options{.marks = noMarks};
  const QImage bare = saved("bare.png", options);
  options.marks.warning = true;
  const QImage warned = saved("warned.png", options);
  ASSERT_EQ(bare.size(), warned.size());
  QRect changed;
  for (int y = 0; y < bare.height(); ++y)
    for (int x = 0; x < bare.width(); ++x)
      if (bare.pixel(x, y) != warned.pixel(x, y))
        changed |= QRect(x, y, 1, 1);
  // "Not for diagnosis" stands in the lower right corner, and nothing else comes with it.
  EXPECT_GT(changed.left(), bare.width() / 2);
  EXPECT_GT(changed.top(), bare.height() * 3 / 4);
  options.marks = SavedMarks{};
  EXPECT_NE(saved("all.png", options), warned);
}

TEST_F(SavedPicture, isNoSmallerBecauseAMessageStandsOpen) {
  PictureOptions options{.marks = noMarks};
  const QSize size = saved("before.png", options).size();
  ASSERT_TRUE(open(pathTo("missing.nii")));
  ASSERT_TRUE(messages().isVisible());
  ASSERT_TRUE(rest());
  EXPECT_EQ(saved("after.png", options).size(), size);
}

TEST_F(SavedPicture, isOpenedAgainAsOneOrTwoAsItWasSaved) {
  lookFromAfar();
  const PictureOptions options{.marks = noMarks};
  ASSERT_FALSE(saved("one.png", options).isNull());
  setLayout(CompareLayout::wipe);
  window->findChild<QAction*>(QStringLiteral("model-right-robust"))->trigger();
  view().setWipePosition(0.25);
  ASSERT_TRUE(rest());
  ASSERT_FALSE(saved("two.png", options).isNull());
  setLayout(CompareLayout::sideBySide);
  window->findChild<QAction*>(QStringLiteral("model-right-none"))->trigger();
  ASSERT_TRUE(open(pathTo("one.png")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::single);
  ASSERT_TRUE(open(pathTo("two.png")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe);
  EXPECT_EQ(view().wipePosition(), 0.25);
  EXPECT_EQ(view().sceneOfSide(0).shading.model, ShadingModel::classic);
  EXPECT_EQ(view().sceneOfSide(1).shading.model, ShadingModel::robust);
}

TEST_F(SavedPicture, bringsALayoutThatGoesWithIt) {
  lookFromAfar();
  setLayout(CompareLayout::wipe);
  ASSERT_TRUE(rest());
  ASSERT_FALSE(saved("two.png", {.marks = noMarks}).isNull());
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(open(pathTo("two.png")));
  ASSERT_TRUE(open(pathTo("two.png")));
  ASSERT_EQ(view().compareLayout(), CompareLayout::wipe);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide) << "as it was before";
  ASSERT_TRUE(open(pathTo("two.png")));
  setLayout(CompareLayout::difference);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::difference) << "chosen meanwhile";
}

// What is cancelled leaves no file, and nothing that stands in the way of the next one.
TEST_F(SavedPicture, isCancelledWhileItIsDrawnAndTheNextOneIsAskedFor) {
  PictureOptions options;
  options.size = PictureOptions::Size::print;
  options.printCm = 40.0; // 4,724 pixels
  saving().writePicture(pathTo("large.png"), options);
  ASSERT_TRUE(stopButton().isVisible());
  QTest::mouseClick(&stopButton(), Qt::LeftButton);
  EXPECT_FALSE(stopButton().isVisible());
  EXPECT_EQ(window->statusBar()->currentMessage(), QStringLiteral("Cancelled; nothing was saved."));
  bool isAsked = false;
  onceAsked<PictureDialog>([&isAsked](PictureDialog& dialog) {
    isAsked = true;
    dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  EXPECT_TRUE(isAsked);
  EXPECT_FALSE(fs::exists(folder.path() / "large.png"));
}

// Each would slow the other down.
TEST_F(SavedPicture, whileItIsDrawnTheOneOnScreenStaysAsItIs) {
  view().setRefinesAtRest(true);
  PictureOptions options;
  options.size = PictureOptions::Size::print;
  options.printCm = 40.0; // 4,724 pixels
  saving().writePicture(pathTo("large.png"), options);
  ASSERT_TRUE(stopButton().isVisible());
  EXPECT_FALSE(view().order().refines);
  view().setRefinesAtRest(false);
  view().setRefinesAtRest(true);
  EXPECT_FALSE(view().order().refines) << "whoever else allows it";
  const Camera before = scene().camera;
  session().setCamera(zoomed(before, 0.5));
  EXPECT_TRUE(rest()) << "what is asked for is drawn";
  QTest::mouseClick(&stopButton(), Qt::LeftButton);
  EXPECT_TRUE(view().order().refines);
  options.size = PictureOptions::Size::screen;
  ASSERT_FALSE(saved("small.png", options).isNull());
  EXPECT_TRUE(view().order().refines);
}

// What is told rises once, however often it is: that each side has its half of the way stands in
// PictureProgress.
TEST_F(SavedPicture, ofTwoTellsHowFarItIsAsOne) {
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  std::vector<int> percents;
  QObject::connect(&saving(), &SavingController::drawing, window.get(), [&](const QString& sentence) {
    const QRegularExpressionMatch match = QRegularExpression(QStringLiteral(": (\\d+) %")).match(sentence);
    if (match.hasMatch())
      percents.push_back(match.captured(1).toInt());
  });
  PictureOptions options{.marks = noMarks};
  options.size = PictureOptions::Size::print;
  options.printCm = 20.0; // 2,362 pixels: seconds, of which is told many times
  ASSERT_FALSE(saved("two.png", options).isNull());
  EXPECT_FALSE(percents.empty()) << "the first that is known is told at once";
  EXPECT_TRUE(std::ranges::is_sorted(percents));
}

TEST_F(SavedPicture, isNotLostByQuittingUnasked) {
  PictureOptions options;
  options.size = PictureOptions::Size::print;
  options.printCm = 40.0; // 4,724 pixels
  saving().writePicture(pathTo("large.png"), options);
  ASSERT_TRUE(stopButton().isVisible());
  int asked = 0;
  const auto answer = [&](QMessageBox::ButtonRole role) {
    onceAsked<QMessageBox>([&asked, role](QMessageBox& box) {
      ++asked;
      EXPECT_TRUE(box.informativeText().contains(QStringLiteral("large.png")));
      for (QAbstractButton* button : box.buttons())
        if (box.buttonRole(button) == role)
          return QTest::mouseClick(button, Qt::LeftButton);
    });
  };
  answer(QMessageBox::RejectRole);
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(stopButton().isVisible()) << "it goes on";
  answer(QMessageBox::DestructiveRole);
  EXPECT_TRUE(window->close());
  EXPECT_EQ(asked, 2);
  window->show();
  QTest::mouseClick(&stopButton(), Qt::LeftButton);
  EXPECT_TRUE(window->close()) << "there is nothing to lose any more";
}

TEST_F(SavedPicture, theTimeToDrawIsToldAsSoonAsItIsKnown) {
  std::optional<double> known;
  DrawingTold told;
  told.seconds = [&known](const QSize&) { return known; };
  PictureDialog dialog({}, {640, 480}, window.get(), PictureKind::view, told);
  const auto& pixels = *dialog.findChild<QLabel*>(QStringLiteral("picturePixels"));
  EXPECT_EQ(pixels.text(), QStringLiteral("640 × 480 pixels, the time to draw is being estimated"));
  known = 180.0;
  EXPECT_TRUE(test::waitUntil([&] {
    return pixels.text() == QStringLiteral("640 × 480 pixels, about 3 min to draw");
  })) << pixels.text().toStdString();
}

// Two pictures touch in the file: the line between them on screen is in no promise.
TEST_F(SavedPicture, ofTwoIsAsLargeAsTheDialogSays) {
  lookFromAfar();
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  QString promised;
  onceAsked<PictureDialog>([&promised](PictureDialog& dialog) {
    dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"))->setCurrentIndex(1);
    promised = dialog.findChild<QLabel*>(QStringLiteral("picturePixels"))->text();
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("pictureSave")), Qt::LeftButton);
  });
  typeName(pathTo("two.png"));
  action(QStringLiteral("Save &picture…"))->trigger();
  const QSize size = written("two.png").size();
  EXPECT_EQ(promised, QStringLiteral("%1 × %2 pixels").arg(size.width()).arg(size.height()));
}

// Two pictures beside each other share an odd width, of which each has whole pixels.
TEST_F(SavedPicture, isAsWideInPixelsAsAskedForAndKeepsItsShape) {
  lookFromAfar();
  const QSize shown = view().size() * view().devicePixelRatioF();
  const auto save = [this](const char* name, const QString& width) {
    QString promised;
    onceAsked<PictureDialog>([&](PictureDialog& dialog) {
      auto* size = dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"));
      size->setCurrentIndex(size->findText(QStringLiteral("Size in pixels")));
      auto* field = dialog.findChild<NumberField*>(QStringLiteral("pictureWidthPixels"));
      EXPECT_TRUE(field->isVisible());
      EXPECT_FALSE(dialog.findChild<NumberField*>(QStringLiteral("pictureWidth"))->isVisible());
      field->selectAll();
      QTest::keyClicks(field, width);
      field->commit();
      promised = dialog.findChild<QLabel*>(QStringLiteral("picturePixels"))->text();
      QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("pictureSave")), Qt::LeftButton);
    });
    typeName(pathTo(name));
    action(QStringLiteral("Save &picture…"))->trigger();
    const QSize size = written(name).size();
    EXPECT_EQ(promised, QStringLiteral("%1 × %2 pixels").arg(size.width()).arg(size.height()));
    return size;
  };
  const QSize one = save("one.png", QStringLiteral("701"));
  EXPECT_EQ(one.width(), 701);
  EXPECT_NEAR(one.height(), 701.0 * shown.height() / shown.width(), 0.5) << "a whole number of pixels";
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  EXPECT_NEAR(save("two.png", QStringLiteral("701")).width(), 701, 1) << "two of one width";
}

TEST_F(SavedPicture, hasAShapeOfItsOwnOnceThatIsUnlocked) {
  PictureDialog dialog({.size = PictureOptions::Size::pixels, .marks = {}}, {640, 480}, window.get());
  dialog.show();
  const auto& lock = *dialog.findChild<QToolButton*>(QStringLiteral("pictureShape"));
  const auto& pixels = *dialog.findChild<QLabel*>(QStringLiteral("picturePixels"));
  const auto& height = *dialog.findChild<NumberField*>(QStringLiteral("pictureHeightPixels"));
  EXPECT_TRUE(lock.isChecked()) << "at first";
  EXPECT_FALSE(height.isEnabled()) << "it follows";
  EXPECT_EQ(height.number(), 1440.0) << "from 1920 pixels";
  EXPECT_TRUE(height.toolTip().contains(QStringLiteral("16384"))) << height.toolTip().toStdString();
  askForPixels(dialog, "512", "300");
  EXPECT_TRUE(height.isEnabled());
  EXPECT_EQ(pixels.text(), QStringLiteral("512 × 300 pixels"));
  EXPECT_EQ(sizeInFile(dialog.options(), {640, 480}), QSize(512, 300));
  EXPECT_EQ(sizeInFile(dialog.options(), {640, 480}, 2), QSize(512, 300));
  askForPixels(dialog, "511", "8");
  EXPECT_FALSE(height.refusal().isEmpty()) << "none that low is drawn";
  EXPECT_EQ(pixels.text(), QStringLiteral("511 × 300 pixels"));
  EXPECT_EQ(sizeInFile(dialog.options(), {640, 480}, 2), QSize(512, 300)) << "whole pixels of each";
  QTest::mouseClick(const_cast<QToolButton*>(&lock), Qt::LeftButton);
  EXPECT_EQ(pixels.text(), QStringLiteral("511 × 383 pixels"));
  EXPECT_EQ(height.number(), 383.0);
}

// About the same middle, as high as on screen: what the command line draws of the scene in that size.
TEST_F(SavedPicture, ofAnotherShapeIsWhatTheCommandLineDrawsInItsSize) {
  const Camera camera = scene().camera;
  onceAsked<PictureDialog>([](PictureDialog& dialog) {
    askForPixels(dialog, "512", "512");
    EXPECT_TRUE(dialog.findChild<QCheckBox*>(QStringLiteral("pictureNames"))
                    ->text()
                    .startsWith(QStringLiteral("Model")))
        << "not those of patients";
    for (const char* mark : {"pictureNames", "pictureLetters", "pictureScale", "pictureWarning"})
      dialog.findChild<QCheckBox*>(QLatin1String(mark))->setChecked(false);
    dialog.findChild<QCheckBox*>(QStringLiteral("pictureMeasurements"))->setChecked(false);
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("pictureSave")), Qt::LeftButton);
  });
  typeName(pathTo("square.png"));
  action(QStringLiteral("Save &picture…"))->trigger();
  const QImage square = written("square.png");
  ASSERT_EQ(square.size(), QSize(512, 512));
  const Scene inside = loadScene((folder.path() / "square.png").string(), {}, {}).scene;
  EXPECT_EQ(inside.camera, camera) << "a scene that says its camera keeps it";
  EXPECT_EQ(drawn(inside, {512, 512}), square);
  bool isKept = false;
  onceAsked<PictureDialog>([&isKept](PictureDialog& dialog) {
    isKept = sizeInFile(dialog.options(), {640, 480}) == QSize(512, 512);
    dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  EXPECT_TRUE(isKept) << "with the other answers";
}

TEST_F(SavedPicture, ofTwoInAnotherShapeHasHalfOfItForEach) {
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  const QImage both = saved("both.png", {.size = PictureOptions::Size::pixels,
                                         .widthPixels = 600,
                                         .heightPixels = 200,
                                         .keepsShape = false,
                                         .marks = noMarks});
  ASSERT_EQ(both.size(), QSize(600, 200));
  for (const int side : {0, 1})
    EXPECT_EQ(drawn(view().sceneOfRestingImage(side), {300, 200}), both.copy(300 * side, 0, 300, 200))
        << side;
}

TEST_F(SavedPicture, ofAnotherShapeHasItsMarksAtItsOwnEdges) {
  PictureOptions options{.size = PictureOptions::Size::pixels,
                         .widthPixels = 400,
                         .heightPixels = 400,
                         .keepsShape = false,
                         .marks = noMarks};
  const QImage bare = saved("bare.png", options);
  options.marks.warning = true;
  const QImage warned = saved("warned.png", options);
  ASSERT_EQ(warned.size(), QSize(400, 400));
  QRect changed;
  for (int y = 0; y < bare.height(); ++y)
    for (int x = 0; x < bare.width(); ++x)
      if (bare.pixel(x, y) != warned.pixel(x, y))
        changed |= QRect(x, y, 1, 1);
  ASSERT_FALSE(changed.isEmpty());
  EXPECT_GT(changed.left(), 100);
  EXPECT_GT(changed.right(), 350);
  EXPECT_LT(changed.right(), 399) << "none of it is cut off";
  EXPECT_GT(changed.top(), 300);
}

TEST_F(SavedPicture, saysWhereItsSlicesAreNotInTheFile) {
  const auto remark = [this] {
    QString said;
    onceAsked<PictureDialog>([&said](PictureDialog& dialog) {
      const auto* label = dialog.findChild<QLabel*>(QStringLiteral("pictureRemark"));
      said = label ? label->text() : QString();
      dialog.reject();
    });
    action(QStringLiteral("Save &picture…"))->trigger();
    return said;
  };
  EXPECT_EQ(remark(), QString());
  PlaneSettings settings = session().planes();
  settings.layout = PlaneLayout::pictureAndThree;
  session().setPlanes(settings);
  EXPECT_TRUE(remark().startsWith(QStringLiteral("The 3D picture is saved without the slices")));
}

// Alt and a letter does one thing in each dialog.
TEST_F(SavedPicture, noTwoThingsOfADialogHaveOneKey) {
  onceAsked<PictureDialog>([&](PictureDialog& dialog) {
    const auto* save = dialog.findChild<QPushButton*>(QStringLiteral("pictureSave"));
    EXPECT_EQ(QKeySequence::mnemonic(save->text()), QKeySequence(Qt::ALT | Qt::Key_S));
    expectOneKeyEachOfSizes(dialog);
    dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  expectOneKeyEachOfExports(*window);
}

TEST_F(SavedPicture, theDialogIsAsHighAsItsRows) {
  int plain = 0, print = 0, again = 0;
  onceAsked<PictureDialog>([&](PictureDialog& dialog) {
    auto* size = dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"));
    const auto heightAt = [&](int index) {
      size->setCurrentIndex(index);
      QCoreApplication::processEvents();
      return dialog.height();
    };
    plain = heightAt(0);
    print = heightAt(3);
    again = heightAt(0);
    dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  ASSERT_GT(plain, 0);
  EXPECT_GT(print, plain) << "a row for the width on paper";
  EXPECT_EQ(again, plain) << "no gap stays above the buttons";
}

TEST_F(SavedPicture, theAnswersAreRemembered) {
  lookFromAfar();
  const auto answer = [this] {
    onceAsked<PictureDialog>([](PictureDialog& dialog) {
      dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"))->setCurrentIndex(1);
      dialog.findChild<QComboBox*>(QStringLiteral("pictureGround"))->setCurrentIndex(2);
      QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("pictureSave")), Qt::LeftButton);
    });
  };
  answer();
  typeName(pathTo("asked.png"));
  action(QStringLiteral("Save &picture…"))->trigger();
  EXPECT_EQ(written("asked.png").size(), 2 * view().size() * view().devicePixelRatioF());
  bool isAsked = false;
  onceAsked<PictureDialog>([&isAsked](PictureDialog& dialog) {
    isAsked = dialog.options().size == PictureOptions::Size::twice &&
              dialog.options().ground == PictureOptions::Ground::black;
    dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  EXPECT_TRUE(isAsked);
}

TEST(WrittenOptions, comeBackAsTheyWere) {
  PictureOptions options;
  options.size = PictureOptions::Size::print;
  options.printCm = 8.5;
  options.ground = PictureOptions::Ground::transparent;
  options.marks.scale = false;
  EXPECT_EQ(readOptions(writtenOptions(options)), options);
  options.size = PictureOptions::Size::pixels;
  options.widthPixels = 1234;
  EXPECT_EQ(readOptions(writtenOptions(options)), options);
  options.widthPixels = PictureOptions{}.widthPixels;
  for (const int words : {-2, -3, -4}) { // as they were written before there were shape, height, width
    const QString before = writtenOptions(options).section(QLatin1Char(' '), 0, words);
    EXPECT_EQ(readOptions(before), options) << before.toStdString();
  }
  options.heightPixels = 512;
  options.keepsShape = false;
  EXPECT_EQ(readOptions(writtenOptions(options)), options);
  EXPECT_EQ(readOptions(QStringLiteral("what is this")), PictureOptions{});
}

} // namespace
} // namespace limn::test
