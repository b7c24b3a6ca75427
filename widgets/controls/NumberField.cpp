// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/NumberField.h"

#include "widgets/ValueText.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWheelEvent>

namespace limn {

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
}

void NumberField::setLimits(double lowest, double highest, int decimals) {
  const double number = m_number; // the spin box would limit and round what it shows
  setDecimals(decimals);
  setRange(lowest, highest);
  setNumber(number);
}

void NumberField::setNumber(double number) {
  m_number = number;
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
  return QDoubleSpinBox::validate(text, position);
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
