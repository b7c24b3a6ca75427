// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/DialogKeys.h"
#include "app/WindowHarness.h"
#include "app/files/figure/FigureDialog.h"
#include "app/language/InGerman.h"
#include "translations/Words.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/theme/LookStyle.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QMenuBar>
#include <QSet>

// The program's window in German.
namespace limn::test {
namespace {

class GermanWindow : private InGerman, public WindowHarness {};

// The letter behind the mark; nothing where there is none.
QString mnemonicOf(QString text) {
  text.remove(QStringLiteral("&&"));
  const qsizetype mark = text.indexOf(QLatin1Char('&'));
  return mark < 0 ? QString() : text.mid(mark + 1, 1).toLower();
}

void expectOwnMnemonics(const QString& menu, const QList<QAction*>& actions) {
  QSet<QString> taken;
  for (const QAction* action : actions) {
    const QString letter = mnemonicOf(action->text());
    EXPECT_FALSE(!letter.isEmpty() && taken.contains(letter))
        << menu.toStdString() << ": two have the letter of \"" << action->text().toStdString() << '"';
    taken.insert(letter);
    if (action->menu())
      expectOwnMnemonics(action->text(), action->menu()->actions());
  }
}

// English texts that German has another text for, as they stand in widgets.
const QSet<QString>& leftInEnglish() {
  static const QSet<QString> texts = [] {
    QSet<QString> english;
    for (const Word& word : germanWords())
      english.insert(QString(word.source).remove(QLatin1Char('&')));
    for (const Word& word : germanWords())
      english.remove(QString(word.translation).remove(QLatin1Char('&')));
    return english;
  }();
  return texts;
}

void expectGerman(const QString& text, const QObject& of) {
  EXPECT_FALSE(leftInEnglish().contains(QString(text).remove(QLatin1Char('&'))))
      << of.metaObject()->className() << " says \"" << text.toStdString() << '"';
}

TEST_F(GermanWindow, hasGermanMenus) {
  QStringList menus;
  for (const QAction* menu : window->menuBar()->actions())
    menus << menu->text();
  EXPECT_EQ(menus,
            QStringList({QStringLiteral("&Datei"), QStringLiteral("&Bearbeiten"), QStringLiteral("&Ansicht"),
                         QStringLiteral("&Preset"), QStringLiteral("&Hilfe")}));
  EXPECT_NE(action(QStringLiteral("&DICOM-Ordner öffnen…")), nullptr);
}

TEST_F(GermanWindow, givesEachEntryOfAMenuALetterOfItsOwn) {
  expectOwnMnemonics(QStringLiteral("menu bar"), window->menuBar()->actions());
}

TEST_F(GermanWindow, noTwoThingsOfADialogHaveOneKey) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  int asked = 0;
  onceAsked<PictureDialog>([&](PictureDialog& dialog) {
    ++asked;
    expectOneKeyEachOfSizes(dialog);
    dialog.reject();
  });
  window->findChild<QAction*>(QStringLiteral("savePicture"))->trigger();
  EXPECT_EQ(asked, 1);
  expectOneKeyEachOfExports(*window);
}

TEST_F(GermanWindow, saysNothingInEnglishOfWhichTheGermanIsKnown) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  for (const QAction* action : window->findChildren<QAction*>()) {
    expectGerman(action->text(), *action);
    expectGerman(action->toolTip(), *action);
  }
  for (const QWidget* widget : window->findChildren<QWidget*>()) {
    for (const QString& text : {widget->toolTip(), widget->accessibleName(), widget->windowTitle()})
      expectGerman(text, *widget);
    if (const auto* label = qobject_cast<const QLabel*>(widget))
      expectGerman(label->text(), *widget);
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
      expectGerman(button->text(), *widget);
    if (const auto* box = qobject_cast<const QComboBox*>(widget))
      for (int i = 0; i < box->count(); ++i)
        expectGerman(box->itemText(i), *widget);
  }
}

// German words are longer: no model, projection or fog makes the properties wider than the panel beside them.
TEST_F(GermanWindow, theLongerWordsFitThePanelOfTheProperties) {
  window->setGeometry(0, 0, 1280, 800);
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  auto* panel = window->findChild<PropertiesPanel*>();
  ASSERT_NE(panel, nullptr);
  setLayout(CompareLayout::single);
  for (const Projection projection : {Projection::composite, Projection::mip, Projection::isosurface})
    for (const ShadingModel model : {ShadingModel::none, ShadingModel::classic, ShadingModel::robust})
      for (const Fog::Mode mode : {Fog::Mode::none, Fog::Mode::exp}) {
        Scene next = scene();
        next.projection = projection;
        next.shading.model = model;
        next.fog.mode = mode;
        session().edit(next, {nextGestureId(), QStringLiteral("test")});
        QCoreApplication::sendPostedEvents(); // layouts
        EXPECT_LE(panel->widget()->minimumSizeHint().width(), panel->viewport()->width())
            << static_cast<int>(projection) << ", " << static_cast<int>(model) << ", "
            << static_cast<int>(mode);
      }
}

// As in English: each of two pictures has 400 pixels in the first window of a common screen.
TEST_F(GermanWindow, thePanelsLeaveRoomForTwoPictures) {
  applyTheme(*static_cast<QApplication*>(QApplication::instance()), themeNamed("light")); // as in the program
  window = std::make_unique<MainWindow>(UserFolders::below(folder.path()));
  window->show();
  ASSERT_TRUE(test::waitUntilExposed(*window));
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const QSize size = firstWindowSize({1440, 900});
  window->resize(size);
  ASSERT_TRUE(test::waitUntil([&] { return window->size() == size && rest(); }));
  const FirstDockSizes docks = firstDockSizes(size);
  const auto dock = [this](const char* name) { return window->findChild<QDockWidget*>(QLatin1String(name)); };
  window->resizeDocks({dock("presetDock"), dock("shadingDock")}, {docks.presetsWidth, docks.propertiesWidth},
                      Qt::Horizontal);
  window->findChild<ComparisonController*>()->begin(); // nobody asks for anything
  EXPECT_TRUE(test::waitUntil([&] { return view().compareLayout() == CompareLayout::sideBySide; }))
      << "the view has " << view().width() << " pixels";
}

TEST_F(GermanWindow, aFigureCallsPresetsAsTheirListDoes) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  window->findChild<QAction*>(QStringLiteral("saveFigure"))->trigger();
  const auto* dialog = window->findChild<FigureDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto& sources = *dialog->findChild<QComboBox*>(QStringLiteral("panelSource-a"));
  ASSERT_TRUE(waitUntil([&] { return sources.count() > 0; }));
  const QString listed = presetWords(QStringLiteral("CT bone"));
  ASSERT_EQ(listed, QStringLiteral("CT Knochen"));
  const int at = sources.findText(listed, Qt::MatchEndsWith);
  ASSERT_GE(at, 0);
  EXPECT_LT(sources.findText(QStringLiteral("CT bone"), Qt::MatchEndsWith), 0);
  sources.setFocus();
  sources.setCurrentIndex(at);
  emit sources.activated(at);
  EXPECT_EQ(dialog->findChild<QLineEdit*>(QStringLiteral("panelName-a"))->text(), listed);
}

TEST_F(GermanWindow, theLanguageIsChosenInTheMenuForTheNextTime) {
  QAction* english = window->findChild<QAction*>(QStringLiteral("language-en"));
  ASSERT_NE(english, nullptr);
  EXPECT_TRUE(window->findChild<QAction*>(QStringLiteral("language-system"))->isChecked());
  english->trigger();
  EXPECT_EQ(Settings(UserFolders::below(folder.path()).settings).language(), QStringLiteral("en"));
  EXPECT_TRUE(english->isChecked());
}

} // namespace
} // namespace limn::test
