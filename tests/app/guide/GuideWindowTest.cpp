// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuideWindow.h"
#include "app/WindowHarness.h"
#include "app/frame/dialogs/DialogController.h"
#include "app/frame/dialogs/MouseAndKeys.h"
#include "documentation/Matches.h"
#include "documentation/Tree.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/properties/PropertiesPanel.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTabBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

#include <algorithm>
#include <set>

// The guide in its window, and what it says of the program's own window.

namespace limn {
namespace {

// The documents that speak of the window.
std::vector<test::TextFile> documents() {
  std::vector<test::TextFile> found;
  for (test::TextFile& document : test::filesEnding({".md"}))
    if (document.path.string().starts_with("app/guide/") || document.path == "README.md" ||
        document.path == "CHANGELOG.md")
      found.push_back(std::move(document));
  return found;
}

QString plain(QString text) {
  text = text.section(QLatin1Char('\t'), 0, 0);
  return text.remove(QLatin1Char('&')).remove(QChar(0x2026)).simplified();
}

void addPaths(const QMenu& menu, const QString& above, std::set<QString>& paths) {
  for (const QAction* action : menu.actions()) {
    const QString path = above + QStringLiteral(" ▸ ") + plain(action->text());
    paths.insert(path);
    if (action->menu())
      addPaths(*action->menu(), path, paths);
  }
}

class GuideWindowTest : public test::WindowHarness {
protected:
  // Keys are those of the active window.
  static void activate(QWidget& wanted) {
    ASSERT_TRUE(test::waitUntilExposed(wanted));
    ASSERT_TRUE(test::waitUntil([&] {
      if (!wanted.isActiveWindow())
        wanted.activateWindow();
      return wanted.isActiveWindow();
    }));
  }

  GuideWindow& guide() {
    activate(*window);
    QTest::keyClick(window.get(), Qt::Key_F1);
    auto& shown = *window->findChild<GuideWindow*>();
    activate(shown);
    return shown;
  }

  QString headingShown(const GuideWindow& of) const {
    return of.page().headings()[of.page().headingAtTop()].anchor;
  }
};

TEST_F(GuideWindowTest, opensAtThePanelWithTheKeyboard) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  curves().valueEditor()->canvas()->setFocus();
  GuideWindow& shown = guide();
  EXPECT_EQ(headingShown(shown), QStringLiteral("panels.transfer-function"));
  EXPECT_FALSE(shown.isModal());
  shown.close();
  view().setFocus();
  EXPECT_EQ(headingShown(guide()), QStringLiteral("panels.picture"));
  EXPECT_EQ(window->findChildren<GuideWindow*>().size(), 1);
}

TEST_F(GuideWindowTest, opensAtThePanelWhoseTabWasClicked) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  const auto clickTab = [this](const QString& title, int beside) { // elsewhere: no double click
    for (QTabBar* tabs : window->findChildren<QTabBar*>())
      for (int i = 0; i < tabs->count(); ++i)
        if (tabs->tabText(i) == title)
          QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                            tabs->mapTo(window.get(), tabs->tabRect(i).center() + QPoint(beside, 0)));
    QCoreApplication::processEvents();
  };
  int clicks = 0;
  for (const auto& [title, place] : {std::pair("Effects", "panels.effects"),
                                     {"Accuracy", "panels.accuracy"},
                                     {"Properties", "panels.properties"},
                                     {"History", "panels.history"},
                                     {"Presets", "panels.presets"},
                                     {"Presets", "panels.presets"}}) {
    activate(*window);
    view().setFocus();
    clickTab(QLatin1String(title), 12 * (clicks++ % 2));
    EXPECT_EQ(guidePlaceOf(window->focusWidget()), QLatin1String(place)) << title;
    EXPECT_EQ(headingShown(guide()), QLatin1String(place)) << title;
  }
}

TEST_F(GuideWindowTest, hasAPlaceForEveryPanel) {
  std::set<QString> places;
  for (const GuideHeading& heading : guide().page().headings())
    places.insert(heading.anchor);
  EXPECT_TRUE(places.contains(guidePlaceOf(nullptr)));
  for (const QDockWidget* dock : window->findChildren<QDockWidget*>()) {
    const QString place = guidePlaceOf(dock->widget());
    EXPECT_TRUE(place.startsWith(QStringLiteral("panels."))) << dock->objectName().toStdString();
    EXPECT_TRUE(places.contains(place)) << place.toStdString();
  }
  EXPECT_TRUE(places.contains(guidePlaceOf(&view())));
}

TEST_F(GuideWindowTest, namesEverySectionOfTheProperties) {
  const QString chapter = QString::fromStdString(test::fileAt("app/guide/panels.md").text);
  const auto sections = window->findChild<PropertiesPanel*>()->findChildren<FoldingHeader*>();
  EXPECT_GT(sections.size(), 5);
  for (const FoldingHeader* section : sections)
    EXPECT_TRUE(chapter.contains(QStringLiteral("\n| %1 |").arg(section->accessibleName())))
        << section->accessibleName().toStdString();
}

TEST_F(GuideWindowTest, findsEveryPlaceByKeysAlone) {
  GuideWindow& shown = guide();
  auto* search = shown.findChild<QLineEdit*>(QStringLiteral("guideSearch"));
  auto* found = shown.findChild<QLabel*>(QStringLiteral("guideFound"));
  QTest::keyClick(&shown, Qt::Key_F, Qt::ControlModifier);
  EXPECT_EQ(shown.focusWidget(), search);
  QTest::keyClicks(search, QStringLiteral("crosshair"));
  const QString text = shown.page().toPlainText();
  const int hits = static_cast<int>(text.count(QStringLiteral("crosshair"), Qt::CaseInsensitive));
  ASSERT_GT(hits, 3);
  EXPECT_EQ(found->text(), QStringLiteral("1 of %1").arg(hits));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(found->text(), QStringLiteral("2 of %1").arg(hits));
  QTest::keyClick(search, Qt::Key_Return, Qt::ShiftModifier);
  QTest::keyClick(&shown, Qt::Key_F3, Qt::ShiftModifier);
  EXPECT_EQ(found->text(), QStringLiteral("%1 of %1").arg(hits)) << "around the end";
  EXPECT_GT(shown.page().verticalScrollBar()->value(), 0);
  EXPECT_EQ(shown.page().extraSelections().size(), hits);
  // Words that stand apart, in a paragraph and in the headings above it; questions, and other names of
  // things.
  for (const char* words : {"rename measurement", "hide label", "only one label", "why is my picture grey",
                            "gradient-enhanced", "film"}) {
    search->setText(QLatin1String(words));
    EXPECT_TRUE(found->text().contains(QStringLiteral(" of "))) << words; // from what is seen on
    EXPECT_FALSE(shown.page().extraSelections().isEmpty()) << words;
  }
  search->setText(QStringLiteral("unheard of"));
  EXPECT_EQ(found->text(), QStringLiteral("not found"));
  QTest::keyClick(&shown, Qt::Key_Escape);
  EXPECT_TRUE(shown.isVisible() && search->text().isEmpty());
  QTest::keyClick(&shown, Qt::Key_Escape);
  EXPECT_FALSE(shown.isVisible());
}

TEST_F(GuideWindowTest, goesFromItsContentsToTheChapterAndBack) {
  GuideWindow& shown = guide();
  auto* contents = shown.findChild<QTreeWidget*>();
  contents->setCurrentItem(contents->topLevelItem(contents->topLevelItemCount() - 2));
  EXPECT_EQ(headingShown(shown), QStringLiteral("limits"));
  shown.showPlace(QStringLiteral("gestures"));
  EXPECT_EQ(contents->currentItem()->text(0), QStringLiteral("Mouse and keys"));
}

TEST_F(GuideWindowTest, goesBackToWhereALinkWasFollowed) {
  GuideWindow& shown = guide();
  auto* back = shown.findChild<QToolButton*>(QStringLiteral("guideBack"));
  auto& page = const_cast<GuideView&>(shown.page()); // to follow links
  shown.showPlace(QStringLiteral("limits"));
  const int left = page.verticalScrollBar()->value();
  EXPECT_FALSE(back->isEnabled());
  emit page.anchorClicked(QUrl(QStringLiteral("#gestures")));
  EXPECT_EQ(headingShown(shown), QStringLiteral("gestures"));
  emit page.anchorClicked(QUrl(QStringLiteral("#privacy")));
  QTest::keyClick(&shown, Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(headingShown(shown), QStringLiteral("gestures"));
  EXPECT_TRUE(back->isEnabled());
  QTest::mouseClick(back, Qt::LeftButton);
  EXPECT_EQ(page.verticalScrollBar()->value(), left);
  EXPECT_FALSE(back->isEnabled());
}

TEST_F(GuideWindowTest, noPictureIsWiderThanThePage) {
  GuideWindow& shown = guide();
  for (const int width : {700, 1200}) {
    shown.resize(width, 600);
    ASSERT_TRUE(test::waitUntil([&] { return shown.width() == width; }));
    EXPECT_TRUE(test::waitUntil([&] { return shown.page().horizontalScrollBar()->maximum() == 0; })) << width;
  }
}

TEST_F(GuideWindowTest, neverScrollsSideways) {
  GuideWindow& shown = guide();
  const GuideView& page = shown.page();
  for (const int width : {800, 700, 741, 778, 815, 926, 1000}) {
    shown.resize(width, 560);
    ASSERT_TRUE(test::waitUntil([&] { return shown.width() == width; }));
    QCoreApplication::processEvents(); // lays its pictures out
    EXPECT_LE(page.document()->size().width(), page.viewport()->width()) << width;
    EXPECT_EQ(page.horizontalScrollBar()->maximum(), 0) << width;
  }
}

TEST_F(GuideWindowTest, everyMenuPathThatDocumentsNameExists) {
  std::set<QString> paths;
  for (const QAction* action : window->menuBar()->actions())
    addPaths(*action->menu(), plain(action->text()), paths);
  static const std::regex named("[`*]([A-Z][a-z]+ ▸ [^`*]+)[`*]");
  int count = 0;
  for (const test::TextFile& document : documents())
    test::forEachMatch(document.text, named, [&](const std::smatch& match) {
      ++count;
      EXPECT_TRUE(paths.contains(plain(QString::fromStdString(match[1]))))
          << document.path << ": " << match[1];
    });
  EXPECT_GT(count, 20);
}

// Keys of menus, and those that the list of gestures has.
TEST_F(GuideWindowTest, everyKeyThatDocumentsNameExists) {
  const ActionList& actions = *window->findChild<ActionList*>();
  QString known;
  for (const QAction* action : actions.all())
    for (const QKeySequence& key : action->shortcuts())
      known += key.toString(QKeySequence::PortableText) + QLatin1Char('\n');
  const HelpRows rows = helpRows(actions);
  for (const QList<HelpRow>& group : {rows.picture, rows.slices, rows.curve, rows.menus})
    for (const HelpRow& row : group)
      known += row.gesture + QLatin1Char('\n') + row.effect + QLatin1Char('\n');
  static const std::regex named(
      R"((?:^|[^\w+`])((?:(?:Ctrl|Shift|Alt)\+)+[A-Za-z0-9]+|F[1-9][0-2]?)(?![\w+]))");
  int count = 0;
  for (const test::TextFile& document : documents())
    test::forEachMatch(document.text, named, [&](const std::smatch& match) {
      ++count;
      EXPECT_TRUE(known.contains(QString::fromStdString(match[1]), Qt::CaseInsensitive))
          << document.path << ": " << match[1];
    });
  EXPECT_GT(count, 20);
}

TEST_F(GuideWindowTest, theListOfKeysSaysHowSeveralPointsAreSelected) {
  const QList<HelpRow> rows = helpRows(*window->findChild<ActionList*>()).curve;
  EXPECT_TRUE(std::ranges::any_of(rows, [](const HelpRow& row) {
    return row.gesture.startsWith(QStringLiteral("Ctrl+click points")) &&
           row.effect.startsWith(QStringLiteral("select several"));
  }));
}

// The chapter is read on the forge, too, so it is written out; this says what is missing from it.
TEST_F(GuideWindowTest, theChapterOnGesturesHasTheRowsOfTheProgramsOwnList) {
  const HelpRows rows = helpRows(*window->findChild<ActionList*>());
  QString expected;
  for (const QList<HelpRow>& group : {rows.picture, rows.slices, rows.curve, rows.menus})
    for (const HelpRow& row : group)
      if (row.gesture.isEmpty())
        expected += QStringLiteral("\n## %1\n| | |\n|---|---|\n").arg(row.effect);
      else
        expected += QStringLiteral("| %1 | %2 |\n").arg(row.gesture, row.effect);
  const QString chapter = QString::fromStdString(test::fileAt("app/guide/gestures.md").text);
  EXPECT_TRUE(chapter.endsWith(expected)) << "It should end in:\n" << expected.toStdString();
}

} // namespace
} // namespace limn
