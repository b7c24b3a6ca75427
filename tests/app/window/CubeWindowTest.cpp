// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "support/FileBytes.h"
#include "widgets/view/overlay/Overlay.h"

// The cube in the picture that shows how it lies, in the program's window: clicked, pointed at, switched off.

namespace limn {
namespace {

class CubeWindow : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    window->resize(1280, 900);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:6")));
    ASSERT_TRUE(rest());
  }

  QAction& named(const char* name) const { return *window->findChild<QAction*>(QLatin1String(name)); }
  const Camera& camera() const { return scene().camera; }
  OverlaySource source() { return {view().order(), view().pictureState()}; }
  std::optional<OrientationCube> cube() { return overlayOf(source()).cube; }
  std::vector<CubeSide> sides() { return cube().value_or(OrientationCube()).sides; }

  // The middle of the face that bears a letter, in the window.
  QPoint faceWith(const QString& letter) {
    for (const CubeSide& side : sides())
      if (side.letter == letter)
        return view().mapTo(window.get(), side.onto.map(QPointF(0.0, 0.0))).toPoint();
    ADD_FAILURE() << letter.toStdString() << " is not seen";
    return {};
  }
  // Where its plate stands in the middle of the window, as the messages do.
  QRect plate() {
    return cube()->plate.toAlignedRect().translated(view().mapTo(window->centralWidget(), QPoint()));
  }
  void click(const QPoint& at) {
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, at);
    QCoreApplication::processEvents();
  }
  void pointAt(const QPoint& at) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, at);
    QCoreApplication::processEvents();
  }
  void turnALittle() {
    view().setFocus();
    for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Right, Qt::Key_Right, Qt::Key_Right,
                              Qt::Key_Down, Qt::Key_Down, Qt::Key_Down, Qt::Key_Down, Qt::Key_Down})
      QTest::keyClick(window->windowHandle(), key);
  }
  void goBack() { QTest::keyClick(window->windowHandle(), Qt::Key_Left, Qt::AltModifier); }
  Camera seenBy(const char* action) {
    const Camera now = camera();
    named(action).trigger();
    const Camera there = camera();
    session().setCamera(now);
    return there;
  }
};

TEST_F(CubeWindow, aClickOnAFaceLooksFromThereAsTheStandardViewDoesAndAltLeftGoesBack) {
  ASSERT_TRUE(cube());
  turnALittle();
  const std::map<QString, const char*> views{{"A", "view-anterior"}, {"P", "view-posterior"},
                                             {"L", "view-left"},     {"R", "view-right"},
                                             {"S", "view-superior"}, {"I", "view-inferior"}};
  const Camera oblique = camera();
  ASSERT_EQ(sides().size(), 3u);
  for (const CubeSide& side : sides()) {
    const Camera expected = seenBy(views.at(side.letter));
    click(faceWith(side.letter));
    EXPECT_EQ(camera(), expected) << side.letter.toStdString();
    goBack();
    EXPECT_EQ(camera(), oblique) << "one step";
  }
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(CubeWindow, straightOnAClickLooksFromTheOppositeSide) {
  const Camera front = seenBy("view-anterior");
  named("view-anterior").trigger();
  ASSERT_EQ(sides().size(), 1u);
  const Camera back = seenBy("view-posterior");
  click(faceWith(QStringLiteral("A")));
  EXPECT_EQ(camera(), back);
  click(faceWith(QStringLiteral("P")));
  EXPECT_EQ(camera(), front);
}

TEST_F(CubeWindow, aFaceUnderThePointerLightsUpAndSaysWhereItLeads) {
  turnALittle();
  EXPECT_FALSE(cube()->lit);
  const CubeSide side = sides().front();
  pointAt(faceWith(side.letter));
  ASSERT_TRUE(cube()->lit);
  EXPECT_EQ(*cube()->lit, side.face);
  EXPECT_EQ(view().toolTip(), cubeFaces(*scene().volume)[side.face].meaning);
  EXPECT_EQ(view().cursor().shape(), Qt::PointingHandCursor);
  pointAt(view().mapTo(window.get(), view().rect().center()));
  EXPECT_FALSE(cube()->lit);
  EXPECT_TRUE(view().toolTip().isEmpty());
}

TEST_F(CubeWindow, aDoubleClickOnItIsNoOneOnThePicture) {
  turnALittle();
  const QWidget* presets = window->findChild<QWidget*>(QStringLiteral("presetDock"));
  ASSERT_TRUE(presets->isVisible());
  QTest::mouseDClick(window->windowHandle(), Qt::LeftButton, {}, faceWith(sides().front().letter));
  QCoreApplication::processEvents();
  EXPECT_TRUE(presets->isVisible()) << "the picture is not alone";
}

TEST_F(CubeWindow, theMenuSwitchesItOffAndTheNextWindowRemembersThat) {
  EXPECT_TRUE(named("orientationCube").isChecked());
  named("orientationCube").trigger();
  EXPECT_FALSE(cube());
  const Camera before = camera();
  EXPECT_FALSE(Settings(UserFolders::below(folder.path()).settings).cubeIsShown());
  MainWindow next(UserFolders::below(folder.path()));
  EXPECT_FALSE(next.view().order().hasCube);
  EXPECT_EQ(camera(), before);
  named("orientationCube").trigger();
  EXPECT_TRUE(cube());
}

TEST_F(CubeWindow, ofTwoPicturesTheFirstHasItWhereThereIsRoom) {
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  window->resize(1700, 900);
  ASSERT_TRUE(rest());
  if (const QRectF first = view().logicalRect(0); first.width() >= 300.0 && first.height() >= 300.0) {
    ASSERT_TRUE(cube());
    EXPECT_TRUE(first.contains(cube()->plate));
  }
  window->resize(800, 560);
  ASSERT_TRUE(test::waitUntil([this] { return view().logicalRect(0).height() < 300.0; }));
  EXPECT_FALSE(cube());
}

TEST_F(CubeWindow, whereTheFileSaysNoSidesItNamesAxesAndTurnsToThem) {
  test::writeBytes(folder.path() / "small.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n\n"
                   "0 100 200 300 400 500 600 700\n");
  ASSERT_TRUE(open(pathTo("small.nrrd")));
  messages().hide(); // what it says of the file lies over the lower edge
  ASSERT_TRUE(rest());
  turnALittle();
  ASSERT_EQ(sides().size(), 3u);
  for (const CubeSide& side : sides())
    EXPECT_TRUE(side.letter == QChar(0x2212) + QStringLiteral("y") || side.letter.contains(u'x') ||
                side.letter.contains(u'z'))
        << side.letter.toStdString();
  const Camera expected = seenBy("view-anterior"); // "From the first row"
  click(faceWith(QChar(0x2212) + QStringLiteral("y")));
  EXPECT_LT(glm::length(basisOf(camera()).forward - basisOf(expected).forward), 1e-12); // rounding
  EXPECT_LT(glm::length(basisOf(camera()).up - basisOf(expected).up), 1e-12);
}

TEST_F(CubeWindow, messagesStandBesideItAndItTurnsThePictureMeanwhile) {
  const auto& middle = *window->centralWidget();
  for (const QSize size : {QSize(1440, 900), QSize(1024, 700)}) {
    window->resize(size);
    ASSERT_TRUE(test::waitUntil([&] { return window->size() == size && rest(); }));
    messages().show(MessageBar::Kind::question,
                    QStringLiteral("What is asked takes so many words that ").repeated(6));
    QCoreApplication::processEvents();
    ASSERT_TRUE(messages().isVisible() && cube());
    EXPECT_FALSE(messages().geometry().intersects(plate())) << size.width();
    EXPECT_TRUE(middle.rect().contains(messages().geometry())) << size.width();
  }
  turnALittle();
  ASSERT_GT(sides().size(), 1u);
  click(faceWith(sides().back().letter));
  EXPECT_TRUE(test::waitUntil([this] { return sides().size() == 1u; })) << "straight on";
}

TEST_F(CubeWindow, noSavedPictureHasIt) {
  const QImage with = view().currentPicture(0);
  named("orientationCube").trigger();
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().currentPicture(0), with);
}

} // namespace
} // namespace limn
