// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace limn {

/// A spin box that reports only what the user did: typing (when finished), arrows, wheel while focused. It
/// keeps the exact number it was given, whatever it rounds for display, and shows no trailing zeros. A number
/// that does not fit is refused with a red edge and a sentence that says what fits; the one before stays.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT

public:
  /// Numbers lie within lowest..highest; `decimals` limits what can be shown.
  NumberField(double lowest, double highest, int decimals, QWidget* parent = nullptr);

  /// Other limits; the number stays.
  void setLimits(double lowest, double highest, int decimals);

  void setNumber(double number);
  double number() const { return m_number; }

  /// Takes what was typed, as Enter does.
  void commit();

  /// Shows numbers as `write` does them, which may round more than `decimals` says.
  void setShownAs(QString (*write)(double));

  /// "10 %" means 0.1.
  void setTakesPercent(bool takes) { m_takesPercent = takes; }

  /// Why the last number was refused; empty once another is typed.
  const QString& refusal() const { return m_refusal; }

  void stepBy(int steps) override;
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  /// A decimal point or comma, whichever was typed, becomes that of the user's locale.
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;

signals:
  void numberEdited(double number);

protected:
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  std::optional<double> read(const QString& text) const;
  void refuse(const QString& text);
  void forgetRefusal();
  void reportIfChanged();

  double m_number = 0.0;
  bool m_takesPercent = false;
  QString m_refusal;
  QString (*m_write)(double) = nullptr;
};

} // namespace limn
