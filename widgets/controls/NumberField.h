// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace limn {

/// A spin box that reports only what the user did: typing (when finished), arrows, wheel while focused. It
/// keeps the exact number it was given, whatever it rounds for display, and shows no trailing zeros.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT

public:
  /// Numbers are limited to lowest..highest when typed; `decimals` limits what can be shown.
  NumberField(double lowest, double highest, int decimals, QWidget* parent = nullptr);

  /// Other limits; the number stays.
  void setLimits(double lowest, double highest, int decimals);

  void setNumber(double number);
  double number() const { return m_number; }

  /// Takes what was typed, as Enter does.
  void commit();

  /// Shows numbers as `write` does them, which may round more than `decimals` says.
  void setShownAs(QString (*write)(double));

  void stepBy(int steps) override;
  QString textFromValue(double value) const override;
  /// A decimal point or comma, whichever was typed, becomes that of the user's locale.
  QValidator::State validate(QString& text, int& position) const override;

signals:
  void numberEdited(double number);

protected:
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  void reportIfChanged();

  double m_number = 0.0;
  QString (*m_write)(double) = nullptr;
};

} // namespace limn
