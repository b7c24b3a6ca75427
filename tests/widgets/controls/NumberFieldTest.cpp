// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/NumberField.h"

#include "support/Waiting.h"
#include "widgets/ValueText.h"
#include "widgets/theme/Theme.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTest>
#include <QTimer>
#include <QToolTip>

#include <gtest/gtest.h>

#include <vector>

namespace limn {
namespace {

TEST(NumberField, leavesUndoToTheProgramButWhileOneTypes) {
  NumberField field(0.0, 100.0, 2);
  field.show();
  const auto takesUndo = [&] {
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    undo.ignore();
    QCoreApplication::sendEvent(&field, &undo);
    return undo.isAccepted();
  };
  EXPECT_FALSE(takesUndo());
  QTest::keyClicks(&field, "5");
  EXPECT_TRUE(takesUndo());
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_FALSE(takesUndo());
}

TEST(NumberField, keepsTheExactNumberWhereItShowsARoundedOne) {
  NumberField field(0.0, 1.0, 4);
  field.setShownAs(opacityText);
  std::vector<double> edits;
  QObject::connect(&field, &NumberField::numberEdited, [&](double number) { edits.push_back(number); });
  field.setNumber(0.63019);
  EXPECT_EQ(field.text(), QLocale().toString(0.63));
  field.selectAll();
  QTest::keyClicks(&field, QLocale().toString(0.63));
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.number(), 0.63019);
  EXPECT_TRUE(edits.empty());
  field.selectAll();
  QTest::keyClicks(&field, QLocale().toString(0.0005));
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(edits, std::vector<double>{0.0005});
  EXPECT_EQ(field.text(), QLocale().toString(0.0005));
}

TEST(NumberField, standsForSeveralNumbersUntilOneIsTyped) {
  NumberField field(0.0, 1.0, 4);
  std::vector<double> edits;
  QObject::connect(&field, &NumberField::numberEdited, [&](double number) { edits.push_back(number); });
  field.setMixed();
  EXPECT_TRUE(field.text().isEmpty());
  field.stepBy(1);
  QTest::keyClick(&field, Qt::Key_Return);
  QTest::keyClicks(&field, "7");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_FALSE(field.refusal().isEmpty());
  EXPECT_TRUE(edits.empty() && field.isMixed());
  field.selectAll();
  QTest::keyClicks(&field, "0");
  field.takeBack();
  EXPECT_TRUE(field.text().isEmpty());
  QTest::keyClicks(&field, "0");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(edits, std::vector<double>{0.0}) << "also what it held before";
  EXPECT_EQ(field.text(), QStringLiteral("0"));
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(edits.size(), 1u);
}

// What "10" is typed over in a field of 0 to 1, and how it ends.
struct Typed {
  double number = 0.0;
  QString text, refusal;
  std::vector<double> edits;
};

Typed typedInto(NumberField& field, const QString& keys) {
  Typed typed;
  const auto connection = QObject::connect(&field, &NumberField::numberEdited,
                                           [&](double number) { typed.edits.push_back(number); });
  field.setNumber(0.55);
  field.selectAll();
  QTest::keyClicks(&field, keys);
  QTest::keyClick(&field, Qt::Key_Return);
  QObject::disconnect(connection);
  typed.number = field.number();
  typed.text = field.text();
  typed.refusal = field.refusal();
  return typed;
}

TEST(NumberField, refusesWhatDoesNotFitWithASentenceAndKeepsTheNumberBefore) {
  NumberField field(0.0, 1.0, 4);
  field.show();
  for (const char* keys : {"10", "-1", "1.5"}) {
    const Typed typed = typedInto(field, QString::fromLatin1(keys));
    EXPECT_TRUE(typed.edits.empty()) << keys << " became " << typed.number;
    EXPECT_EQ(typed.number, 0.55) << keys;
    EXPECT_EQ(typed.text, QLocale().toString(0.55)) << keys;
    EXPECT_TRUE(typed.refusal.contains(QStringLiteral("from 0 to 1"))) << typed.refusal.toStdString();
    EXPECT_EQ(field.accessibleDescription(), typed.refusal);
  }
  QTest::keyClicks(&field, QStringLiteral("1"));
  EXPECT_TRUE(field.refusal().isEmpty()) << "once something else is typed";
}

TEST(NumberField, repeatsWhatWasTypedAndNumbersWithTheirUnitOnce) {
  NumberField field(0.0, 1.0, 4);
  field.setUnit(QStringLiteral("HU"));
  field.show();
  for (const auto& [keys, told] : {std::pair("banana", QStringLiteral("banana")),
                                   {"10%", QStringLiteral("10%")},
                                   {"5 mm", QStringLiteral("5 mm")},
                                   {"4 HU", QStringLiteral("4 HU")},
                                   {"4", withUnit(QStringLiteral("4"), QStringLiteral("HU"))}}) {
    const Typed typed = typedInto(field, QString::fromLatin1(keys));
    EXPECT_TRUE(typed.refusal.startsWith(told + QStringLiteral(" does not fit")))
        << typed.refusal.toStdString();
  }
}

// The number before is back: a red edge would say that it is wrong.
TEST(NumberField, isNotRedOnceItIsLeft) {
  QWidget window;
  auto* row = new QHBoxLayout(&window);
  auto* field = new NumberField(0.0, 1.0, 4);
  auto* next = new NumberField(0.0, 1.0, 4);
  for (NumberField* one : {field, next})
    row->addWidget(one);
  window.show();
  ASSERT_TRUE(test::waitUntilExposed(window));
  window.activateWindow();
  ASSERT_TRUE(test::waitUntil([&] { return window.isActiveWindow(); }));
  const auto isRed = [&] {
    const QImage seen = field->grab().toImage();
    const QColor edge = seen.pixelColor(seen.width() / 2, 1);
    return edge.red() > edge.green() + 60;
  };
  field->setFocus();
  EXPECT_FALSE(typedInto(*field, QStringLiteral("10")).refusal.isEmpty());
  EXPECT_TRUE(isRed());
  QTest::keyClick(field, Qt::Key_Tab);
  ASSERT_TRUE(next->hasFocus());
  EXPECT_FALSE(isRed());
  EXPECT_TRUE(field->refusal().isEmpty() && field->accessibleDescription().isEmpty());
  // Left with what is refused it says so, and is red as long as its sentence stands.
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("10"));
  QTest::keyClick(field, Qt::Key_Tab);
  ASSERT_TRUE(next->hasFocus());
  EXPECT_TRUE(isRed());
  EXPECT_TRUE(test::waitUntil([] { return QToolTip::text().contains(QStringLiteral("from 0 to 1")); }));
  auto* stands = field->findChild<QTimer*>(QStringLiteral("refusalStands"));
  ASSERT_TRUE(stands->isActive());
  stands->start(0); // not the eight seconds of its sentence
  EXPECT_TRUE(test::waitUntil([&] { return !isRed(); }));
}

TEST(NumberField, takesPerCentWhereThatIsMeant) {
  NumberField field(0.0, 1.0, 4);
  field.setTakesPercent(true);
  field.show();
  for (const char* keys : {"10 %", "10%"}) {
    const Typed typed = typedInto(field, QString::fromLatin1(keys));
    EXPECT_EQ(typed.edits, std::vector<double>{0.1}) << keys << ": " << typed.refusal.toStdString();
    EXPECT_EQ(typed.text, QLocale().toString(0.1));
  }
  EXPECT_TRUE(typedInto(field, QStringLiteral("120 %")).refusal.contains(QStringLiteral("120 %")));
  EXPECT_EQ(typedInto(field, QStringLiteral("0.25")).number, 0.25);
  EXPECT_TRUE(typedInto(field, QStringLiteral("10")).refusal.contains(QStringLiteral("per cent")));
}

// Left out without a word, letters would make another number of what was typed: 81 of 8x1.
TEST(NumberField, refusesWhatIsNoNumberAsItWasTyped) {
  NumberField field(0.0, 200.0, 2);
  field.show();
  for (const char* keys : {"8x1", "abc", "1-1"}) {
    const Typed typed = typedInto(field, QString::fromLatin1(keys));
    EXPECT_TRUE(typed.edits.empty()) << keys << " became " << typed.number;
    EXPECT_EQ(typed.number, 0.55) << keys;
    const QString shown = QString::fromLatin1(keys).replace(QLatin1Char('-'), QChar(0x2212));
    EXPECT_TRUE(typed.refusal.startsWith(shown)) << keys << ": " << typed.refusal.toStdString();
  }
  EXPECT_EQ(typedInto(field, QStringLiteral("1e2")).number, 100.0);
  EXPECT_EQ(typedInto(field, QStringLiteral("1.239")).number, 1.24) << "as exact as it is shown";
  const Typed nothing = typedInto(field, QStringLiteral(" "));
  EXPECT_EQ(nothing.number, 0.55);
  EXPECT_TRUE(nothing.refusal.isEmpty()) << "nothing was said, so nothing is refused";
}

TEST(NumberField, takesItsUnitAsItIsTyped) {
  NumberField field(0.0, 200.0, 1);
  field.setSuffix(QChar(0x00a0) + QStringLiteral("HU"));
  field.show();
  for (const char* keys : {"90 HU", "90HU"}) {
    const Typed typed = typedInto(field, QString::fromLatin1(keys));
    EXPECT_EQ(typed.number, 90.0) << keys << ": " << typed.refusal.toStdString();
  }
  EXPECT_EQ(field.text(), QStringLiteral("90") + QChar(0x00a0) + QStringLiteral("HU"));
}

TEST(NumberField, takesASecondUnitWithItsDigits) {
  NumberField field(0.0, 100.0, 1);
  field.setUnit(QStringLiteral("%"));
  field.setOtherUnit(QStringLiteral("mm"), 100.0 / 208.4);
  field.show();
  for (const char* keys : {"48 mm", "48mm"}) {
    const Typed typed = typedInto(field, QString::fromLatin1(keys));
    EXPECT_EQ(typed.edits, std::vector<double>{48.0 * (100.0 / 208.4)}) << keys;
    EXPECT_EQ(typed.number, 48.0 * (100.0 / 208.4)) << keys << ": " << typed.refusal.toStdString();
    EXPECT_EQ(typed.text, QLocale().toString(23) + QChar(0x00a0) + QLatin1Char('%'));
  }
  EXPECT_EQ(typedInto(field, QStringLiteral("48 %")).number, 48.0);
  EXPECT_EQ(typedInto(field, QStringLiteral("48")).number, 48.0);
  field.setOtherUnit(QStringLiteral("mm"), 100.0 / 208.36);
  EXPECT_EQ(typedInto(field, QLocale().toString(208.4) + QStringLiteral(" mm")).number, 100.0);
  const QString tooLong = typedInto(field, QStringLiteral("300mm")).refusal;
  EXPECT_TRUE(tooLong.startsWith(QStringLiteral("300mm does not fit"))) << tooLong.toStdString();
  EXPECT_TRUE(tooLong.contains(QLocale().toString(208.4) + QChar(0x00a0) + QStringLiteral("mm")));
  EXPECT_TRUE(typedInto(field, QStringLiteral("48cm")).refusal.startsWith(QStringLiteral("48cm does not")));
}

TEST(NumberField, readsBothMinusSignsAndShowsTheRealOne) {
  NumberField field(-1000.0, 1000.0, 1);
  field.show();
  const Typed typed = typedInto(field, QStringLiteral("-250"));
  EXPECT_EQ(typed.number, -250.0);
  EXPECT_EQ(typed.text, QString(QChar(0x2212)) + QStringLiteral("250"));
  field.selectAll();
  QTest::keyClicks(&field, QStringLiteral("-7"));
  EXPECT_EQ(field.text(), QString(QChar(0x2212)) + QStringLiteral("7")) << "also while one types";
  QTest::keyClick(&field, Qt::Key_Up);
  EXPECT_EQ(field.text(), QString(QChar(0x2212)) + QStringLiteral("6.9"))
      << "adaptive: a tenth of its decade";
  // As it is pasted from where the program writes it.
  field.selectAll();
  field.findChild<QLineEdit*>()->insert(QChar(0x2212) + QLocale().toString(31.5));
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.number(), -31.5);
}

// Of diffusion: the unit has a hyphen and a point of its own.
TEST(NumberField, leavesTheUnitAsItIs) {
  NumberField field(-1000.0, 1000.0, 1);
  field.setSuffix(QStringLiteral(" 10*-6.mm2/s"));
  field.show();
  EXPECT_EQ(typedInto(field, QStringLiteral("-12.5")).number, -12.5);
  EXPECT_EQ(field.text(), QChar(0x2212) + QStringLiteral("12.5 10*-6.mm2/s"));
  QTest::keyClick(&field, Qt::Key_Home);
  QTest::keyClick(&field, Qt::Key_Delete); // the sign alone
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.number(), 12.5);
  EXPECT_EQ(field.text(), QStringLiteral("12.5 10*-6.mm2/s"));
}

TEST(NumberField, aDoubleClickSelectsTheWholeNumberAndLeavesItsUnit) {
  NumberField field(-1000.0, 1000.0, 2);
  field.setSuffix(QStringLiteral(" mm"));
  field.resize(200, field.sizeHint().height());
  field.show();
  field.setNumber(-20.55);
  auto& edit = *field.findChild<QLineEdit*>();
  const QString number = QChar(0x2212) + QStringLiteral("20.55");
  ASSERT_EQ(edit.text(), number + QStringLiteral(" mm"));
  const auto clickTwiceOn = [&edit](QChar digit) {
    const QFontMetrics metrics = edit.fontMetrics(); // the text ends at the right
    const auto behind = edit.text().mid(edit.text().lastIndexOf(digit));
    const QPoint at(edit.width() - metrics.horizontalAdvance(behind) + 1, edit.height() / 2);
    QTest::mouseDClick(&edit, Qt::LeftButton, {}, at);
    QMouseEvent slip(QEvent::MouseMove, at + QPoint(6, 0), edit.mapToGlobal(at + QPoint(6, 0)), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(&edit, &slip); // hands are not still
    QTest::mouseRelease(&edit, Qt::LeftButton, {}, at);
  };
  clickTwiceOn(QLatin1Char('0'));
  EXPECT_EQ(edit.selectedText(), number);
  edit.deselect();
  clickTwiceOn(QLatin1Char('5'));
  EXPECT_EQ(edit.selectedText(), number) << "behind the point, too";
  QTest::keyClicks(&field, QStringLiteral("7"));
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.number(), 7.0);
  EXPECT_EQ(edit.text(), QStringLiteral("7 mm"));
}

TEST(NumberField, isAsWideAsItsWidestNumberWhereThatIsWanted) {
  const auto width = [](double lowest, double highest, int decimals, const QString& unit) {
    NumberField field(lowest, highest, decimals);
    field.setSuffix(unit);
    field.setFitted(QStringLiteral("88"));
    return field.sizeHint().width();
  };
  EXPECT_EQ(width(0.0, 5.0, 0, {}), width(0.0, 8.0, 0, {})) << "that of the least text";
  const int common = width(0.0, 100.0, 1, {});
  EXPECT_LT(width(0.0, 5.0, 0, {}), common);
  EXPECT_LT(common, width(-100.0, 100.0, 1, {})) << "a sign";
  EXPECT_LT(common, width(0.0, 100.0, 2, {})) << "a decimal more, though the limit shows none";
  EXPECT_LT(common, width(0.0, 100.0, 1, QStringLiteral(" mm")));
  NumberField field(0.0, 100.0, 2);
  field.setSuffix(QStringLiteral(" mm"));
  field.setFitted({});
  field.show();
  field.setNumber(88.88);
  const auto* edit = field.findChild<QLineEdit*>();
  EXPECT_GE(edit->width(), edit->fontMetrics().horizontalAdvance(field.text())) << "nothing is cut";
}

// The sheet gives every field of text an edge and margins, and a field of numbers holds one of those.
TEST(NumberField, showsItsWholeNumberInTheMiddle) {
  NumberField field(1.0, 360.0, 1);
  field.setStyleSheet(themeStyleSheet(Look::light));
  field.setSuffix(QStringLiteral("°"));
  field.setNumber(360.0);
  field.show();
  field.resize(field.sizeHint());
  const auto* edit = field.findChild<QLineEdit*>();
  EXPECT_EQ(edit->geometry().center().y(), field.rect().center().y());
  QStyleOptionFrame option;
  option.initFrom(edit);
  const QRect words = edit->style()->subElementRect(QStyle::SE_LineEditContents, &option, edit);
  EXPECT_GE(words.width(), edit->fontMetrics().horizontalAdvance(field.text()));
}

} // namespace
} // namespace limn
