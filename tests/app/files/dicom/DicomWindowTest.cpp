// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/files/exports/DicomDialog.h"
#include "app/privacy/Marks.h"
#include "support/FileBytes.h"
#include "support/Openings.h"

#include <QCheckBox>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

// Picture and look of a series, saved and opened again in the program's window.

namespace limn {
namespace {

namespace fs = std::filesystem;

class DicomWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    test::writeMarkedSeries(folder.path() / "series");
    ASSERT_TRUE(open(pathTo("series")));
    ASSERT_TRUE(rest());
  }

  DicomDialog& dialog() const { return *window->findChild<DicomDialog*>(); }
  QAction& saveDicom() const { return *window->findChild<QAction*>(QStringLiteral("saveDicom")); }
  QString said() const { return dialog().findChild<QLabel*>(QStringLiteral("dicomSays"))->text(); }
  QPushButton& button(const char* name) const {
    return *dialog().findChild<QPushButton*>(QLatin1String(name));
  }

  void ask() {
    saveDicom().trigger();
    ASSERT_TRUE(test::waitUntil([this] { return dialog().isActiveWindow(); }));
  }

  void save(const char* name) {
    typeName(pathTo(name));
    QTest::mouseClick(&button("dicomSave"), Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([this] { return !dialog().isWorking(); }));
  }

  std::string bytes(const char* name) const { return test::bytesOfFile(folder.path() / name); }
  // How a look read back differs from what was saved: the picture's own size.
  static Scene withoutSize(Scene scene) {
    scene.image = {};
    scene.volume.reset();
    return scene;
  }
};

// Volume, list of series, looks beside it and what is saved: all from one look at the headers.
TEST_F(DicomWindow, opensEachFileOnceForItsHeaderAndOnceForItsPixels) {
  fs::copy(folder.path() / "series", folder.path() / "other");
  test::Openings openings(folder.path() / "other");
  ASSERT_TRUE(open(pathTo("other")));
  ASSERT_TRUE(rest());
  ask();
  const auto counted = openings.counted();
  EXPECT_EQ(static_cast<int>(counted.size()), scene().volume->grid().dims.z);
  for (const auto& [file, count] : counted)
    EXPECT_EQ(count, 2) << file;
}

TEST_F(DicomWindow, savesALookThatOpensAgainAsItWas) {
  setLayout(CompareLayout::single);
  dragAPoint();
  session().setCamera(orbited(scene().camera, 0.3, 0.2));
  ASSERT_TRUE(rest());
  const Scene before = scene();
  ask();
  save("kept.dicom");
  EXPECT_EQ(said(), QStringLiteral("Saved kept.dicom."));
  EXPECT_TRUE(fs::exists(folder.path() / "kept.dicom/picture.dcm"));
  QTest::mouseClick(&button("dicomClose"), Qt::LeftButton);
  window->openSource(QStringLiteral("phantom:8"));
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  // By a file alone: the series was opened before.
  ASSERT_TRUE(open(pathTo("kept.dicom/look.dcm")));
  ASSERT_TRUE(rest());
  EXPECT_EQ(withoutSize(scene()), withoutSize(before)) << messages().sentence().toStdString();
  EXPECT_EQ(scene().volume->info().patient.id, "PID774411");
}

TEST_F(DicomWindow, saysWhatTheFilesCarryAndWritesThemWithout) {
  ask();
  EXPECT_TRUE(labelSays(QStringLiteral("carry what the series says of its patient")));
  const auto* losses = dialog().findChild<QListWidget*>(QStringLiteral("dicomLosses"));
  EXPECT_GE(losses->count(), 3);
  const auto* anonymous = dialog().findChild<QCheckBox*>(QStringLiteral("dicomAnonymous"));
  QTest::keyClick(dialog().windowHandle(), Qt::Key_L, Qt::AltModifier); // by the keyboard
  ASSERT_TRUE(test::waitUntil([&] { return anonymous->isChecked(); }));
  save("nobodys.dicom");
  std::size_t searched = 0;
  for (const char* name : {"nobodys.dicom/look.dcm", "nobodys.dicom/picture.dcm"})
    EXPECT_EQ(test::marksIn(bytes(name), searched), std::set<std::string>{"1.2.826.99"}) << name; // UIDs
  QTest::mouseClick(dialog().windowHandle(), Qt::LeftButton, {},
                    anonymous->mapTo(&dialog(), QPoint(10, anonymous->height() / 2)));
  ASSERT_TRUE(test::waitUntil([&] { return !anonymous->isChecked(); }));
  save("somebodys.dicom");
  EXPECT_TRUE(test::marksIn(bytes("somebodys.dicom/look.dcm"), searched).contains("ZEBEDEE"));
}

TEST_F(DicomWindow, drawsNothingForAPlaceThatTakesNoFolder) {
  test::writeBytes(folder.path() / "file", "no folder");
  ask();
  for (const char* below : {"file/kept.dicom", "file/below/kept.dicom"}) {
    save(below);
    EXPECT_TRUE(
        labelSays(QStringLiteral("The folder %1 cannot be made (Not a directory)").arg(pathTo(below))))
        << "the folder that was typed";
  }
  save("/proc/kept.dicom"); // of which the system says that there is none
  EXPECT_EQ(said(), QStringLiteral("The folder /proc/kept.dicom cannot be made (the folder /proc takes no "
                                   "files); choose another one."));
  EXPECT_EQ(dialog().findChild<QProgressBar*>()->value(), 0) << "nothing was drawn";
}

TEST_F(DicomWindow, isInTheFileMenuOfASeriesAlone) {
  EXPECT_TRUE(saveDicom().isEnabled());
  EXPECT_TRUE(window->menuBar()->actions().front()->menu()->actions().contains(&saveDicom()));
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_FALSE(saveDicom().isEnabled());
}

TEST_F(DicomWindow, itsSentencesFollowTheScene) {
  setLayout(CompareLayout::single);
  ask();
  const auto* losses = dialog().findChild<QListWidget*>(QStringLiteral("dicomLosses"));
  const QString fog = QStringLiteral("The fog is not kept.");
  EXPECT_TRUE(losses->findItems(fog, Qt::MatchExactly).isEmpty());
  Fog some;
  some.mode = Fog::Mode::exp;
  session().setFog(some, {});
  EXPECT_TRUE(test::waitUntil([&] { return losses->findItems(fog, Qt::MatchExactly).size() == 1; }));
}

TEST_F(DicomWindow, aSingleImageOffersItsFolder) {
  const int slices = scene().volume->grid().dims.z;
  ASSERT_GT(slices, 1);
  const fs::path image = *fs::directory_iterator(folder.path() / "series");
  ASSERT_TRUE(open(QString::fromStdString(image.string())));
  ASSERT_EQ(scene().volume->grid().dims.z, 1);
  const auto offered = [this]() -> QToolButton* {
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == QStringLiteral("Open its folder"))
        return button;
    return nullptr;
  };
  ASSERT_NE(offered(), nullptr) << messages().sentence().toStdString();
  QTest::mouseClick(offered(), Qt::LeftButton);
  EXPECT_TRUE(test::waitUntil([&] { return scene().volume && scene().volume->grid().dims.z == slices; }));
  // Where it lies alone there is no more to open.
  fs::create_directory(folder.path() / "alone");
  fs::copy_file(image, folder.path() / "alone" / image.filename());
  ASSERT_TRUE(open(QString::fromStdString((folder.path() / "alone" / image.filename()).string())));
  ASSERT_EQ(scene().volume->grid().dims.z, 1);
  EXPECT_EQ(offered(), nullptr);
}

TEST_F(DicomWindow, closesWithEsc) {
  ask();
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_FALSE(dialog().isVisible());
}

TEST_F(DicomWindow, offersALookThatLiesBesideTheSeries) {
  session().setCamera(orbited(scene().camera, 0.5, 0.1));
  setLayout(CompareLayout::single);
  ASSERT_TRUE(rest());
  const Camera kept = scene().camera;
  ask();
  save("kept.dicom");
  dialog().close();
  fs::copy_file(folder.path() / "kept.dicom/look.dcm", folder.path() / "series/look.dcm");
  ASSERT_TRUE(open(pathTo("series")));
  const QString offered = QStringLiteral("Beside this series lies a look that belongs to it.");
  ASSERT_TRUE(test::waitUntil([&] { return messages().isVisible() && messages().sentence() == offered; }));
  EXPECT_NE(scene().camera, kept);
  for (QToolButton* one : messages().findChildren<QToolButton*>())
    if (one->text() == QStringLiteral("Show the look"))
      QTest::mouseClick(one, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  EXPECT_EQ(scene().camera, kept);
}

TEST_F(DicomWindow, anOfferWaitsUntilWhatIsAskedIsAnswered) {
  ask();
  save("kept.dicom");
  dialog().close();
  fs::copy_file(folder.path() / "kept.dicom/look.dcm", folder.path() / "series/look.dcm");
  // As the question about the table, which may come first: before looks are searched.
  const QString question = QStringLiteral("Shall I?");
  QObject::connect(
      window->findChild<OpeningController*>(), &OpeningController::loaded, window.get(),
      [&] { messages().show(MessageBar::Kind::question, question); }, Qt::SingleShotConnection);
  ASSERT_TRUE(open(pathTo("series")));
  auto* remarks = window->findChild<RemarksController*>();
  ASSERT_TRUE(remarks);
  ASSERT_TRUE(test::waitUntil([&] { return remarks->isWaiting(); })) << messages().sentence().toStdString();
  EXPECT_EQ(messages().sentence(), question);
  ASSERT_TRUE(messages().isVisible());
  messages().hide();
  EXPECT_TRUE(test::waitUntil([&] {
    return messages().isVisible() &&
           messages().sentence() == QStringLiteral("Beside this series lies a look that belongs to it.");
  }));
  EXPECT_FALSE(remarks->isWaiting());
}

TEST_F(DicomWindow, asksWhereTheSeriesOfALookIs) {
  ask();
  save("kept.dicom");
  dialog().close();
  fs::rename(folder.path() / "series", folder.path() / "moved"); // no longer where it was opened
  ASSERT_TRUE(open(pathTo("kept.dicom/look.dcm")));
  EXPECT_EQ(messages().sentence(), QStringLiteral("The series that this look belongs to is not beside it."));
  typeName(pathTo("moved"));
  for (QToolButton* one : messages().findChildren<QToolButton*>())
    if (one->text() == QStringLiteral("Locate volume…"))
      QTest::mouseClick(one, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading() && !messages().isVisible(); }))
      << messages().sentence().toStdString();
  EXPECT_TRUE(QString::fromStdString(scene().volume->info().format) == QStringLiteral("DICOM"));
}

} // namespace
} // namespace limn
