// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetBrowser.h"
#include "widgets/FindWidget.h"
#include "widgets/PresetNames.h"
#include "widgets/WidgetSamples.h"
#include "widgets/presets/PresetFilter.h"
#include "widgets/presets/PresetModel.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

namespace limn {
namespace {

class PresetBrowserTest : public testing::Test {
protected:
  PresetBrowserTest() {
    m_browser.resize(240, 600);
    Preset own = samplePresets()[1];
    own.name = "My temporal bone";
    m_browser.setPresets(samplePresets(), {own});
    m_browser.show();
    QObject::connect(&m_browser, &PresetBrowser::presetChosen, &m_browser, [this](const QString& name) {
      m_chosen << name;
      if (m_takesEffect)
        m_browser.setCurrent(name);
    });
    QObject::connect(&m_browser, &PresetBrowser::deleteRequested, &m_browser,
                     [this](const QString& name) { m_deleted << name; });
  }

  QTreeView* list() const { return m_browser.findChild<QTreeView*>(); }
  QLineEdit* search() const { return m_browser.findChild<QLineEdit*>(); }

  void click(const QString& name) {
    const auto* model = list()->model();
    const QModelIndexList found =
        model->match(model->index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly | Qt::MatchRecursive);
    ASSERT_EQ(found.size(), 1);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(found.front()).center());
  }

  PresetBrowser m_browser;
  QString marked() const { return shownPreset(m_browser); }

  QList<QAction*> menuActions() const {
    QList<QAction*> actions;
    if (const auto* menu = m_browser.findChild<QMenu*>())
      for (QAction* action : menu->actions())
        if (!action->isSeparator())
          actions << action;
    return actions;
  }
  QStringList menuTexts() const {
    QStringList texts;
    for (const QAction* action : menuActions())
      texts << action->text();
    return texts;
  }
  void trigger(const char* text) {
    for (QAction* action : menuActions())
      if (action->text() == QLatin1String(text))
        return action->trigger();
    FAIL() << text;
  }

  bool m_takesEffect = true; ///< whether a choice changes the picture, as it does while one is shown
  QStringList m_chosen;
  QStringList m_deleted;
};

TEST_F(PresetBrowserTest, listsOwnPresetsFirstThenModalities) {
  EXPECT_EQ(presetNames(m_browser),
            (QStringList{"My temporal bone", "CT skin and bone", "CT bone", "CT lung", "MR head"}));
  EXPECT_TRUE(m_chosen.empty());
}

TEST_F(PresetBrowserTest, aClickChooses) {
  click(QStringLiteral("CT lung"));
  EXPECT_EQ(m_chosen, QStringList{"CT lung"});
}

TEST_F(PresetBrowserTest, marksOnlyWhatTookEffect) {
  click(QStringLiteral("CT lung"));
  EXPECT_EQ(marked(), QStringLiteral("CT lung"));
  m_takesEffect = false;
  click(QStringLiteral("CT bone"));
  EXPECT_EQ(m_chosen, (QStringList{"CT lung", "CT bone"}));
  EXPECT_EQ(marked(), QStringLiteral("CT lung"));
  m_browser.setCurrent({}); // an edit left the preset
  EXPECT_EQ(marked(), QString());
  click(QStringLiteral("CT bone"));
  EXPECT_EQ(marked(), QString());
}

TEST_F(PresetBrowserTest, theFrameStaysWithThePresetShownWhereverTheKeyboardGoes) {
  click(QStringLiteral("CT bone"));
  ASSERT_EQ(marked(), QStringLiteral("CT bone"));
  QTest::keyClick(list(), Qt::Key_Down);
  EXPECT_EQ(list()->currentIndex().data().toString(), QStringLiteral("CT lung"));
  EXPECT_EQ(marked(), QStringLiteral("CT bone"));
  QTest::keyClick(list(), Qt::Key_Return);
  EXPECT_EQ(marked(), QStringLiteral("CT lung"));
}

TEST_F(PresetBrowserTest, aPresetThatWasChangedSaysSoUntilTheSearchAndBeyond) {
  m_browser.setCurrent(QStringLiteral("CT lung"), true);
  EXPECT_EQ(marked(), QStringLiteral("CT lung*"));
  QTest::keyClicks(search(), QStringLiteral("lung"));
  EXPECT_EQ(marked(), QStringLiteral("CT lung*"));
  m_browser.setCurrent(QStringLiteral("CT lung"));
  EXPECT_EQ(marked(), QStringLiteral("CT lung"));
}

TEST_F(PresetBrowserTest, aRightClickSelectsNothingAndOpensAMenu) {
  click(QStringLiteral("CT bone"));
  const QPoint lung = rowOf(m_browser, QStringLiteral("CT lung")).center();
  QTest::mouseClick(list()->viewport(), Qt::RightButton, {}, lung);
  QContextMenuEvent asked(QContextMenuEvent::Mouse, lung, list()->viewport()->mapToGlobal(lung));
  QCoreApplication::sendEvent(list()->viewport(), &asked);
  EXPECT_EQ(list()->currentIndex().data().toString(), QStringLiteral("CT bone"));
  EXPECT_EQ(marked(), QStringLiteral("CT bone"));
  EXPECT_EQ(m_chosen.size(), 1);
  EXPECT_EQ(menuTexts(), (QStringList{"Use", "Duplicate…", "Copy name"})) << "built-in ones stay as they are";
  trigger("Use");
  EXPECT_EQ(marked(), QStringLiteral("CT lung"));
}

TEST_F(PresetBrowserTest, theMenuOfTheKeyboardIsAboutTheRowInHand) {
  click(QStringLiteral("My temporal bone"));
  m_browser.setCurrent(QStringLiteral("My temporal bone"), true);
  QContextMenuEvent asked(QContextMenuEvent::Keyboard, {}, {});
  QCoreApplication::sendEvent(list(), &asked);
  EXPECT_EQ(menuTexts(),
            (QStringList{"Reset to this preset", "Duplicate…", "Rename…", "Delete", "Copy name"}));
  trigger("Reset to this preset");
  EXPECT_EQ(marked(), QStringLiteral("My temporal bone"));
}

TEST_F(PresetBrowserTest, aClickOnAGroupChoosesNothing) {
  click(QStringLiteral("MR"));
  EXPECT_TRUE(m_chosen.empty());
}

TEST_F(PresetBrowserTest, searchFindsWordsInAnyOrderInNameModalityAndNote) {
  m_browser.focusSearch();
  QTest::keyClicks(search(), QStringLiteral("bone ct"));
  EXPECT_EQ(presetNames(m_browser), (QStringList{"CT skin and bone", "CT bone", "My temporal bone"}));
  search()->selectAll();
  QTest::keyClicks(search(), QStringLiteral("brain"));
  EXPECT_EQ(presetNames(m_browser), QStringList{"MR head"});
  QTest::keyClick(search(), Qt::Key_Return);
  EXPECT_EQ(m_chosen, QStringList{"MR head"});
  QTest::keyClick(search(), Qt::Key_Escape);
  EXPECT_EQ(presetNames(m_browser).size(), 5);
}

TEST_F(PresetBrowserTest, whatTheNameSaysComesBeforeWhatTheNoteSays) {
  EXPECT_EQ(presetHit(QStringLiteral("CT bone"), {"bone"}), PresetHit::isName);
  EXPECT_EQ(presetHit(QStringLiteral("CT bone and veil"), {"Bone"}), PresetHit::nameBegins);
  EXPECT_EQ(presetHit(QStringLiteral("CT skin and bone"), {"bone"}), PresetHit::wordBegins);
  EXPECT_EQ(presetHit(QStringLiteral("CT skin and bone"), {"one"}), PresetHit::inName);
  EXPECT_EQ(presetHit(QStringLiteral("CT lung"), {"bone"}), PresetHit::elsewhere);
  const QStringList inOrder = presetNames(m_browser);
  m_browser.focusSearch();
  QTest::keyClicks(search(), QStringLiteral("bone"));
  EXPECT_EQ(presetNames(m_browser).front(), QStringLiteral("CT bone"));
  QTest::keyClick(search(), Qt::Key_Return);
  EXPECT_EQ(m_chosen, QStringList{"CT bone"});
  QTest::keyClick(search(), Qt::Key_Escape);
  EXPECT_EQ(presetNames(m_browser), inOrder) << "without a search they stand as they did";
}

TEST_F(PresetBrowserTest, searchTakesSignsLiterally) {
  QTest::keyClicks(search(), QStringLiteral("(.*"));
  EXPECT_TRUE(presetNames(m_browser).isEmpty());
}

TEST_F(PresetBrowserTest, arrowsAndEnterChooseFromTheSearchField) {
  QTest::keyClicks(search(), QStringLiteral("ct"));
  QTest::keyClick(search(), Qt::Key_Down);
  QTest::keyClick(list(), Qt::Key_Return);
  EXPECT_EQ(m_chosen, QStringList{"CT skin and bone"});
}

TEST_F(PresetBrowserTest, onlyOwnPresetsCanBeDeleted) {
  auto* deletion = widgetNamed<QToolButton>(m_browser, "Delete preset");
  ASSERT_NE(deletion, nullptr);
  click(QStringLiteral("CT bone"));
  EXPECT_FALSE(deletion->isEnabled());
  QTest::keyClick(list(), Qt::Key_Delete);
  EXPECT_TRUE(m_deleted.empty());
  click(QStringLiteral("My temporal bone"));
  EXPECT_TRUE(deletion->isEnabled());
  QTest::mouseClick(deletion, Qt::LeftButton);
  EXPECT_EQ(m_deleted, QStringList{"My temporal bone"});
}

TEST_F(PresetBrowserTest, savingIsAskedFor) {
  int asked = 0;
  QObject::connect(&m_browser, &PresetBrowser::saveRequested, &m_browser, [&] { ++asked; });
  QTest::mouseClick(m_browser.findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_EQ(asked, 1);
}

// Two lines at least; with room for six higher rows a note is told whole.
TEST_F(PresetBrowserTest, aNoteTakesMoreLinesWhereTheListIsHigh) {
  std::vector<Preset> presets = samplePresets();
  presets[0].note = "Everything brighter than the background as one closed surface; fitted to each series";
  m_browser.setPresets(presets, {});
  const auto heightOf = [&](int height) {
    m_browser.resize(230, height);
    for (int round = 0; round < 3; ++round)
      QCoreApplication::processEvents();
    return rowOf(m_browser, QString::fromStdString(presets[0].name)).height();
  };
  const int low = heightOf(300);
  EXPECT_GT(heightOf(900), low);
  EXPECT_EQ(heightOf(300), low);
}

TEST_F(PresetBrowserTest, noLineOfTextIsCutByTheEdgeOfTheList) {
  const int ink = qGray(m_browser.palette().text().color().rgb());
  int letters = 0;                                 // pixels of them in the last row of the list
  for (int height = 300; height < 360; ++height) { // the edge wanders over a row and more
    m_browser.resize(230, height);
    for (int round = 0; round < 3; ++round)
      QCoreApplication::processEvents();
    const QImage seen = list()->viewport()->grab().toImage();
    for (int x = 12 + thumbnailWidth + 12; x < seen.width() - 12; ++x)
      letters += std::abs(qGray(seen.pixel(x, seen.height() - 1)) - ink) < 40;
  }
  EXPECT_EQ(letters, 0);
}

TEST(CurveThumbnail, showsTheFunctionsColours) {
  const TransferFunction red{1.0, {{0.0, {1, 0, 0}, 0.5}, {100.0, {1, 0, 0}, 0.5}}};
  const QImage image = curveThumbnail(red, {56, 40}, 1.0, Look::dark);
  EXPECT_EQ(image.pixelColor(28, 38), QColor(Qt::red)); // the strip of colours at the bottom
}

} // namespace
} // namespace limn
