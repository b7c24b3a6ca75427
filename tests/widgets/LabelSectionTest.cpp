// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/LabelSection.h"

#include "scene/LabelLooks.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/regions/LabelColor.h"
#include "scene/volume/Phantom.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/controls/NumberField.h"
#include "widgets/properties/LabelGroups.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace limn {
namespace {

Region labelled(std::vector<Label> labels) {
  std::vector<double> weights(labels.size(), 1.0);
  return {Region::Kind::labels, "seg.nrrd",
          std::make_shared<const LabelMap>(glm::ivec3(1), std::vector<std::uint8_t>{0}, std::move(labels)),
          std::move(weights)};
}

// The section with three labels, answered as the session answers.
class LabelSectionTest : public testing::Test {
protected:
  LabelSectionTest() {
    scene.volume = phantomVolume({12.0, 0.0, 1});
    scene.keep =
        labelled({{0, "Background", glm::dvec3(0.5)}, {3, "Liver", {1, 0, 0}}, {4, "Bone", {1, 1, 1}}});
    QObject::connect(&section, &LabelSection::keepEdited, &section,
                     [this](const Region& region, const Gesture& gesture) {
                       scene.keep = region;
                       texts.push_back(gesture.text);
                       gestures.insert(gesture.id);
                       section.setScene(scene);
                     });
    section.resize(320, 400);
    section.show();
    section.setScene(scene);
  }

  QTreeView& table() { return *section.findChild<QTreeView*>(); }
  QAbstractItemModel& model() { return *table().model(); }
  QVariant at(int row, int column, int role = Qt::DisplayRole) {
    return model().data(model().index(row, column), role);
  }
  // A click on the square of a row; the picker that it opens, null where it opens none.
  ColorPicker* clickSquare(int row) {
    const QModelIndex label = model().index(row, 0);
    const QImage swatch = label.data(Qt::DecorationRole).value<QPixmap>().toImage();
    const auto place = placeOfColor(*table().viewport(), table().visualRect(label),
                                    swatch.pixelColor(swatch.rect().center()));
    if (!place)
      return nullptr;
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, *place);
    return section.findChild<ColorPicker*>();
  }
  // What the key for menus opens at a row.
  QMenu* menuOf(const QModelIndex& row) {
    table().setFocus();
    table().setCurrentIndex(row);
    QContextMenuEvent key(QContextMenuEvent::Keyboard, {}, {});
    QCoreApplication::sendEvent(&table(), &key);
    return section.findChild<QMenu*>(QStringLiteral("labelMenu"));
  }
  static QAction& entry(const QMenu& menu, const char* text) {
    for (QAction* one : menu.actions())
      if (one->text() == QString::fromUtf8(text))
        return *one;
    throw std::runtime_error("no such entry");
  }
  // Chooses an entry of it, and whether it could be chosen.
  bool choose(const QModelIndex& row, const char* text) {
    QMenu* menu = menuOf(row);
    const bool isOffered = menu && entry(*menu, text).isEnabled();
    if (isOffered)
      entry(*menu, text).trigger();
    delete menu;
    return isOffered;
  }
  // Every label of `scene.keep` has a voxel from then on.
  void giveVoxels() {
    const std::vector<Label> labels = scene.keep.labels->labels();
    std::vector<std::uint8_t> places(labels.size());
    std::iota(places.begin(), places.end(), std::uint8_t{0});
    scene.keep.labels = std::make_shared<const LabelMap>(glm::ivec3(static_cast<int>(labels.size()), 1, 1),
                                                         std::move(places), labels);
    section.setScene(scene);
  }
  QPushButton& button(const QString& text) {
    for (QPushButton* one : section.findChildren<QPushButton*>())
      if (one->text() == text)
        return *one;
    throw std::runtime_error("no such button");
  }

  Scene scene;
  LabelSection section;
  std::vector<QString> texts;
  std::set<std::uint64_t> gestures;
};

TEST_F(LabelSectionTest, restingOnALabelTellsItsSizeAndValues) {
  EXPECT_FALSE(at(1, 0, Qt::ToolTipRole).toString().contains(QStringLiteral("ml")));
  section.setFigures({{}, {1234.6, 9, 61.0, 12.0, -20.0, 180.0}, {0.256, 0, 0.0, 0.0, 0.0, 0.0}},
                     scene.volume);
  const auto tip = [&](int row) {
    return at(row, 0, Qt::ToolTipRole).toString().replace(QChar(0xa0), QLatin1Char(' '));
  };
  EXPECT_TRUE(tip(1).contains(QStringLiteral("1235 ml · 61 ± 12 HU · −20 – 180 HU"))) << tip(1).toStdString();
  EXPECT_TRUE(tip(2).endsWith(QStringLiteral("0.26 ml"))) << "without valid voxels its size alone";
  section.setFigures({}, nullptr);
  EXPECT_FALSE(tip(1).contains(QStringLiteral("ml")));
}

TEST_F(LabelSectionTest, aLabelWithoutAVoxelIsDimAndSaysThatThereIsNothingToShow) {
  const QString nothing = QStringLiteral("It has no voxels of its own, so there is nothing to show");
  EXPECT_FALSE(at(0, 0, Qt::ToolTipRole).toString().contains(nothing));
  EXPECT_FALSE(at(0, 0, Qt::ForegroundRole).isValid());
  EXPECT_TRUE(at(1, 0, Qt::ToolTipRole).toString().contains(nothing));
  for (int column = 0; column < model().columnCount(); ++column)
    EXPECT_EQ(at(1, column, Qt::ForegroundRole).value<QBrush>().color(),
              QApplication::palette().color(QPalette::PlaceholderText));
}

TEST(LabelGroups, areLabelsWhoseNamesBeginWithTheSameWord) {
  const auto groups = [](const std::vector<const char*>& names) {
    std::vector<LabelKind> all;
    for (const char* name : names)
      all.push_back({QString::fromLatin1(name)});
    return groupsOf(all);
  };
  const auto one = [](int label) { return LabelGroup{{}, {label}}; };
  EXPECT_EQ(groups({"background", "rib_left_1", "liver", "Rib_right_1", "kidney_left", "rib_left_2",
                    "kidney_right"}),
            (std::vector<LabelGroup>{one(0), {QStringLiteral("rib"), {1, 3, 5}}, one(2), one(4), one(6)}))
      << "two kidneys are no group";
  EXPECT_EQ(groups({"Label 1", "Label 2", "Label 3"}), (std::vector<LabelGroup>{one(0), one(1), one(2)}))
      << "a word that all have tells nothing";
  EXPECT_TRUE(groups({}).empty());
}

// Types are told apart before names, and sorts join what is left.
TEST(LabelGroups, areLabelsOfWhichTheirFileSaysTheSame) {
  const auto kind = [](const char* name, const char* type, const char* category) {
    return LabelKind{QString::fromLatin1(name), QString::fromLatin1(type), QString::fromLatin1(category)};
  };
  const auto one = [](int label) { return LabelGroup{{}, {label}}; };
  std::vector<LabelKind> labels = {kind("Background", "", ""),
                                   kind("left 1", "Rib", "Anatomical Structure"),
                                   kind("lobe upper", "Upper lobe of lung", "Anatomical Structure"),
                                   kind("left 2", "rib", "Anatomical Structure"),
                                   kind("lobe lower", "Lower lobe of lung", "Anatomical Structure"),
                                   kind("lobe middle", "Middle lobe of lung", "Anatomical Structure"),
                                   kind("right 1", "Rib", "Anatomical Structure"),
                                   kind("tumour", "Neoplasm", "Morphologically Abnormal Structure"),
                                   kind("cyst", "Cyst", "Morphologically Abnormal Structure"),
                                   kind("oedema", "Edema", "Morphologically Abnormal Structure")};
  const std::vector<LabelGroup> expected = {
      one(0),
      {QStringLiteral("Rib"), {1, 3, 6}, false},
      {QStringLiteral("lobe"), {2, 4, 5}, true},
      {QStringLiteral("Morphologically Abnormal Structure"), {7, 8, 9}, false}};
  EXPECT_EQ(groupsOf(labels), expected);
  for (std::size_t n = 1; n < labels.size(); ++n)
    labels[n].type = labels[n].category = QStringLiteral("Tissue");
  EXPECT_EQ(groupsOf(labels)[2], (LabelGroup{QStringLiteral("lobe"), {2, 4, 5}}))
      << "what all share tells nothing, and a name is more";
  // A type and a category may have one name; they are two groups all the same.
  EXPECT_EQ(
      groupsOf({kind("a", "Bone", ""), kind("b", "Bone", ""), kind("c", "Bone", ""), kind("d", "", "Bone"),
                kind("e", "", "Bone"), kind("f", "", "Bone"), kind("g", "Fat", "Fat")}),
      (std::vector<LabelGroup>{
          {QStringLiteral("Bone"), {0, 1, 2}, false}, {QStringLiteral("Bone"), {3, 4, 5}, false}, one(6)}));
}

TEST_F(LabelSectionTest, theLabelsOfOneTypeAreAGroupInTheList) {
  std::vector<Label> labels{{0, "background", glm::dvec3(0.5)}};
  for (int n = 1; n <= 4; ++n)
    labels.push_back(
        {n, "piece" + std::to_string(n), glm::dvec3(0.9), n < 4 ? "Rib" : "Liver", "Anatomical Structure"});
  scene.keep = labelled(labels);
  section.setScene(scene);
  ASSERT_EQ(model().rowCount(), 3);
  EXPECT_EQ(model().index(1, 0).data().toString(), QStringLiteral("Rib (3)"));
  EXPECT_TRUE(model().index(1, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("\"Rib\"")));
  EXPECT_EQ(model().rowCount(model().index(1, 0)), 3);
}

TEST_F(LabelSectionTest, aGroupIsShownAndHiddenAtOnceAndOpensForASearch) {
  std::vector<Label> labels{{0, "background", glm::dvec3(0.5)}, {1, "liver", glm::dvec3(1.0)}};
  for (int n = 1; n <= 12; ++n)
    labels.push_back({n + 1, "rib_left_" + std::to_string(n), glm::dvec3(0.9)});
  scene.keep = labelled(labels);
  section.setScene(scene);
  ASSERT_EQ(model().rowCount(), 3);
  const QModelIndex ribs = model().index(2, 0);
  EXPECT_EQ(ribs.data().toString(), QStringLiteral("rib (12)"));
  EXPECT_EQ(model().rowCount(ribs), 12);
  EXPECT_FALSE(table().isExpanded(ribs)) << "a hundred labels are a dozen rows";
  const QRect cell = table().visualRect(ribs);
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, QPoint(cell.left() + 12, cell.center().y()));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts.back(), QStringLiteral("hide rib"));
  EXPECT_EQ(std::accumulate(scene.keep.weights.begin(), scene.keep.weights.end(), 0.0), 2.0);
  EXPECT_EQ(ribs.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
  const QModelIndex third = model().index(2, 0, ribs);
  EXPECT_TRUE(model().setData(third, Qt::Checked, Qt::CheckStateRole));
  EXPECT_EQ(scene.keep.weights[4], 1.0) << "the third rib";
  EXPECT_EQ(ribs.data(Qt::CheckStateRole).toInt(), Qt::PartiallyChecked);
  section.select(5);
  EXPECT_TRUE(table().isExpanded(ribs));
  EXPECT_EQ(table().currentIndex().data().toString(), QStringLiteral("rib_left_4"));
  table().collapseAll();
  auto* search = section.findChild<QLineEdit*>();
  ASSERT_TRUE(search->isVisibleTo(&section));
  search->setText(QStringLiteral("left_11"));
  ASSERT_EQ(model().rowCount(), 1) << "the group of what was found";
  ASSERT_EQ(model().rowCount(model().index(0, 0)), 1);
  EXPECT_TRUE(table().isExpanded(model().index(0, 0)));
}

TEST_F(LabelSectionTest, aLabelWithItsOwnCurveHasTheColourThatALegendGivesIt) {
  scene.keep = withLooks(scene.keep, {{0, {1.0, {{-5000.0, {0, 1, 0}, 0.5}, {5000.0, {0, 1, 0}, 0.5}}}}});
  section.setScene(scene);
  const QImage swatch = at(0, 0, Qt::DecorationRole).value<QPixmap>().toImage();
  const glm::dvec3 legend = shownColor(*scene.volume, scene.keep, 0);
  EXPECT_EQ(swatch.pixelColor(swatch.rect().center()), QColor(0, 255, 0));
  EXPECT_EQ(legend, glm::dvec3(0, 1, 0));
}

TEST_F(LabelSectionTest, aColourPickedAtItsSquareGivesALabelItsOwnCurveInThatColour) {
  scene.transferFunction = {2.0,
                            {{-100.0, {0, 0, 1}, 0.0}, {50.0, {0, 1, 0}, 0.25}, {300.0, {1, 1, 1}, 0.75}}};
  section.setScene(scene);
  std::vector<std::size_t> inHand;
  QObject::connect(&section, &LabelSection::curveRequested, &section,
                   [&](std::size_t place) { inHand.push_back(place); });
  ColorPicker* picker = clickSquare(1);
  ASSERT_NE(picker, nullptr);
  EXPECT_TRUE(texts.empty()) << "nothing was picked yet";
  EXPECT_EQ(scene.keep.weights, std::vector<double>(3, 1.0)) << "the mark is beside it";
  QTest::mouseClick(picker, Qt::LeftButton, {}, {1, 1});   // white: no saturation, full brightness
  QTest::mouseClick(picker, Qt::LeftButton, {}, {1, 139}); // black
  picker->window()->close();
  ASSERT_EQ(lookOfLabel(scene.keep, 1), 1u);
  EXPECT_EQ(lookOfLabel(scene.keep, 2), 0u);
  const TransferFunction black = scene.keep.looks[0];
  EXPECT_LT(black.points[2].color.r, 0.02);
  EXPECT_EQ(black, inOneColor(scene.transferFunction, black.points[0].color))
      << "the opacities of all tissue";
  EXPECT_EQ(texts.back(), QStringLiteral("colour of Liver"));
  EXPECT_EQ(gestures.size(), 1u) << "one step for all that was tried";
  EXPECT_EQ(inHand, std::vector<std::size_t>{1});
}

TEST_F(LabelSectionTest, aLabelWithItsOwnCurveIsRecolouredAndKeepsItsOpacities) {
  const TransferFunction own{1.0, {{-5000.0, {0, 1, 0}, 0.5}, {5000.0, {0, 1, 1}, 0.125}}};
  scene.keep = withLooks(scene.keep, {{1, own}});
  section.setScene(scene);
  ColorPicker* picker = clickSquare(1);
  ASSERT_NE(picker, nullptr);
  QTest::mouseClick(picker, Qt::LeftButton, {}, {1, 1});
  ASSERT_EQ(scene.keep.looks.size(), 1u);
  const TransferFunction white = scene.keep.looks[0];
  EXPECT_GT(white.points[1].color.g, 0.98);
  EXPECT_EQ(white, inOneColor(own, white.points[0].color));
  // Esc brings back a curve of several colours, which no colour of the picker's is.
  QTest::keyClick(picker->window(), Qt::Key_Escape);
  EXPECT_EQ(scene.keep.looks, std::vector<TransferFunction>{own});
  EXPECT_EQ(gestures.size(), 1u) << "so that no step is left";
}

TEST_F(LabelSectionTest, escTakesTheCurveBackThatAColourHasBegun) {
  const Region before = scene.keep;
  table().setCurrentIndex(model().index(1, 0)); // selected it has its colour, too
  ColorPicker* picker = clickSquare(1);
  ASSERT_NE(picker, nullptr);
  QTest::mouseClick(picker, Qt::LeftButton, {}, {1, 1});
  ASSERT_NE(scene.keep, before);
  QTest::keyClick(picker->window(), Qt::Key_Escape);
  EXPECT_EQ(scene.keep, before);
}

TEST_F(LabelSectionTest, aColourIsAskedForByTheMenuOfARowToo) {
  QMenu* menu = menuOf(model().index(1, LabelTable::weightColumn));
  ASSERT_NE(menu, nullptr);
  entry(*menu, "Colour…").trigger();
  menu->close();
  auto* picker = section.findChild<ColorPicker*>();
  ASSERT_NE(picker, nullptr);
  QTest::mouseClick(picker, Qt::LeftButton, {}, {1, 1});
  EXPECT_EQ(texts, std::vector<QString>{QStringLiteral("colour of Liver")});
}

TEST_F(LabelSectionTest, theMenuOfARowShowsItsLabelAloneInOneStep) {
  giveVoxels();
  scene.keep.weights = {1.0, 0.0, 0.5};
  section.setScene(scene);
  EXPECT_EQ(menuOf(model().index(1, 0))->accessibleName(), QStringLiteral("Liver"));
  delete section.findChild<QMenu*>(QStringLiteral("labelMenu"));
  ASSERT_TRUE(choose(model().index(1, 0), "Show only this"));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(texts, std::vector<QString>{QStringLiteral("show only Liver")});
  EXPECT_EQ(gestures.size(), 1u);
  EXPECT_FALSE(choose(model().index(1, 0), "Show only this")) << "it is";
  ASSERT_TRUE(choose(model().index(2, 0), "Show all"));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(texts.back(), QStringLiteral("show all labels"));
  EXPECT_FALSE(choose(model().index(2, 0), "Show all")) << "nothing is hidden";
  // One that is faded stays faded.
  scene.keep.weights = {1.0, 0.4, 1.0};
  section.setScene(scene);
  ASSERT_TRUE(choose(model().index(1, LabelTable::curveColumn), "Show only this"));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{0, 0.4, 0}));
}

TEST_F(LabelSectionTest, aLabelWithoutAVoxelIsNotShownAlone) {
  EXPECT_TRUE(choose(model().index(0, 0), "Show only this"));
  EXPECT_FALSE(choose(model().index(1, 0), "Show only this")) << "the picture would be empty";
}

TEST_F(LabelSectionTest, aGroupIsShownAloneAndHasNoColour) {
  std::vector<Label> labels{{0, "background", glm::dvec3(0.5)}, {1, "liver", glm::dvec3(1.0)}};
  for (int n = 1; n <= 3; ++n)
    labels.push_back({n + 1, "rib_left_" + std::to_string(n), glm::dvec3(0.9)});
  scene.keep = labelled(labels);
  giveVoxels();
  const QModelIndex ribs = model().index(2, 0);
  ASSERT_TRUE(choose(ribs, "Show only this"));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{0, 0, 1, 1, 1}));
  EXPECT_EQ(texts.back(), QStringLiteral("show only rib"));
  const QMenu* menu = menuOf(ribs);
  ASSERT_NE(menu, nullptr);
  EXPECT_THROW(entry(*menu, "Colour…"), std::runtime_error);
  delete menu;
  ASSERT_TRUE(choose(model().index(1, 0, ribs), "Show only this"));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{0, 0, 0, 1, 0}));
}

// What lies beside the body is in none of the rows, and "only" hides it all the same.
TEST_F(LabelSectionTest, theTableBesideTheBodyIsHiddenWithTheOthers) {
  std::vector<Label> labels = scene.keep.labels->labels();
  labels.push_back({tableLabelValue, "Table and holder", glm::dvec3(0.5)});
  scene.keep = labelled(labels);
  giveVoxels();
  ASSERT_EQ(model().rowCount(), 3);
  ASSERT_TRUE(choose(model().index(1, 0), "Show only this"));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{0, 1, 0, 0}));
}

TEST_F(LabelSectionTest, itSaysOnceThatASegmentationIsOpened) {
  int opened = 0;
  QObject::connect(&section, &LabelSection::opened, &section, [&opened] { ++opened; });
  const Scene open = scene;
  section.setScene({});
  EXPECT_EQ(opened, 0);
  section.setScene(open);
  EXPECT_EQ(opened, 1);
  // A cut makes another map of the same segmentation.
  scene.keep.labels = std::make_shared<const LabelMap>(glm::ivec3(1), std::vector<std::uint8_t>{1},
                                                       open.keep.labels->labels());
  section.setScene(scene);
  EXPECT_EQ(opened, 1);
  scene.keep.source = "other.nrrd";
  section.setScene(scene);
  EXPECT_EQ(opened, 2);
  scene.volume = phantomVolume({12.0, 0.0, 1});
  section.setScene(scene);
  EXPECT_EQ(opened, 3) << "of another volume";
}

TEST_F(LabelSectionTest, listsNameColourAndWeight) {
  EXPECT_FALSE(section.isFolded());
  ASSERT_EQ(model().rowCount(), 3);
  EXPECT_EQ(at(1, 0), QStringLiteral("Liver"));
  const QImage swatch = at(1, 0, Qt::DecorationRole).value<QPixmap>().toImage();
  EXPECT_EQ(swatch.pixelColor(swatch.rect().center()), QColor(Qt::red));
  EXPECT_EQ(at(1, 0, Qt::CheckStateRole).toInt(), Qt::Checked);
  EXPECT_EQ(at(1, 1), QStringLiteral("100 %"));
}

TEST_F(LabelSectionTest, theHeadingSaysHowManyAreNotShownWhole) {
  const auto heading = [this] {
    return section.findChild<FoldingHeader*>()->findChildren<QLabel*>().last()->text();
  };
  EXPECT_EQ(heading(), QStringLiteral("3 shown"));
  EXPECT_GE(table().sizeHintForRow(0), 24) << "marks stand clear of each other";
  scene.keep.weights = {1.0, 0.4, 0.0};
  section.setScene(scene);
  EXPECT_EQ(heading(), QStringLiteral("2 of 3 hidden or faded"));
  scene.keep = Region{.kind = Region::Kind::body, .source = {}, .labels = nullptr, .weights = {}};
  section.setScene(scene);
  EXPECT_EQ(heading(), QStringLiteral("none")) << "a hidden table is no label";
}

TEST_F(LabelSectionTest, hidesAndShowsByKeyboard) {
  table().setFocus();
  table().setCurrentIndex(model().index(1, 0));
  QTest::keyClick(&table(), Qt::Key_Space);
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 0, 1}));
  EXPECT_EQ(at(1, 0, Qt::CheckStateRole).toInt(), Qt::Unchecked);
  EXPECT_EQ(table().currentIndex().row(), 1) << "the place in the list stays";
  QTest::keyClick(&table(), Qt::Key_Space);
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(texts, (std::vector<QString>{QStringLiteral("hide Liver"), QStringLiteral("show Liver")}));
}

TEST_F(LabelSectionTest, hidesByAClickOnTheMark) {
  const QRect cell = table().visualRect(model().index(2, 0));
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, QPoint(cell.left() + 12, cell.center().y()));
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 0}));
}

TEST_F(LabelSectionTest, fadesByANumber) {
  table().setCurrentIndex(model().index(2, 1));
  table().edit(table().currentIndex());
  auto* field = widgetNamed<NumberField>(section, "Shown");
  ASSERT_TRUE(field);
  QTest::keyClicks(field, QStringLiteral("25"));
  QTest::keyClick(field, Qt::Key_Enter);
  QCoreApplication::processEvents(); // the number is taken behind the key
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 0.25}));
  EXPECT_EQ(at(2, 0, Qt::CheckStateRole).toInt(), Qt::PartiallyChecked);
  EXPECT_EQ(texts, (std::vector<QString>{QStringLiteral("fade Bone to 25 %")}));
  QTest::mouseClick(&button(QStringLiteral("Show all")), Qt::LeftButton);
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 1}));
  EXPECT_FALSE(button(QStringLiteral("Show all")).isEnabled());
}

TEST_F(LabelSectionTest, aNumberThatIsLookedAtStaysWhatItWas) {
  scene.keep.weights[2] = 0.333; // as a scene file may say
  section.setScene(scene);
  table().edit(model().index(2, 1));
  QTest::keyClick(widgetNamed<NumberField>(section, "Shown"), Qt::Key_Enter);
  QCoreApplication::processEvents();
  EXPECT_EQ(texts, std::vector<QString>());
  EXPECT_EQ(scene.keep.weights[2], 0.333);
}

TEST_F(LabelSectionTest, saysWhatFitsAndKeepsTheFieldWhereANumberDoesNot) {
  QSignalSpy refused(&section, &LabelSection::refused);
  const QPersistentModelIndex bone = model().index(2, 1);
  table().setCurrentIndex(bone);
  table().edit(bone);
  const QPointer<NumberField> field = widgetNamed<NumberField>(section, "Shown");
  ASSERT_TRUE(field);
  const std::vector<double> whole{1, 1, 1};
  for (const Qt::Key key : {Qt::Key_Enter, Qt::Key_Tab}) {
    QTest::keyClicks(field, QStringLiteral("150"));
    QTest::keyClick(field, key);
    QCoreApplication::processEvents();
    ASSERT_TRUE(field && field->isVisible());
    EXPECT_EQ(field->refusal(),
              QStringLiteral("150\u00a0% does not fit: give a number from 0\u00a0% to 100\u00a0%."));
    EXPECT_EQ(scene.keep.weights, whole);
  }
  EXPECT_EQ(refused.count(), 0) << "it is said at the field";
  QTest::keyClicks(field, QStringLiteral("40 %"));
  QTest::keyClick(field, Qt::Key_Enter);
  QCoreApplication::processEvents();
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 0.4}));
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  ASSERT_FALSE(field);

  table().edit(bone);
  auto* another = widgetNamed<NumberField>(section, "Shown");
  ASSERT_TRUE(another);
  QTest::keyClicks(another, QStringLiteral("150"));
  table().setFocus();
  QCoreApplication::processEvents();
  EXPECT_EQ(scene.keep.weights, (std::vector<double>{1, 1, 0.4}));
  EXPECT_EQ(refused.count(), 1) << "the field has gone";
}

TEST_F(LabelSectionTest, hasRoomForTenThousandLabels) {
  std::vector<Label> many;
  for (int n = 0; n < 10001; ++n)
    many.push_back({n, "Label " + std::to_string(n), {}});
  const int few = table().height();
  scene.keep = labelled(many);
  section.setScene(scene);
  EXPECT_EQ(model().rowCount(), 10001);
  EXPECT_LT(table().height(), 4 * few) << "it scrolls";
  table().setCurrentIndex(model().index(10000, 0));
  QTest::keyClick(&table(), Qt::Key_Space);
  EXPECT_EQ(scene.keep.weights.back(), 0.0);
  // A view measures its columns anew each time that it is told of changes.
  int told = 0;
  QObject::connect(&model(), &QAbstractItemModel::dataChanged, &section, [&told] { ++told; });
  QTest::keyClick(&table(), Qt::Key_Space);
  EXPECT_EQ(scene.keep.weights.back(), 1.0);
  EXPECT_EQ(told, 1) << "at once, not row by row";
}

TEST_F(LabelSectionTest, withoutLabelsOffersToOpenSome) {
  scene.keep = {};
  section.setScene(scene);
  EXPECT_TRUE(table().isHidden());
  EXPECT_TRUE(button(QStringLiteral("Show all")).isHidden());
  int asked = 0;
  QObject::connect(&section, &LabelSection::openRequested, &section, [&asked] { ++asked; });
  QTest::mouseClick(&button(QStringLiteral("Open labels…")), Qt::LeftButton);
  EXPECT_EQ(asked, 1);
  section.setScene({});
  EXPECT_FALSE(button(QStringLiteral("Open labels…")).isEnabled()) << "there is no volume";
}

TEST_F(LabelSectionTest, aLabelIsSelectedWhereItIsSeen) {
  section.setFolded(true);
  section.select(2);
  EXPECT_FALSE(section.isFolded());
  EXPECT_EQ(table().currentIndex().row(), 2);
  EXPECT_TRUE(table().selectionModel()->isRowSelected(2));
  section.select(7);
  EXPECT_EQ(table().currentIndex().row(), 2) << "there is no such label";
}

TEST_F(LabelSectionTest, selectingEndsASearchThatLeavesTheLabelOut) {
  std::vector<Label> many;
  for (int n = 0; n < 40; ++n)
    many.push_back({n, "Label " + std::to_string(n), {}});
  scene.keep = labelled(many);
  section.setScene(scene);
  auto* search = section.findChild<QLineEdit*>();
  ASSERT_NE(search, nullptr);
  search->setText(QStringLiteral("label 3"));
  section.select(33);
  EXPECT_EQ(search->text(), QStringLiteral("label 3")) << "which it does not";
  EXPECT_EQ(table().currentIndex().data().toString(), QStringLiteral("Label 33"));
  section.select(28);
  EXPECT_EQ(search->text(), QString());
  EXPECT_EQ(table().currentIndex().data().toString(), QStringLiteral("Label 28"));
  EXPECT_TRUE(table().viewport()->rect().intersects(table().visualRect(table().currentIndex())));
}

} // namespace
} // namespace limn
