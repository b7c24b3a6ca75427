// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/NumberField.h"

#include "widgets/ValueText.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

namespace limn {
namespace {

constexpr int refusalMs = 8000;
constexpr QColor refusedColor(0xd1, 0x34, 0x38); // 3:1 at least on light and on dark fields

} // namespace

NumberField::NumberField(double lowest, double highest, int decimals, QWidget* parent)
    : QDoubleSpinBox(parent) {
  setDecimals(decimals);
  setRange(lowest, highest);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
  setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  setNumber(std::clamp(0.0, lowest, highest));
  connect(this, &QAbstractSpinBox::editingFinished, this, &NumberField::reportIfChanged);
  connect(lineEdit(), &QLineEdit::textEdited, this, &NumberField::forgetRefusal);
}

void NumberField::setLimits(double lowest, double highest, int decimals) {
  const double number = m_number; // the spin box would limit and round what it shows
  setDecimals(decimals);
  setRange(lowest, highest);
  setNumber(number);
}

void NumberField::setNumber(double number) {
  m_number = number;
  forgetRefusal();
  setValue(number);
}

void NumberField::commit() {
  interpretText();
  reportIfChanged();
}

void NumberField::setShownAs(QString (*write)(double)) {
  m_write = write;
  setNumber(m_number);
}

void NumberField::stepBy(int steps) {
  QDoubleSpinBox::stepBy(steps);
  reportIfChanged();
}

QString NumberField::textFromValue(double value) const {
  return m_write ? m_write(value) : plainNumber(value, decimals());
}

QValidator::State NumberField::validate(QString& text, int& position) const {
  const QString point = locale().decimalPoint();
  text.replace(QLatin1Char(point == QLatin1String(",") ? '.' : ','), point);
  text.replace(QChar(0x2212), QLatin1Char('-'));
  // What does not fit can be typed, or "10" would become 1 without a word; it is refused when it is done.
  const std::optional<double> number = read(text);
  if (number && (*number < minimum() || *number > maximum()))
    return QValidator::Intermediate;
  if (text.trimmed() == QLatin1String("-"))
    return QValidator::Intermediate;
  if (number && m_takesPercent && (text.endsWith(QLatin1Char('%')) || text.endsWith(QLatin1Char(' '))))
    return QValidator::Acceptable;
  return QDoubleSpinBox::validate(text, position);
}

// Without suffix, in the user's locale.
std::optional<double> NumberField::read(const QString& text) const {
  QString plain = text;
  if (!suffix().isEmpty() && plain.endsWith(suffix()))
    plain.chop(suffix().size());
  plain = plain.trimmed();
  const bool isPercent = m_takesPercent && plain.endsWith(QLatin1Char('%'));
  if (isPercent)
    plain = plain.chopped(1).trimmed();
  bool isNumber = false;
  const double number = locale().toDouble(plain, &isNumber);
  if (!isNumber)
    return std::nullopt;
  return isPercent ? number / 100.0 : number;
}

double NumberField::valueFromText(const QString& text) const {
  return read(text).value_or(m_number);
}

// Asked of what is no number or does not fit, before the one before comes back.
void NumberField::fixup(QString& text) const {
  if (const std::optional<double> number = read(text); number && (*number < minimum() || *number > maximum()))
    const_cast<NumberField*>(this)->refuse(text); // Qt asks a constant object
}

void NumberField::refuse(const QString& text) {
  const QString lowest = textFromValue(minimum()) + suffix(), highest = textFromValue(maximum()) + suffix();
  m_refusal = (m_takesPercent ? tr("%1 does not fit: give a number from %2 to %3, or per cent such as 10 %.")
                              : tr("%1 does not fit: give a number from %2 to %3."))
                  .arg(text.trimmed(), lowest, highest);
  setAccessibleDescription(m_refusal);
  if (isVisible())
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), m_refusal, this, {}, refusalMs);
  update();
}

void NumberField::forgetRefusal() {
  if (m_refusal.isEmpty())
    return;
  m_refusal.clear();
  setAccessibleDescription({});
  update();
}

void NumberField::paintEvent(QPaintEvent* event) {
  QDoubleSpinBox::paintEvent(event);
  if (m_refusal.isEmpty())
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(refusedColor, 2.0));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 3.0, 3.0);
}

bool NumberField::event(QEvent* event) {
  // Undo belongs to the text while one types, and to the program before and after.
  if (event->type() == QEvent::ShortcutOverride && !lineEdit()->isModified()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QDoubleSpinBox::event(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore(); // so that scrolling a panel changes nothing on the way
}

void NumberField::reportIfChanged() {
  lineEdit()->setModified(false);
  // The display rounds: an untouched field must not replace the exact number by its rounding.
  const double shownBefore =
      std::clamp(QString::number(m_number, 'f', decimals()).toDouble(), minimum(), maximum());
  // What was read back from the text may be rounded further.
  const double readBefore = valueFromText(textFromValue(shownBefore));
  if (value() == shownBefore || value() == readBefore)
    return;
  m_number = value();
  emit numberEdited(m_number);
}

} // namespace limn
