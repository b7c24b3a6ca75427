// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/OpeningWindow.h"
#include "app/files/opening/SeriesDialog.h"
#include "io/dicom/SyntheticSeries.h"

#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTreeWidget>

// What was opened before, on the page without a volume and in the menu.

namespace limn {
namespace {

class RecentWindow : public test::OpeningWindow {};

TEST_F(RecentWindow, theEmptyPageOffersWhatWasOpenedBefore) {
  ASSERT_TRUE(open(smallVolume("a")));
  QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
  ASSERT_FALSE(scene().volume);
  auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
  ASSERT_TRUE(recent && recent->isVisible());
  EXPECT_TRUE(recent->text().startsWith(QStringLiteral("small.nrrd"))) << recent->text().toStdString();
  QTest::mouseClick(recent, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  ASSERT_TRUE(scene().volume);
  EXPECT_EQ(scene().volume->grid().dims, glm::ivec3(2));
}

// A CT and an MR, which is smaller, in one folder; later perhaps another CT, the largest.
void writeSlices(const std::filesystem::path& folder, const char* modality, const std::string& series,
                 int count) {
  std::filesystem::create_directories(folder);
  for (int i = 1; i <= count; ++i)
    test::slice(i, i)
        .text(0x00080018, "UI", series + "." + std::to_string(i))
        .text(0x0020000E, "UI", series)
        .text(0x00080060, "CS", modality)
        .write(folder / (series + "." + std::to_string(i)));
}

TEST_F(RecentWindow, ofAFolderOfTwoTheSeriesIsOpenedAgainThatWasOpenedBefore) {
  const std::filesystem::path both = folder.path() / "both";
  writeSlices(both, "CT", "1.2.3.5", 4);
  writeSlices(both, "MR", "1.2.3.6", 3);
  const auto asked = [this]() -> SeriesDialog* {
    auto* dialog = window->findChild<SeriesDialog*>();
    return dialog && dialog->isVisible() ? dialog : nullptr;
  };
  const auto modality = [this] { return scene().volume ? scene().volume->info().modality : std::string(); };
  const auto openAgain = [this] {
    // Without a window manager nobody gives the keys back when the dialog before this one ends.
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
    ASSERT_FALSE(scene().volume);
    auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
    ASSERT_TRUE(recent && recent->isVisible());
    EXPECT_TRUE(recent->text().contains(QStringLiteral("MR 3×2×3"))) << recent->text().toStdString();
    QTest::mouseClick(recent, Qt::LeftButton);
  };
  window->openSource(pathTo("both"));
  ASSERT_TRUE(test::waitUntil([&] { return asked(); }));
  QTest::keyClick(asked()->findChild<QTreeWidget*>(), Qt::Key_Down);
  for (QPushButton* button : asked()->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Open"))
      QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([&] { return modality() == "MR"; }));
  openAgain();
  ASSERT_TRUE(test::waitUntil([&] { return scene().volume || asked(); }));
  EXPECT_FALSE(asked());
  EXPECT_EQ(modality(), "MR");
  // Its number is another's now.
  writeSlices(both, "CT", "1.2.3.7", 5);
  openAgain();
  ASSERT_TRUE(test::waitUntil([&] { return scene().volume || asked(); }));
  EXPECT_TRUE(asked());
}

TEST_F(RecentWindow, olderUnsavedWorkStandsBehindWhatWasSavedLast) {
  const auto button = [this](const char* name) {
    return window->findChild<QPushButton*>(QLatin1String(name));
  };
  const auto startAgain = [this] {
    window->close();
    window = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
    window->resize(1280, 800);
    window->show();
    window->keepSessions();
    QCoreApplication::processEvents();
  };
  window->keepSessions();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  dragAPoint();
  ASSERT_TRUE(open(QStringLiteral("phantom:6"))); // the one before is kept
  dragAPoint();
  saving().writeSession(pathTo("mine.limn.json"));
  startAgain();
  const QPushButton* unsaved = button("continue");
  const QPushButton* recent = button("recent");
  ASSERT_TRUE(unsaved->isVisible() && recent && recent->isVisible());
  static const QRegularExpression dated(QStringLiteral(R"(^Unsaved work:\n.+, \d+ \S+ \d{4}, \d\d:\d\d$)"));
  EXPECT_TRUE(unsaved->text().contains(dated)) << unsaved->text().toStdString();
  EXPECT_FALSE(unsaved->isDefault());
  EXPECT_TRUE(button("openFolder")->isDefault());
  EXPECT_TRUE(recent->text().startsWith(QStringLiteral("mine.limn.json"))) << recent->text().toStdString();
  EXPECT_GT(unsaved->mapTo(window.get(), QPoint()).y(), recent->mapTo(window.get(), QPoint()).y());
  // Opened and left again, it is the latest.
  QTest::mouseClick(button("continue"), Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return scene().volume && !window->loader().isLoading(); }));
  startAgain();
  ASSERT_TRUE(button("continue")->isVisible());
  EXPECT_TRUE(button("continue")->isDefault());
  EXPECT_FALSE(button("openFolder")->isDefault());
}

// An offer to restore what a crash left waits until that is read.
TEST_F(RecentWindow, whatIsNoLongerThereIsSaidThoughARestoreIsOffered) {
  const QString file = smallVolume("a");
  ASSERT_TRUE(open(file));
  QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
  std::filesystem::remove(file.toStdString());
  auto& offer = *window->findChild<MessageBar*>(QStringLiteral("recoveryBar"));
  offer.show(MessageBar::Kind::question, QStringLiteral("Restore the last session?"));
  auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
  ASSERT_TRUE(recent && recent->isVisible());
  QTest::mouseClick(recent, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  EXPECT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("small.nrrd")))
      << messages().sentence().toStdString();
  messages().hide();
  EXPECT_TRUE(offer.isVisible()) << "the offer stands";
}

// Its drive may only be missing just now.
TEST_F(RecentWindow, whatIsNoLongerThereStaysInTheListUntilItIsTakenOut) {
  const QString file = smallVolume("a");
  ASSERT_TRUE(open(file));
  ASSERT_TRUE(open(smallVolume("b")));
  const auto count = [this] {
    return Settings(UserFolders::below(folder.path()).settings).recentSources().size();
  };
  std::filesystem::rename(file.toStdString(), folder.path() / "unplugged");
  auto& menu = *window->findChild<QMenu*>(QStringLiteral("recentSources"));
  const auto openSecond = [&] {
    menu.popup(window->mapToGlobal(QPoint(20, 20)));
    menu.setActiveAction(menu.actions()[1]);
    QTest::keyClick(&menu, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
  };
  openSecond();
  ASSERT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("is not where it was")))
      << messages().sentence().toStdString();
  EXPECT_EQ(count(), 2);
  std::filesystem::rename(folder.path() / "unplugged", file.toStdString());
  openSecond();
  EXPECT_FALSE(messages().isVisible());
  std::filesystem::remove(file.toStdString());
  ASSERT_TRUE(open(file));
  choose("Remove from recent files");
  EXPECT_EQ(count(), 1);
  EXPECT_FALSE(messages().isVisible());
}

TEST_F(RecentWindow, oneOfTheRecentFilesIsTakenOutByDelOrARightClick) {
  for (const char* place : {"a", "b", "c", "d"})
    ASSERT_TRUE(open(smallVolume(place)));
  const auto paths = [this] {
    QStringList found;
    for (const RecentSource& source : Settings(UserFolders::below(folder.path()).settings).recentSources())
      found << QFileInfo(source.path).dir().dirName();
    return found.join(QLatin1Char(' '));
  };
  ASSERT_EQ(paths(), QStringLiteral("d c b a"));
  auto& menu = *window->findChild<QMenu*>(QStringLiteral("recentSources"));
  menu.popup(window->mapToGlobal(QPoint(20, 20)));
  menu.setActiveAction(menu.actions()[1]);
  QTest::keyClick(&menu, Qt::Key_Delete);
  EXPECT_EQ(paths(), QStringLiteral("d b a"));
  EXPECT_TRUE(menu.isVisible());
  EXPECT_EQ(menu.activeAction(), menu.actions()[1]) << "the next one";
  QTest::mouseClick(&menu, Qt::RightButton, {}, menu.actionGeometry(menu.actions()[0]).center());
  auto* offer = menu.findChild<QMenu*>(QStringLiteral("removalOffer"));
  ASSERT_TRUE(offer && offer->isVisible());
  QTest::mouseClick(offer, Qt::LeftButton, {}, offer->actionGeometry(offer->actions()[0]).center());
  EXPECT_EQ(paths(), QStringLiteral("b a"));
  menu.close();
  EXPECT_FALSE(window->loader().isLoading()) << "a right click opens nothing";
  // On the page without a volume.
  QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier);
  auto* recent = window->findChild<QPushButton*>(QStringLiteral("recent"));
  ASSERT_TRUE(recent && recent->isVisible());
  recent->setFocus();
  QTest::keyClick(recent, Qt::Key_Delete);
  EXPECT_TRUE(test::waitUntil([&] { return paths() == QStringLiteral("a"); })) << paths().toStdString();
}

} // namespace
} // namespace limn
