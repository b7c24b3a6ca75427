// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that were drawn and could not be written.
#include "app/DialogKeys.h"
#include "app/files/saving/SavedPicture.h"

#include <QDeadlineTimer>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

#include <filesystem>
#include <thread>
#include <vector>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

// A full disk, or a folder that went meanwhile, takes no picture that minutes were spent on.
TEST_F(SavedPicture, thatWasDrawnButNotWrittenIsSavedElsewhere) {
  lookFromAfar();
  const PictureOptions options{.size = PictureOptions::Size::twice, .marks = noMarks};
  const QSize size = saved("usual.png", options).size();
  saving().writePicture(pathTo("gone/twice.png"), options);
  ASSERT_TRUE(test::waitUntil([this] { return !stopButton().isVisible(); }));
  const auto& offer = *window->findChild<MessageBar*>(QStringLiteral("unwrittenBar"));
  auto& elsewhere = *offer.findChild<QToolButton*>(QStringLiteral("messageAction"));
  ASSERT_TRUE(elsewhere.isVisible()) << offer.sentence().toStdString();
  EXPECT_EQ(elsewhere.text(), QStringLiteral("Save elsewhere…"));
  EXPECT_TRUE(offer.sentence().contains(QStringLiteral("there is no folder")));
  typeName(pathTo("gone/again.png"));
  QTest::mouseClick(&elsewhere, Qt::LeftButton);
  EXPECT_TRUE(stopButton().isVisible()) << "it is written beside the event loop";
  ASSERT_TRUE(test::waitUntil([this] { return !stopButton().isVisible(); }));
  ASSERT_TRUE(elsewhere.isVisible()) << "it is still there to be saved";
  EXPECT_TRUE(offer.sentence().contains(QStringLiteral("again.png")));
  messages().show(MessageBar::Kind::error, QStringLiteral("Something else went wrong."));
  EXPECT_FALSE(elsewhere.isVisible()) << "one is seen at a time";
  messages().hide();
  ASSERT_TRUE(elsewhere.isVisible()) << "what else is said takes no picture";
  typeName(pathTo("there.png"));
  QTest::mouseClick(&elsewhere, Qt::LeftButton);
  EXPECT_EQ(written("there.png").size(), size);
  EXPECT_FALSE(offer.isWanted());
  EXPECT_FALSE(readImageDescription(folder.path() / "there.png").empty()) << "it carries its scene";
}

// Cancelled too late it is in its file, and must not be offered or called lost.
TEST_F(SavedPicture, thatIsBeingSavedElsewhereIsNotCalledUnwrittenAfterwards) {
  const PictureOptions options{.size = PictureOptions::Size::twice, .marks = noMarks};
  saving().writePicture(pathTo("gone/twice.png"), options);
  ASSERT_TRUE(test::waitUntil([this] { return !stopButton().isVisible(); }));
  ASSERT_EQ(saving().unwritten(), QStringList(QStringLiteral("twice.png")));
  const auto& offer = *window->findChild<MessageBar*>(QStringLiteral("unwrittenBar"));
  typeName(pathTo("there.png"));
  QTest::mouseClick(offer.findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  ASSERT_TRUE(stopButton().isVisible());
  stopButton().click(); // before any other event
  EXPECT_TRUE(window->statusBar()->currentMessage().startsWith(QStringLiteral("Too late to cancel")));
  EXPECT_TRUE(stopButton().isVisible()) << "it goes on";
  EXPECT_FALSE(written("there.png").isNull());
  EXPECT_TRUE(saving().unwritten().isEmpty());
  EXPECT_FALSE(offer.isWanted());
}

// The window has not heard yet that its file is there, and must not take it for cancelled.
TEST_F(SavedPicture, thatIsInItsFileIsToldOfThoughItIsCancelledBeforeTheWindowHearsOfIt) {
  lookFromAfar();
  saving().writePicture(pathTo("there.png"), {.size = PictureOptions::Size::twice, .marks = noMarks});
  ASSERT_TRUE(stopButton().isVisible());
  const QDeadlineTimer deadline(60000);
  while (!isWholePicture(folder.path() / "there.png") && !deadline.hasExpired()) // no event in between
    std::this_thread::yield();
  stopButton().click();
  EXPECT_TRUE(window->statusBar()->currentMessage().startsWith(QStringLiteral("Too late to cancel")));
  ASSERT_FALSE(written("there.png").isNull());
  EXPECT_EQ(window->statusBar()->currentMessage(), QStringLiteral("Saved there.png"));
}

TEST_F(SavedPicture, ofSeveralThatCouldNotBeWrittenEachIsOfferedUntilItIsSavedOrDismissed) {
  lookFromAfar();
  const PictureOptions options{.size = PictureOptions::Size::twice, .marks = noMarks};
  for (const char* name : {"gone/first.png", "gone/second.png", "gone/third.png"}) {
    saving().writePicture(pathTo(name), options);
    ASSERT_TRUE(test::waitUntil([this] { return !stopButton().isVisible(); }));
  }
  const auto& offer = *window->findChild<MessageBar*>(QStringLiteral("unwrittenBar"));
  EXPECT_TRUE(offer.sentence().contains(QStringLiteral("third.png"))) << offer.sentence().toStdString();
  const QStringList all{QStringLiteral("third.png"), QStringLiteral("second.png"),
                        QStringLiteral("first.png")};
  EXPECT_EQ(saving().unwritten(), all);
  dismiss(offer);
  ASSERT_TRUE(offer.isVisible());
  EXPECT_TRUE(offer.sentence().contains(QStringLiteral("second.png"))) << "the one before comes back";
  typeName(pathTo("there.png"));
  QTest::mouseClick(offer.findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_FALSE(written("there.png").isNull());
  EXPECT_TRUE(offer.sentence().contains(QStringLiteral("first.png")));
  int asked = 0;
  const auto answer = [&](QMessageBox::ButtonRole role) {
    onceAsked<QMessageBox>([&asked, role](QMessageBox& box) {
      ++asked;
      EXPECT_EQ(box.informativeText(), QStringLiteral("first.png"));
      for (QAbstractButton* button : box.buttons())
        if (box.buttonRole(button) == role)
          return QTest::mouseClick(button, Qt::LeftButton);
    });
  };
  answer(QMessageBox::RejectRole);
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(offer.isVisible()) << "it is still there to be saved";
  answer(QMessageBox::DestructiveRole);
  EXPECT_TRUE(window->close());
  EXPECT_EQ(asked, 2);
  window->show();
  dismiss(offer);
  EXPECT_FALSE(offer.isWanted());
  EXPECT_TRUE(window->close()) << "there is nothing to lose any more";
}

// Pixels alone are kept, and of those no more than have room: whatever fails, the memory is not filled.
TEST_F(SavedPicture, ofThoseThatCouldNotBeWrittenTheOldestGoWhereTheyHaveNoRoomAndItIsSaid) {
  lookFromAfar();
  const PictureOptions options{.size = PictureOptions::Size::twice, .marks = noMarks};
  const QSize size = saved("usual.png", options).size();
  const std::size_t bytes = sizeof(glm::vec4) * static_cast<std::size_t>(size.width()) * size.height();
  const auto fail = [&](const char* name) {
    saving().writePicture(pathTo(name), options);
    return test::waitUntil([this] { return !stopButton().isVisible(); });
  };
  const std::weak_ptr<const Volume> volume = scene().volume;
  saving().setMostKept(2 * bytes + bytes / 2);
  messages().hide();
  ASSERT_TRUE(fail("gone/first.png") && fail("gone/second.png"));
  EXPECT_EQ(saving().unwritten().size(), 2);
  EXPECT_FALSE(messages().isWanted()) << "both have room";
  ASSERT_TRUE(fail("gone/third.png"));
  EXPECT_EQ(saving().unwritten(), QStringList({QStringLiteral("third.png"), QStringLiteral("second.png")}));
  EXPECT_TRUE(messages().isWanted());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("first.png")))
      << messages().sentence().toStdString();
  saving().setMostKept(1);
  ASSERT_TRUE(fail("gone/fourth.png"));
  EXPECT_EQ(saving().unwritten(), QStringList(QStringLiteral("fourth.png"))) << "the latest in any case";
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("third.png, ")) ||
              messages().sentence().contains(QStringLiteral(", third.png")))
      << messages().sentence().toStdString();
  ASSERT_TRUE(open(QStringLiteral("phantom:5")) && rest());
  EXPECT_TRUE(test::waitUntil([&volume] { return volume.expired(); })) << "its volume is not kept";
}

} // namespace
} // namespace limn::test
