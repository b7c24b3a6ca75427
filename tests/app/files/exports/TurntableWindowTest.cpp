// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/making/Turntable.h"
#include "app/core/sources/SceneSource.h"
#include "app/files/exports/TurntableDialog.h"
#include "scene/light/LightPresets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QRegularExpression>

// A turntable, saved in the program's window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class TurntableWindow : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    ASSERT_TRUE(open(QStringLiteral("phantom:8")));
    ASSERT_TRUE(rest());
    window->findChild<QAction*>(QStringLiteral("saveTurntable"))->trigger();
    ASSERT_TRUE(test::waitUntil([this] { return dialog().isActiveWindow(); }));
    type("turntableWidth", QStringLiteral("120"));
    type("turntableHeight", QStringLiteral("100"));
  }

  TurntableDialog& dialog() const { return *window->findChild<TurntableDialog*>(); }

  void type(const char* name, const QString& text) const {
    auto* field = dialog().findChild<QDoubleSpinBox*>(QLatin1String(name));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text + QStringLiteral("\t"));
  }

  void save(const char* name) {
    typeName(pathTo(name));
    QTest::mouseClick(dialog().findChild<QPushButton*>(QStringLiteral("turntableSave")), Qt::LeftButton);
  }

  QString said() const { return dialog().findChild<QLabel*>(QStringLiteral("turntableSays"))->text(); }
};

TEST_F(TurntableWindow, framesOfWhatIsOpenAreSaved) {
  type("turntableFrames", QStringLiteral("4"));
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_EQ(said(), QStringLiteral("Saved turn.frames."));
  for (const char* frame : {"frame-0001.png", "frame-0004.png"})
    EXPECT_TRUE(fs::exists(folder.path() / "turn.frames" / frame)) << frame;
  EXPECT_FALSE(fs::exists(folder.path() / "turn.frames" / "frame-0005.png"));
  EXPECT_EQ(undo().count(), 0);
}

// No title stands in its frames, which another side would hide.
TEST_F(TurntableWindow, saysWhatItHidesWithItsModel) {
  const glm::ivec3 dims = scene().volume->grid().dims;
  const std::vector<std::uint8_t> all(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1);
  session().setKeep(bodyRegion(dims, all), {nextGestureId(), QStringLiteral("body only")});
  ASSERT_TRUE(rest());
  type("turntableFrames", QStringLiteral("2"));
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_EQ(said(), QStringLiteral("Saved turn.frames. Its frames do not say what they show: Classic · Body "
                                   "only: table hidden."));
  session().setKeep({}, {nextGestureId(), QStringLiteral("everything")});
  ASSERT_TRUE(rest());
  if (videoProgram().empty())
    GTEST_SKIP() << "no video is made without ffmpeg";
  auto& kind = *dialog().findChild<QComboBox*>(QStringLiteral("turntableKind"));
  kind.setFocus();
  QTest::keyClick(&kind, Qt::Key_Down);
  save("turn.mp4");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_EQ(said(), QStringLiteral("Saved turn.mp4. Its frames do not say what they show: Classic."));
}

TEST_F(TurntableWindow, whileFramesAreDrawnThePictureOnScreenStaysAsItIs) {
  view().setRefinesAtRest(true);
  type("turntableFrames", QStringLiteral("4"));
  save("turn.frames");
  ASSERT_TRUE(dialog().isWorking());
  EXPECT_FALSE(view().order().refines);
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_TRUE(view().order().refines);
}

TEST_F(TurntableWindow, saysOfAFolderThatTakesNoneWhyItCannotBeMade) {
  type("turntableFrames", QStringLiteral("2"));
  save("/proc/turn.frames"); // of which the system says that there is none
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_EQ(said(), QStringLiteral("The folder /proc/turn.frames cannot be made (the folder /proc takes no "
                                   "files); choose another one."));
}

TEST_F(TurntableWindow, goesAsFarAsItIsAskedToWithWhatStandsInASavedPicture) {
  auto& turn = *dialog().findChild<QComboBox*>(QStringLiteral("turntableTurn"));
  auto& marks = *dialog().findChild<QCheckBox*>(QStringLiteral("turntableMarks"));
  turn.setFocus();
  QTest::keyClick(&turn, Qt::Key_Down);
  EXPECT_EQ(dialog().findChild<QDoubleSpinBox*>(QStringLiteral("turntableAngle"))->value(), 180.0);
  type("turntableFrames", QStringLiteral("3"));
  EXPECT_TRUE(said().startsWith(QStringLiteral("180° about"))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("a frame each 90.0°"))) << said().toStdString();
  EXPECT_TRUE(marks.isChecked());
  save("marked.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  const LoadedScene last = loadScene((folder.path() / "marked.frames" / "frame-0003.png").string(), {}, {});
  const Camera& camera = last.scene.camera;
  EXPECT_NEAR(glm::dot(basisOf(camera).forward, basisOf(scene().camera).forward), -1.0, 1e-9)
      << "the last frame is seen from behind";
  marks.setChecked(false);
  save("plain.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  const QImage marked(pathTo("marked.frames/frame-0001.png")), plain(pathTo("plain.frames/frame-0001.png"));
  ASSERT_EQ(marked.size(), plain.size());
  EXPECT_NE(marked, plain);
  const QRect middle = marked.rect().adjusted(40, 35, -40, -35);
  EXPECT_EQ(marked.copy(middle), plain.copy(middle)) << "marks stand at the edges";
  type("turntableAngle", QStringLiteral("90"));
  EXPECT_EQ(turn.currentText(), QStringLiteral("Another angle"));
  EXPECT_TRUE(said().contains(QStringLiteral("a frame each 45.0°"))) << said().toStdString();
}

TEST_F(TurntableWindow, ofTwoPicturesTheOneThatIsChosenIsSaved) {
  auto& picture = *dialog().findChild<QComboBox*>(QStringLiteral("turntablePicture"));
  EXPECT_EQ(picture.currentText(), QStringLiteral("Left: Classic"));
  picture.setFocus();
  QTest::keyClick(&picture, Qt::Key_Down);
  EXPECT_EQ(picture.currentText(), QStringLiteral("Right: Enhanced"));
  type("turntableFrames", QStringLiteral("2"));
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  const LoadedScene saved = loadScene((folder.path() / "turn.frames" / "frame-0001.png").string(), {}, {});
  EXPECT_EQ(saved.scene.shading.model, ShadingModel::enhanced);
}

TEST_F(TurntableWindow, aTurnBeginsAtAViewThatWasKept) {
  auto& start = *dialog().findChild<QComboBox*>(QStringLiteral("turntableStart"));
  EXPECT_FALSE(start.isVisible()) << "there is none";
  // A camera that is not framed turns as it is.
  Camera side = zoomed(standardView(scene().camera, scene().volume->grid(), StandardView::left), 2.0);
  session().setViews({{"the ear", side}, {std::string(500, 'x'), side}}, QStringLiteral("keep"));
  ASSERT_TRUE(start.isVisible());
  EXPECT_EQ(start.currentIndex(), 0);
  EXPECT_LE(dialog().sizeHint().width(), 600);
  start.setFocus();
  QTest::keyClick(&start, Qt::Key_Down);
  EXPECT_EQ(start.currentText(), QStringLiteral("the ear"));
  type("turntableFrames", QStringLiteral("2"));
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  const LoadedScene saved = loadScene((folder.path() / "turn.frames" / "frame-0001.png").string(), {}, {});
  EXPECT_EQ(saved.scene.camera, side);
  EXPECT_TRUE(saved.views.empty()) << "pictures go to others: they carry no names";
}

// Which other sides would hide.
TEST_F(TurntableWindow, saysThatWhatWasMeasuredIsNotInItsFrames) {
  const QString sentence = QStringLiteral("What was measured is not in its frames.");
  EXPECT_FALSE(said().contains(sentence)) << said().toStdString();
  const glm::dvec3 middle = scene().camera.target;
  session().setMeasurements(
      {{Measurement::Kind::distance, std::nullopt, {middle, middle + glm::dvec3(20.0, 0.0, 0.0)}}},
      {nextGestureId(), QStringLiteral("measured")});
  EXPECT_TRUE(test::waitUntil([&] { return said().contains(sentence); })) << said().toStdString();
  type("turntableFrames", QStringLiteral("2"));
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_EQ(said(), QStringLiteral("Saved turn.frames. ") + sentence);
}

// Seen from the front a head fills less of a picture's width than from its side.
TEST_F(TurntableWindow, saysWhereItBeginsSmallerThanWhatIsShown) {
  type("turntableWidth", QStringLiteral("60")); // for a head to fill the width
  type("turntableFrames", QStringLiteral("4"));
  ASSERT_TRUE(
      test::waitUntil([this] { return said().contains(QStringLiteral("so that nothing is cut off")); }));
  const QRegularExpressionMatch told = QRegularExpression(QStringLiteral("begins at (\\d+) %")).match(said());
  ASSERT_TRUE(told.hasMatch()) << said().toStdString();
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  const Camera first =
      loadScene((folder.path() / "turn.frames" / "frame-0001.png").string(), {}, {}).scene.camera;
  const auto away = [](const Camera& camera) { return glm::distance(camera.position, camera.target); };
  EXPECT_EQ(told.captured(1).toInt(), qRound(100.0 * away(scene().camera) / away(first)));
  // A camera that came nearer turns as it stands.
  Turntable nearer;
  nearer.scene = scene();
  nearer.size = {60, 100};
  nearer.frames = 4;
  nearer.cameraAspect = view().pictureAspect();
  EXPECT_LT(sizeAtFirst(nearer), 0.98);
  nearer.scene.camera = zoomed(scene().camera, 2.0);
  EXPECT_EQ(sizeAtFirst(nearer), 1.0);
}

TEST_F(TurntableWindow, saysWhatHoldsOfThePictureOfNowWhileItIsOpen) {
  const auto saysItBeginsSmaller = [this] {
    return said().contains(QStringLiteral("so that nothing is cut"));
  };
  type("turntableWidth", QStringLiteral("60"));
  type("turntableFrames", QStringLiteral("4"));
  ASSERT_TRUE(test::waitUntil(saysItBeginsSmaller));
  const Camera framed = scene().camera;
  session().setCamera(zoomed(framed, 2.0)); // turns as it stands
  EXPECT_TRUE(test::waitUntil([&] { return !saysItBeginsSmaller(); })) << said().toStdString();
  session().setCamera(framed);
  EXPECT_TRUE(test::waitUntil(saysItBeginsSmaller)) << said().toStdString();
  save("turn.frames");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  session().setCamera(zoomed(framed, 2.0));
  ASSERT_TRUE(rest());
  EXPECT_EQ(said(), QStringLiteral("Saved turn.frames.")) << "what came of drawing stays to be read";
}

TEST_F(TurntableWindow, saysThatItsTimeIsNotKnownOnceALampTurnsWithIt) {
  EXPECT_FALSE(said().contains(QStringLiteral("How long drawing takes"))) << said().toStdString();
  session().setShading(withLight(scene().shading, LightPreset::softStudio),
                       {nextGestureId(), QStringLiteral("light")});
  EXPECT_TRUE(test::waitUntil([this] {
    return said().contains(QStringLiteral("light is found anew for each frame"));
  })) << said().toStdString();
}

TEST_F(TurntableWindow, ofOnePictureNoneIsAskedFor) {
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  window->findChild<QAction*>(QStringLiteral("layout-single"))->trigger();
  window->findChild<QAction*>(QStringLiteral("saveTurntable"))->trigger();
  EXPECT_FALSE(dialog().findChild<QComboBox*>(QStringLiteral("turntablePicture"))->isVisible());
}

TEST_F(TurntableWindow, ofAVideoThatCannotBeWrittenNoFrameIsDrawn) {
  if (videoProgram().empty())
    GTEST_SKIP() << "no video is made without ffmpeg";
  auto& kind = *dialog().findChild<QComboBox*>(QStringLiteral("turntableKind"));
  kind.setFocus();
  QTest::keyClick(&kind, Qt::Key_End);
  type("turntableFrames", QStringLiteral("5000"));
  save("none/turn.mp4");
  ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  EXPECT_TRUE(said().contains(QStringLiteral("there is no folder"))) << said().toStdString();
}

TEST_F(TurntableWindow, isCancelledByEsc) {
  type("turntableFrames", QStringLiteral("5000"));
  save("turn.frames");
  ASSERT_TRUE(dialog().isWorking());
  const auto* frames = dialog().findChild<QDoubleSpinBox*>(QStringLiteral("turntableFrames"));
  EXPECT_FALSE(frames->isEnabled()) << "they are asked for";
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isWorking());
  EXPECT_TRUE(frames->isEnabled());
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_EQ(said(), QStringLiteral("Cancelled; frames that were drawn stay in their folder."));
}

TEST_F(TurntableWindow, ofAVideoThatIsCancelledNothingStays) {
  if (videoProgram().empty())
    GTEST_SKIP() << "ffmpeg is not installed";
  auto& kind = *dialog().findChild<QComboBox*>(QStringLiteral("turntableKind"));
  kind.setFocus();
  QTest::keyClick(&kind, Qt::Key_Down);
  type("turntableFrames", QStringLiteral("5000"));
  save("turn.mp4");
  ASSERT_TRUE(dialog().isWorking());
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isWorking());
  EXPECT_EQ(said(), QStringLiteral("Cancelled; no video was saved."));
  EXPECT_FALSE(fs::exists(folder.path() / "turn.mp4"));
}

} // namespace
} // namespace limn
