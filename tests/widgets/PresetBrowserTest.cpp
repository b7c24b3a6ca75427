// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetBrowser.h"
#include "support/JudgedTime.h"
#include "support/Waiting.h"
#include "widgets/FindWidget.h"
#include "widgets/PresetNames.h"
#include "widgets/WidgetSamples.h"
#include "widgets/presets/PresetFilter.h"
#include "widgets/presets/PresetModel.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QImage>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
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
    QObject::connect(&m_browser, &PresetBrowser::previewRequested, &m_browser,
                     [this](const QString& name) { m_previewed << name; });
  }

  // Its last words would reach what is gone by then.
  ~PresetBrowserTest() override { m_browser.disconnect(); }

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
  QStringList m_previewed; ///< empty: no more
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

TEST_F(PresetBrowserTest, thePointerAtRestAsksForAPreviewUntilItLeaves) {
  const auto pointTo = [this](const char* name) {
    QTest::mouseMove(list()->viewport(), rowOf(m_browser, QLatin1String(name)).center());
  };
  pointTo("CT bone");
  pointTo("CT lung"); // before the pointer has rested
  ASSERT_TRUE(test::waitUntil([this] { return !m_previewed.empty(); }));
  EXPECT_EQ(m_previewed, QStringList{"CT lung"});
  pointTo("MR"); // a group
  ASSERT_TRUE(test::waitUntil([this] { return m_previewed.size() == 2; }));
  EXPECT_EQ(m_previewed.back(), QString());
  pointTo("CT bone");
  ASSERT_TRUE(test::waitUntil([this] { return m_previewed.size() == 3; }));
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(list()->viewport(), &leave);
  EXPECT_EQ(m_previewed, (QStringList{"CT lung", "", "CT bone", ""}));
  EXPECT_TRUE(m_chosen.empty());
}

TEST_F(PresetBrowserTest, theKeyboardAsksForPreviewsUntilEscOrItLeaves) {
  click(QStringLiteral("CT bone"));
  list()->setFocus();
  QTest::keyClick(list(), Qt::Key_Down);
  ASSERT_TRUE(test::waitUntil([this] { return !m_previewed.empty(); }));
  EXPECT_EQ(m_previewed, QStringList{"CT lung"});
  QTest::keyClick(list(), Qt::Key_Escape);
  EXPECT_EQ(m_previewed, (QStringList{"CT lung", ""}));
  QTest::keyClick(list(), Qt::Key_Up);
  ASSERT_TRUE(test::waitUntil([this] { return m_previewed.size() == 3; }));
  QFocusEvent out(QEvent::FocusOut, Qt::TabFocusReason);
  QCoreApplication::sendEvent(list(), &out);
  EXPECT_EQ(m_previewed, (QStringList{"CT lung", "", "CT bone", ""}));
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

TEST_F(PresetBrowserTest, theHitThatEnterUsesIsMarked) {
  const auto hits = [this] {
    return list()->model()->match(list()->model()->index(0, 0), presetRole::isBestHit, true, -1,
                                  Qt::MatchExactly | Qt::MatchRecursive);
  };
  EXPECT_TRUE(hits().isEmpty());
  QTest::keyClicks(search(), QStringLiteral("lung"));
  ASSERT_EQ(hits().size(), 1);
  const QString hit = hits().front().data().toString();
  QTest::keyClick(search(), Qt::Key_Return);
  EXPECT_EQ(marked(), hit);
  search()->clear();
  EXPECT_TRUE(hits().isEmpty());
}

TEST_F(PresetBrowserTest, undoIsTheProgramsWhereNothingIsLookedFor) {
  const auto takesUndo = [this] {
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    undo.ignore();
    QCoreApplication::sendEvent(search(), &undo);
    return undo.isAccepted();
  };
  EXPECT_FALSE(takesUndo());
  QTest::keyClicks(search(), QStringLiteral("bone"));
  EXPECT_TRUE(takesUndo());
  search()->clear();
  EXPECT_FALSE(takesUndo());
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
  EXPECT_EQ(menuTexts(), (QStringList{"Use", "Compare with the picture", "Add to favourites", "Duplicate…",
                                      "Export…", "Copy name"}))
      << "built-in ones stay as they are";
  trigger("Use");
  EXPECT_EQ(marked(), QStringLiteral("CT lung"));
}

TEST_F(PresetBrowserTest, theMenuOfTheKeyboardIsAboutTheRowInHand) {
  click(QStringLiteral("My temporal bone"));
  m_browser.setCurrent(QStringLiteral("My temporal bone"), true);
  QContextMenuEvent asked(QContextMenuEvent::Keyboard, {}, {});
  QCoreApplication::sendEvent(list(), &asked);
  EXPECT_EQ(menuTexts(), (QStringList{"Reset to this preset", "Compare with the picture", "Add to favourites",
                                      "Duplicate…", "Export…", "Rename…", "Note…", "Move to folder", "Delete",
                                      "Copy name"}));
  trigger("Reset to this preset");
  EXPECT_EQ(marked(), QStringLiteral("My temporal bone"));
}

TEST_F(PresetBrowserTest, fMakesAFavouriteAndF2RenamesOneOfTheUsersOwn) {
  QSignalSpy favourite(&m_browser, &PresetBrowser::favouriteRequested);
  QSignalSpy rename(&m_browser, &PresetBrowser::renameRequested);
  click(QStringLiteral("CT bone"));
  QTest::keyClick(list(), Qt::Key_F);
  QTest::keyClick(list(), Qt::Key_F2);
  ASSERT_EQ(favourite.size(), 1);
  EXPECT_EQ(favourite.front(), (QVariantList{QStringLiteral("CT bone"), true}));
  EXPECT_TRUE(rename.isEmpty()) << "a built-in one";
  m_browser.setStanding({{"CT bone"}, std::nullopt});
  EXPECT_EQ(presetNames(m_browser).front(), QStringLiteral("CT bone"));
  EXPECT_EQ(marked(), QStringLiteral("CT bone"));
  QTest::keyClick(list(), Qt::Key_F);
  EXPECT_EQ(favourite.back(), (QVariantList{QStringLiteral("CT bone"), false}));
  click(QStringLiteral("My temporal bone"));
  QTest::keyClick(list(), Qt::Key_F2);
  ASSERT_EQ(rename.size(), 1);
  EXPECT_EQ(rename.front(), QVariantList{QStringLiteral("My temporal bone")});
}

TEST_F(PresetBrowserTest, fourHundredPresetsAreListedAndFound) {
  std::vector<Preset> many;
  for (int i = 0; i < 400; ++i) {
    many.push_back(samplePresets()[0]);
    many.back().name = "Mine " + std::to_string(1000 + i);
    many.back().folder = "Folder " + std::to_string(i % 7);
  }
  const double before = test::threadMs();
  m_browser.setPresets(samplePresets(), many);
  test::judgeMs("listing 400 presets", test::threadMs() - before, 100.0);
  EXPECT_EQ(presetNames(m_browser).size(), 400 + static_cast<int>(samplePresets().size()));
  QTest::keyClicks(search(), QStringLiteral("folder 3 1003"));
  EXPECT_EQ(presetNames(m_browser), QStringList{"Mine 1003"});
}

TEST_F(PresetBrowserTest, theGalleryHasTheSameOrderAndDoesWhatTheListDoes) {
  QSignalSpy chosen(&m_browser, &PresetBrowser::galleryChosen);
  QTest::mouseClick(widgetNamed<QToolButton>(m_browser, "Large pictures"), Qt::LeftButton);
  EXPECT_EQ(chosen.front(), QVariantList{true});
  QListView& gallery = *m_browser.findChild<QListView*>();
  ASSERT_TRUE(gallery.isVisible());
  const auto names = [&] {
    QStringList shown;
    for (int row = 0; row < gallery.model()->rowCount(); ++row)
      shown << gallery.model()->index(row, 0).data().toString();
    return shown;
  };
  EXPECT_EQ(names(), m_browser.presets());
  const auto place = [&](int row) { return gallery.visualRect(gallery.model()->index(row, 0)); };
  ASSERT_TRUE(test::waitUntil([&] { return place(1).top() == place(0).top(); })) << "two beside each other";
  const auto clickTile = [&](int row) {
    QTest::mouseClick(gallery.viewport(), Qt::LeftButton, {}, place(row).center());
  };
  clickTile(2);
  EXPECT_EQ(m_chosen, QStringList{names()[2]});
  EXPECT_EQ(marked(), names()[2]);
  QTest::keyClick(&gallery, Qt::Key_Right);
  ASSERT_TRUE(test::waitUntil([this] { return !m_previewed.empty(); }));
  EXPECT_EQ(m_previewed.back(), names()[3]);
  QTest::keyClick(&gallery, Qt::Key_Return);
  EXPECT_EQ(m_chosen.back(), names()[3]);
  QTest::keyClicks(search(), QStringLiteral("lung"));
  EXPECT_EQ(names(), QStringList{"CT lung"});
  QTest::keyClick(search(), Qt::Key_Down);
  EXPECT_EQ(gallery.currentIndex().data().toString(), QStringLiteral("CT lung"));
}

TEST_F(PresetBrowserTest, whatWasMadeIsShownThoughASearchWouldHideIt) {
  QTest::keyClicks(search(), QStringLiteral("temporal"));
  m_browser.reveal(QStringLiteral("My temporal bone"));
  EXPECT_EQ(presetNames(m_browser), QStringList{"My temporal bone"})
      << "the search goes on where it finds it";
  search()->selectAll();
  QTest::keyClicks(search(), QStringLiteral("lung"));
  m_browser.reveal(QStringLiteral("My temporal bone"));
  EXPECT_TRUE(search()->text().isEmpty());
  EXPECT_TRUE(presetNames(m_browser).contains(QStringLiteral("My temporal bone")));
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

// "skin" on an MR head: one for CT could not show it, whatever it is called.
TEST_F(PresetBrowserTest, aSearchHasFirstWhatSuitsTheVolume) {
  Preset ct = samplePresets()[1], mr = ct, any = ct;
  ct.name = "CT skin";
  ct.modality = "CT";
  mr.name = "MR head";
  mr.modality = "MR";
  mr.note = "The skin of a head";
  any.name = "Surface";
  any.modality = "";
  any.note = "Skin or what is outermost";
  m_browser.setPresets({ct, mr, any}, {});
  search()->setText(QStringLiteral("skin"));
  EXPECT_EQ(presetNames(m_browser).front(), QStringLiteral("CT skin")) << "without a volume by the name";
  PresetStanding standing;
  standing.fit = {"MR", "", false};
  m_browser.setStanding(standing);
  EXPECT_EQ(presetNames(m_browser), (QStringList{"MR head", "Surface", "CT skin"}));
  QTest::keyClick(search(), Qt::Key_Return);
  EXPECT_EQ(m_chosen, QStringList{"MR head"});
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

// What a narrow list cuts, the tool tip has whole.
TEST_F(PresetBrowserTest, theToolTipHasTheWholeNameAndNote) {
  std::vector<Preset> presets = samplePresets();
  presets[0].note = "Everything brighter than the background as one closed surface; fitted to each series";
  m_browser.setPresets({presets[0]}, {});
  m_browser.resize(200, 300);
  const QAbstractItemModel& shown = *list()->model();
  const QModelIndex row = shown.index(0, 0, shown.index(0, 0));
  const QString tip = row.data(Qt::ToolTipRole).toString();
  EXPECT_TRUE(tip.contains(QString::fromStdString(presets[0].name))) << tip.toStdString();
  EXPECT_TRUE(tip.contains(QString::fromStdString(presets[0].note))) << tip.toStdString();
}

// Its note has several lines: a name need not be cut after one.
TEST_F(PresetBrowserTest, aLongNameTakesASecondLine) {
  std::vector<Preset> presets = samplePresets();
  presets[1] = presets[0];
  presets[0].name = "MR brain";
  presets[1].name = "MR brain without its skull, of a child";
  presets[0].modality = presets[1].modality = "MR";
  m_browser.setPresets({presets[0], presets[1]}, {});
  m_browser.resize(230, 600);
  for (int round = 0; round < 3; ++round)
    QCoreApplication::processEvents();
  const auto heightOf = [&](int row) {
    return rowOf(m_browser, QString::fromStdString(presets[static_cast<std::size_t>(row)].name)).height();
  };
  EXPECT_GE(heightOf(1), heightOf(0) + m_browser.fontMetrics().height() / 2);
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
