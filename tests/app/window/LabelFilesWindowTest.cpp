// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/LabelledBoxes.h"
#include "scene/LabelLooks.h"
#include "widgets/controls/MessageBar.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QToolButton>

#include <fstream>

// Labels that lie in several files: chosen together, dropped together, and opened one after the other.

namespace limn {
namespace {

class LabelFilesWindow : public test::LabelledBoxes {
protected:
  void SetUp() override {
    LabelledBoxes::SetUp();
    write("label_Skull.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) && v.x < 16 ? 1 : 0; });
    write("label_Brain.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) && v.x >= 16 ? 1 : 0; });
    write("parts.seg.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) ? 1 + v.z / 16 : 0; });
    ASSERT_TRUE(open(pathTo("two.nrrd")));
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Label& label : scene().keep.labels->labels())
      names.push_back(label.name);
    return names;
  }

  QToolButton* offered(const QString& text) {
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == text)
        return button;
    return nullptr;
  }
};

const std::vector<std::string> brainAndSkull{"Background", "Brain", "Skull"};

TEST_F(LabelFilesWindow, masksThatAreChosenTogetherAreOneSegmentation) {
  typeName(QStringLiteral("\"%1\" \"%2\"").arg(pathTo("label_Skull.nrrd"), pathTo("label_Brain.nrrd")));
  window->findChild<QAction*>(QStringLiteral("openLabels"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
  EXPECT_EQ(names(), brainAndSkull);
  EXPECT_EQ(undo().undoText(), QStringLiteral("open labels of 2 files"));
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
}

TEST_F(LabelFilesWindow, masksThatAreDroppedTogetherAreOneSegmentation) {
  QMimeData data;
  data.setUrls(
      {QUrl::fromLocalFile(pathTo("label_Brain.nrrd")), QUrl::fromLocalFile(pathTo("label_Skull.nrrd"))});
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(window.get(), &enter);
  QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(window.get(), &event);
  ASSERT_TRUE(test::waitUntil([this] { return scene().keep.kind == Region::Kind::labels; }));
  EXPECT_EQ(names(), brainAndSkull);
}

TEST_F(LabelFilesWindow, aMaskComesToTheOneThatIsOpenWhichStaysAsItWas) {
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  EXPECT_EQ(undo().undoText(), QStringLiteral("open labels label_Skull.nrrd"));
  Region faded = scene().keep;
  faded.weights[1] = 0.5;
  const TransferFunction red{1.0, {{200.0, {1.0, 0.0, 0.0}, 0.0}, {300.0, {1.0, 0.0, 0.0}, 0.9}}};
  session().setKeep(withLookOf(faded, 1, red), {nextGestureId(), QStringLiteral("fade")});
  ASSERT_TRUE(openLabels("label_Brain.nrrd"));
  EXPECT_EQ(names(), (std::vector<std::string>{"Background", "Skull", "Brain"}));
  EXPECT_EQ(scene().keep.weights, (std::vector<double>{1.0, 0.5, 1.0}));
  EXPECT_EQ(lookOfLabel(scene().keep, 1), 1u);
  EXPECT_EQ(undo().undoText(), QStringLiteral("open labels label_Brain.nrrd"));
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
  // A session comes back to both.
  const Region both = scene().keep;
  std::ofstream(folder.path() / "session.json") << sessionToJson(window->sessionDocument());
  undo().undo();
  EXPECT_EQ(names(), (std::vector<std::string>{"Background", "Skull"}));
  ASSERT_TRUE(open(pathTo("session.json")));
  ASSERT_EQ(scene().keep.kind, Region::Kind::labels);
  EXPECT_EQ(sourcesOf(scene().keep), sourcesOf(both));
  EXPECT_EQ(scene().keep.weights, both.weights);
  EXPECT_EQ(scene().keep.looks, both.looks);
}

// What is edited, undone or lost while a mask is read is not undone by it.
TEST_F(LabelFilesWindow, whatIsEditedWhileAMaskIsReadStays) {
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  const TransferFunction red{1.0, {{200.0, {1.0, 0.0, 0.0}, 0.0}, {300.0, {1.0, 0.0, 0.0}, 0.9}}};
  regions().openLabels(pathTo("label_Brain.nrrd"));
  Region edited = withLookOf(scene().keep, 1, red);
  edited.weights[1] = 0.25;
  session().setKeep(edited, {nextGestureId(), QStringLiteral("fade")});
  ASSERT_TRUE(regions().isBusy()) << "it comes in a later turn of the event loop";
  ASSERT_TRUE(ready());
  EXPECT_EQ(names(), (std::vector<std::string>{"Background", "Skull", "Brain"}));
  EXPECT_EQ(scene().keep.weights, (std::vector<double>{1.0, 0.25, 1.0}));
  EXPECT_EQ(lookOfLabel(scene().keep, 1), 1u);
  undo().undo();
  EXPECT_EQ(scene().keep, edited);
  // Back to the mask alone as it was opened, while the other comes once more.
  regions().openLabels(pathTo("label_Brain.nrrd"));
  undo().undo();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.weights, (std::vector<double>{1.0, 1.0, 1.0}));
  EXPECT_TRUE(scene().keep.looks.empty());
}

TEST_F(LabelFilesWindow, aMaskComesToOneWhoseFileHasGone) {
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  std::filesystem::remove(folder.path() / "label_Skull.nrrd");
  ASSERT_TRUE(openLabels("label_Brain.nrrd"));
  EXPECT_EQ(names(), (std::vector<std::string>{"Background", "Skull", "Brain"}));
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
}

TEST_F(LabelFilesWindow, labelsThatGaveWayAreNamedAndComeBack) {
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  const Region before = scene().keep;
  ASSERT_TRUE(openLabels("parts.seg.nrrd"));
  EXPECT_EQ(names().size(), 3u);
  ASSERT_TRUE(messages().isVisible());
  EXPECT_EQ(messages().sentence(),
            QStringLiteral("The labels of parts.seg.nrrd took the place of those of label_Skull.nrrd."));
  QToolButton* back = offered(QStringLiteral("Bring those back"));
  ASSERT_NE(back, nullptr);
  QTest::mouseClick(back, Qt::LeftButton);
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep, before);
  EXPECT_FALSE(messages().isVisible());
  undo().undo();
  EXPECT_EQ(names().size(), 3u) << "which is a step";
}

TEST_F(LabelFilesWindow, aLabelThatOthersCoverIsNamedInTheSentenceItself) {
  const QString covered = QStringLiteral("%1 has no voxels of its own: Head, read after it, covers them.");
  const auto head = [](const glm::ivec3& v) { return isInBoxes(v) ? 1 : 0; };
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  write("label_Head.nrrd", head);
  ASSERT_TRUE(openLabels("label_Head.nrrd"));
  EXPECT_TRUE(messages().sentence().startsWith(covered.arg(QStringLiteral("Skull"))))
      << messages().sentence().toStdString();
  std::filesystem::create_directory(folder.path() / "masks");
  write("masks/label_Brain.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) && v.x >= 16 ? 1 : 0; });
  write("masks/label_Head.nrrd", head);
  ASSERT_TRUE(openLabels("masks"));
  EXPECT_EQ(messages().sentence(),
            QStringLiteral("The labels of masks took the place of those of 2 files. ") +
                covered.arg(QStringLiteral("Brain")));
}

TEST_F(LabelFilesWindow, smallerMasksCanBePutOnTopOfThoseThatCoverThem) {
  std::filesystem::create_directory(folder.path() / "masks");
  write("masks/label_Brain.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) && v.x >= 16 ? 1 : 0; });
  write("masks/label_Head.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) ? 1 : 0; });
  ASSERT_TRUE(openLabels("masks"));
  QToolButton* reorder = offered(QStringLiteral("Smaller ones on top"));
  ASSERT_NE(reorder, nullptr) << messages().sentence().toStdString();
  QTest::mouseClick(reorder, Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] {
    return names() != std::vector<std::string>{"Background", "Brain", "Head"};
  }));
  EXPECT_EQ(names(), (std::vector<std::string>{"Background", "Head", "Brain"}));
  for (const std::size_t place : {1, 2}) {
    const VoxelBox& box = scene().keep.labels->boxAround(place);
    EXPECT_NE(box.lower, box.upper) << place;
  }
  EXPECT_EQ(undo().undoText(), QStringLiteral("smaller labels on top"));
  EXPECT_EQ(offered(QStringLiteral("Smaller ones on top")), nullptr) << "which they are";
}

TEST_F(LabelFilesWindow, whatIsSaidOfLabelsThatGaveWayGoesWhereThatIsUndone) {
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  ASSERT_TRUE(openLabels("parts.seg.nrrd"));
  ASSERT_TRUE(messages().isVisible());
  session().setTransferFunction(shifted(scene().transferFunction, 50.0), {nextGestureId(), "shift"});
  undo().undo();
  EXPECT_TRUE(messages().isVisible()) << "another step";
  undo().undo();
  EXPECT_EQ(names().size(), 2u);
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
  undo().redo();
  EXPECT_FALSE(messages().isVisible()) << "undo brings them back by now";
}

TEST_F(LabelFilesWindow, whatIsSaidOfMasksThatOverlapGoesWhereTheyAreUndone) {
  write("label_Head.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) ? 1 : 0; });
  ASSERT_TRUE(openLabels("label_Skull.nrrd"));
  ASSERT_TRUE(openLabels("label_Head.nrrd"));
  ASSERT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("lie in two masks")))
      << messages().sentence().toStdString();
  undo().undo();
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
  // Both steps at once, as the list of steps goes back.
  undo().redo();
  ASSERT_TRUE(openLabels("label_Brain.nrrd"));
  ASSERT_TRUE(messages().isVisible());
  undo().setIndex(0);
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
}

// Neither of the two has a file by which it could be told.
TEST_F(LabelFilesWindow, whatIsSaidOfTheBodyGoesOnceEverythingIsShown) {
  test::writeShorts(folder.path() / "doubtful.nrrd", 40, [](const glm::ivec3& v) {
    const double radius = glm::length(glm::dvec3(v) - glm::dvec3(18.0, 15.0, 18.0));
    return radius < 6.0 ? 1200 : radius < 13.0 ? 40 : v.y >= 33 && v.y < 38 ? 200 : -1000;
  });
  ASSERT_TRUE(open(pathTo("doubtful.nrrd")));
  ASSERT_TRUE(test::waitUntil([this] { return messages().isAsking(); }));
  messages().hide();
  QAction& bodyOnly = *window->findChild<QAction*>(QStringLiteral("bodyOnly"));
  bodyOnly.trigger();
  ASSERT_TRUE(ready());
  ASSERT_EQ(scene().keep.kind, Region::Kind::body);
  ASSERT_TRUE(messages().sentence().startsWith(QStringLiteral("Body only may be wrong here")))
      << messages().sentence().toStdString();
  bodyOnly.trigger();
  EXPECT_EQ(scene().keep, Region{});
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
}

} // namespace
} // namespace limn
