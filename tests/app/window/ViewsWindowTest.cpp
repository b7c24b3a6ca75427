// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/ViewsController.h"

#include <QInputDialog>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>

#include <algorithm>

// Cameras that are kept under names, in the program's window.

namespace limn {
namespace {

class ViewsWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:8")));
    ASSERT_TRUE(rest());
  }

  QAction& named(const char* name) const { return *window->findChild<QAction*>(QLatin1String(name)); }
  const std::vector<NamedView>& views() const { return session().views(); }
  const Camera& camera() const { return scene().camera; }
  QStringList names() const {
    QStringList all;
    for (const NamedView& one : views())
      all << QString::fromStdString(one.name);
    return all;
  }

  // The entries of the menu that look from kept views.
  QList<QAction*> entries() const {
    QList<QAction*> all = named("keepView").actionGroup()->actions();
    all.removeFirst();
    return all;
  }

  /// By the keyboard: the menu's entry, a name, Enter; an empty one takes what is proposed.
  void keep(const QString& name = {}) {
    named("keepView").trigger();
    auto* dialog = window->findChild<QInputDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* field = dialog->findChild<QLineEdit*>();
    if (!name.isEmpty()) {
      field->selectAll();
      QTest::keyClicks(field, name);
    }
    QTest::keyClick(field, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers keys = {}) {
    view().setFocus();
    QTest::keyClick(window->windowHandle(), key, keys);
  }

  ViewsDialog& dialog() {
    if (!window->findChild<ViewsDialog*>())
      named("manageViews").trigger();
    return *window->findChild<ViewsDialog*>();
  }
  QListWidget& list() { return *dialog().findChild<QListWidget*>(); }
  void clickButton(const QString& text) {
    for (QPushButton* button : dialog().findChildren<QPushButton*>())
      if (button->text().remove(QLatin1Char('&')) == text)
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << text.toStdString();
  }
  void renameTo(const QString& name) {
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_F2);
    auto* editor = list().findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, name.isEmpty() ? QStringLiteral(" ") : name);
    QTest::keyClick(editor, Qt::Key_Return);
  }
  /// Whether a label of the list comes to say this.
  [[nodiscard]] bool isNoted(const QString& text) {
    return test::waitUntil([&] {
      return std::ranges::any_of(dialog().findChildren<QLabel*>(),
                                 [&](const QLabel* label) { return label->text() == text; });
    });
  }
};

TEST_F(ViewsWindow, aViewIsKeptUnderANameAndOneChoiceLeadsBack) {
  EXPECT_FALSE(named("manageViews").isEnabled());
  press(Qt::Key_L);
  const Camera left = camera();
  keep(QStringLiteral("the left ear"));
  ASSERT_EQ(views(), (std::vector<NamedView>{{"the left ear", left}}));
  EXPECT_EQ(undo().undoText(), QStringLiteral("keep view \"the left ear\""));
  EXPECT_TRUE(session().isEdited());
  press(Qt::Key_A);
  const Camera front = camera();
  keep();
  EXPECT_EQ(names(), (QStringList{QStringLiteral("the left ear"), QStringLiteral("View 1")}));
  ASSERT_EQ(entries().size(), 2);
  EXPECT_EQ(entries()[0]->text(), QStringLiteral("the left ear"));
  auto* lookFrom = qobject_cast<QMenu*>(named("keepView").associatedObjects().value(0));
  ASSERT_NE(lookFrom, nullptr);
  EXPECT_TRUE(lookFrom->actions().contains(entries()[0]));
  entries()[0]->trigger();
  EXPECT_EQ(camera(), left);
  press(Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(camera(), front) << "a step of the camera's history";
  press(Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(camera(), left);
  EXPECT_EQ(undo().count(), 2) << "looking is no edit";
  QTest::keyClick(window->windowHandle(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(names(), QStringList{QStringLiteral("the left ear")});
  EXPECT_EQ(entries().size(), 1);
  EXPECT_EQ(camera(), left);
}

TEST_F(ViewsWindow, altAndADigitLookFromTheFirstNineInOneGesture) {
  press(Qt::Key_L);
  const Camera left = camera();
  keep(QStringLiteral("left"));
  press(Qt::Key_P);
  const Camera back = camera();
  keep(QStringLiteral("back"));
  press(Qt::Key_A);
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(camera(), left);
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_EQ(camera(), back);
  for (int n = 3; n <= 10; ++n)
    keep(QString::number(n));
  ASSERT_EQ(entries().size(), 10);
  EXPECT_EQ(entries()[8]->shortcut(), QKeySequence(Qt::ALT | Qt::Key_9));
  EXPECT_TRUE(entries()[9]->shortcut().isEmpty());
}

TEST_F(ViewsWindow, theSameNameReplacesAndNoNameKeepsNothing) {
  press(Qt::Key_L);
  keep(QStringLiteral("ear"));
  press(Qt::Key_P);
  keep(QStringLiteral(" ear "));
  ASSERT_EQ(views(), (std::vector<NamedView>{{"ear", camera()}}));
  named("keepView").trigger();
  auto* asking = window->findChild<QInputDialog*>();
  ASSERT_NE(asking, nullptr);
  auto* field = asking->findChild<QLineEdit*>();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("  "));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(views().size(), 1u);
  QTest::keyClick(asking, Qt::Key_Escape);
  EXPECT_EQ(views().size(), 1u);
}

TEST_F(ViewsWindow, theRightClickInThePictureOffersThemToo) {
  press(Qt::Key_L);
  const Camera left = camera();
  keep(QStringLiteral("ear"));
  press(Qt::Key_A);
  QTest::mouseClick(window->windowHandle(), Qt::RightButton, {},
                    view().mapTo(window.get(), view().rect().center()));
  QCoreApplication::processEvents();
  auto* menu = view().findChild<QMenu*>(QStringLiteral("pictureMenu"));
  ASSERT_NE(menu, nullptr);
  auto* from = menu->findChild<QMenu*>();
  ASSERT_NE(from, nullptr);
  ASSERT_TRUE(from->actions().contains(entries()[0]));
  EXPECT_TRUE(from->actions().contains(&named("keepView")));
  entries()[0]->trigger();
  EXPECT_EQ(camera(), left);
  menu->close();
}

TEST_F(ViewsWindow, theListLooksRenamesAndDeletes) {
  press(Qt::Key_L);
  const Camera left = camera();
  keep(QStringLiteral("a"));
  press(Qt::Key_P);
  const Camera back = camera();
  keep(QStringLiteral("b"));
  ASSERT_EQ(list().count(), 2);
  list().setCurrentRow(0);
  clickButton(QStringLiteral("Look from there"));
  EXPECT_EQ(camera(), left);
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(1)).center());
  EXPECT_EQ(camera(), left) << "the first click of two";
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(1)).center());
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(1)).center());
  EXPECT_EQ(camera(), back);
  renameTo(QStringLiteral("from behind"));
  const QStringList renamed{QStringLiteral("a"), QStringLiteral("from behind")};
  ASSERT_TRUE(test::waitUntil([&] { return names() == renamed; }));
  EXPECT_EQ(entries()[1]->text(), QStringLiteral("from behind"));
  EXPECT_EQ(undo().undoText(), QStringLiteral("rename view \"b\""));
  renameTo({});
  EXPECT_TRUE(isNoted(QStringLiteral("A view needs a name.")));
  EXPECT_EQ(list().item(1)->text(), QStringLiteral("from behind"));
  renameTo(QStringLiteral("a"));
  EXPECT_TRUE(isNoted(QStringLiteral("Another view has that name; choose one of its own.")));
  EXPECT_EQ(list().item(1)->text(), QStringLiteral("from behind"));
  EXPECT_EQ(names(), renamed);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(names(), QStringList{QStringLiteral("a")});
  clickButton(QStringLiteral("Delete"));
  EXPECT_TRUE(views().empty());
  EXPECT_FALSE(named("manageViews").isEnabled());
  undo().undo();
  undo().undo();
  EXPECT_EQ(list().count(), 2) << "undo brings them back, here too";
  EXPECT_EQ(undo().redoText(), QStringLiteral("delete view \"from behind\""));
}

TEST_F(ViewsWindow, sessionsAndScenesKeepThemAndAnotherVolumeDropsThem) {
  press(Qt::Key_L);
  keep(QStringLiteral("ear"));
  const std::vector<NamedView> kept = views();
  typeName(pathTo("work.json"));
  named("saveSession").trigger();
  ASSERT_TRUE(test::waitUntil([this] { return QFile::exists(pathTo("work.json")); }));
  typeName(pathTo("look.json"));
  named("saveScene").trigger();
  ASSERT_TRUE(test::waitUntil([this] { return QFile::exists(pathTo("look.json")); }));
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_TRUE(views().empty());
  EXPECT_TRUE(entries().isEmpty());
  EXPECT_FALSE(named("manageViews").isEnabled());
  for (const char* file : {"work.json", "look.json"}) {
    ASSERT_TRUE(open(pathTo(file)));
    EXPECT_EQ(views(), kept) << file;
    EXPECT_EQ(entries().size(), 1) << file;
    EXPECT_FALSE(session().isEdited()) << file;
  }
  named("closeVolume").trigger();
  EXPECT_TRUE(views().empty());
  EXPECT_FALSE(named("keepView").isEnabled());
}

TEST_F(ViewsWindow, aHundredOfThemAndVeryLongNamesDoNoHarm) {
  std::vector<NamedView> many;
  for (int n = 0; n < 100; ++n)
    many.push_back({std::to_string(n) + " & " + std::string(500, 'x'), camera()});
  session().setViews(many, QStringLiteral("keep many"));
  keep(QString(500, QLatin1Char('y')));
  ASSERT_EQ(entries().size(), 101);
  for (const QAction* entry : entries())
    EXPECT_LE(entry->text().size(), 50);
  EXPECT_TRUE(entries()[7]->text().startsWith(QStringLiteral("7 && x"))) << "no letter of the menu";
  EXPECT_LE(undo().undoText().size(), 70);
  auto* lookFrom = qobject_cast<QMenu*>(named("keepView").associatedObjects().value(0));
  EXPECT_LE(lookFrom->sizeHint().width(), window->screen()->size().width());
  EXPECT_EQ(list().count(), 101);
  EXPECT_LE(dialog().width(), 500);
  typeName(pathTo("many.json"));
  named("saveSession").trigger();
  ASSERT_TRUE(test::waitUntil([this] { return QFile::exists(pathTo("many.json")); }));
  const std::vector<NamedView> kept = views();
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  ASSERT_TRUE(open(pathTo("many.json")));
  EXPECT_EQ(views(), kept);
}

} // namespace
} // namespace limn
