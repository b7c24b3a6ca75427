// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include <optional>

class QPainter;
class QTimer;

namespace limn {

/// A spin box that reports only what the user did: typing (when finished), arrows, wheel while focused. It
/// keeps the exact number it was given, whatever it rounds for display, and shows no trailing zeros. It
/// writes the real minus sign, and reads that and the hyphen of a keyboard. A double click selects the number
/// without its unit. A number that does not fit is
/// refused with a red edge and a sentence that says what fits; the one before stays. The edge goes with the
/// focus, or where that is refused which a field is left with, as the sentence does.
class NumberField : public QDoubleSpinBox {
  Q_OBJECT

public:
  /// Numbers lie within lowest..highest; `decimals` limits what can be shown.
  NumberField(double lowest, double highest, int decimals, QWidget* parent = nullptr);

  /// Other limits; the number stays.
  void setLimits(double lowest, double highest, int decimals);

  /// What fits now, where something else leaves less than the limits: another number that may not be passed.
  /// The width stays. Until limits are set.
  void setBounds(double lowest, double highest);

  void setNumber(double number);
  double number() const { return m_number; }

  /// It stands for several numbers that differ: it shows none of them, and what is typed is reported whatever
  /// it is. Until a number is set or typed.
  void setMixed();
  bool isMixed() const { return m_isMixed; }

  /// What was set, in place of what was typed since.
  void takeBack();

  /// Takes what was typed and marks the number, as Enter does; false where it was refused.
  bool commit();

  /// The unit behind the number; `ofOne` is the word behind 1 where that is another, and can be typed, too.
  void setUnit(const QString& unit, const QString& ofOne = {});

  /// Shows numbers as `write` does them, which may round more than `decimals` says.
  void setShownAs(QString (*write)(double));

  /// It takes the width of its widest number with its unit, and no less than that of `leastText`, so that
  /// several of them are as wide as each other.
  void setFitted(const QString& leastText);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override {
    return m_leastText ? sizeHint() : QDoubleSpinBox::minimumSizeHint();
  }

  /// "10 %" means 0.1.
  void setTakesPercent(bool takes) { m_takesPercent = takes; }

  /// A second unit that can be typed behind a number: `factor` of the field's own are one of it. What is
  /// typed so keeps the digits that the field does not show. Empty: none.
  void setOtherUnit(const QString& unit, double factor);

  /// Why the last number was refused; empty once another is typed, or the field is left alone.
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
  void focusOutEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  std::optional<double> read(const QString& text) const;
  bool isInOtherUnit(const QString& text) const;
  double fromOtherUnit(double number) const;
  void noteTyped(const QString& text);
  void selectNumber();
  QString asTyped(const QString& text) const;
  void refuse(const QString& text);
  void forgetRefusal();
  void reportIfChanged();
  void showUnit();
  QString written(double value) const;
  QString usualSuffix() const; ///< that behind most numbers
  QStringList widestTexts() const;
  /// The suffix, where a text ends with it.
  QString unitOf(const QString& text) const;

  double m_number = 0.0;
  double m_lowest, m_highest;  ///< the limits
  QString m_unit, m_unitOfOne; ///< empty: none, or the same
  bool m_takesPercent = false;
  bool m_isMixed = false;
  bool m_isTyped = false; ///< something, since it is mixed
  QString m_otherUnit;    ///< empty: none
  double m_otherFactor = 1.0;
  std::optional<double> m_typedInOther; ///< the number, unrounded, while it stands in the field
  QString m_refusal;
  QTimer* m_refusalStands;            ///< in a field that was left with what is refused
  std::optional<QString> m_leastText; ///< where it is as wide as its numbers
  QString (*m_write)(double) = nullptr;
};

/// Says below a field why what was typed in it was refused, where it is seen.
void sayRefusal(QWidget& field, const QString& sentence);

/// The red edge of a field whose text was refused, within `field`.
void paintRefusedEdge(QPainter& painter, const QRectF& field);

} // namespace limn
