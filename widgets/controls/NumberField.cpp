// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/NumberField.h"

#include "widgets/ValueText.h"
#include "widgets/controls/FoldingSection.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace limn {
namespace {

constexpr int refusalMs = 8000;
constexpr int otherDecimals = 1;                 // of limits in the other unit
constexpr QColor refusedColor(0xd1, 0x34, 0x38); // 3:1 at least on light and on dark fields
constexpr int besideText = 6;                    // the margins of the line edit and the cursor

// A double click takes what `select` does, and keeps that while the button is held.
class NumberEdit : public QLineEdit {
public:
  explicit NumberEdit(std::function<void()> select) : m_select(std::move(select)) {
    setObjectName(QStringLiteral("qt_spinbox_lineedit")); // as styles know that of a spin box
  }

protected:
  void mousePressEvent(QMouseEvent* event) override {
    m_isHeld = false;
    QLineEdit::mousePressEvent(event);
  }
  void mouseDoubleClickEvent(QMouseEvent* event) override {
    QLineEdit::mouseDoubleClickEvent(event);
    m_isHeld = event->button() == Qt::LeftButton;
    if (m_isHeld)
      m_select();
  }
  void mouseMoveEvent(QMouseEvent* event) override {
    if (!m_isHeld)
      QLineEdit::mouseMoveEvent(event);
  }

private:
  std::function<void()> m_select;
  bool m_isHeld = false; ///< the second press of a double click
};

// As the spin box and locales read it.
QString withHyphen(QString text) {
  return text.replace(minusSign, QLatin1Char('-'));
}

} // namespace

NumberField::NumberField(double lowest, double highest, int decimals, QWidget* parent)
    : QDoubleSpinBox(parent), m_lowest(lowest), m_highest(highest), m_refusalStands(new QTimer(this)) {
  m_refusalStands->setObjectName(QStringLiteral("refusalStands"));
  setLineEdit(new NumberEdit([this] { selectNumber(); })); // which the spin box owns
  setDecimals(decimals);
  setRange(lowest, highest);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setFocusPolicy(Qt::StrongFocus); // the wheel would give it the keyboard on its way through a panel
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
  setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  setNumber(std::clamp(0.0, lowest, highest));
  connect(this, &QAbstractSpinBox::editingFinished, this, &NumberField::reportIfChanged);
  connect(lineEdit(), &QLineEdit::textEdited, this, &NumberField::noteTyped);
  m_refusalStands->setSingleShot(true);
  m_refusalStands->setInterval(refusalMs);
  connect(m_refusalStands, &QTimer::timeout, this, &NumberField::forgetRefusal);
}

void NumberField::setLimits(double lowest, double highest, int decimals) {
  const double number = m_number; // the spin box would limit and round what it shows
  setDecimals(decimals);
  m_lowest = lowest;
  m_highest = highest;
  setRange(lowest, highest);
  setNumber(number);
  updateGeometry();
}

void NumberField::setBounds(double lowest, double highest) {
  const double number = m_number;
  setRange(lowest, highest);
  setNumber(number);
}

void NumberField::setNumber(double number) {
  m_isMixed = false;
  m_number = number;
  m_typedInOther.reset();
  forgetRefusal();
  lineEdit()->setPlaceholderText({});
  setValue(number);
  if (!m_unitOfOne.isEmpty())
    showUnit();
}

void NumberField::setMixed() {
  m_isMixed = true;
  m_isTyped = false;
  forgetRefusal();
  lineEdit()->setPlaceholderText(QStringLiteral("–"));
  setValue(value()); // has its text written anew
}

void NumberField::takeBack() {
  if (m_isMixed)
    setMixed();
  else
    setNumber(m_number);
}

void NumberField::setUnit(const QString& unit, const QString& ofOne) {
  m_unit = unit;
  m_unitOfOne = ofOne;
  showUnit();
}

void NumberField::setOtherUnit(const QString& unit, double factor) {
  m_otherUnit = unit;
  m_otherFactor = factor;
}

void NumberField::showUnit() {
  const bool isOne = !m_unitOfOne.isEmpty() && written(m_number) == written(1.0);
  if (const QString shown = withUnit({}, isOne ? m_unitOfOne : m_unit); shown != suffix())
    setSuffix(shown);
}

QString NumberField::usualSuffix() const {
  return m_unitOfOne.isEmpty() ? suffix() : withUnit({}, m_unit);
}

bool NumberField::commit() {
  interpretText();
  selectAll();
  reportIfChanged();
  return m_refusal.isEmpty();
}

void NumberField::setShownAs(QString (*write)(double)) {
  m_write = write;
  setNumber(m_number);
}

// From a number that is not seen no step leads anywhere.
void NumberField::stepBy(int steps) {
  if (m_isMixed)
    return;
  QDoubleSpinBox::stepBy(steps);
  reportIfChanged();
}

QString NumberField::textFromValue(double value) const {
  return m_isMixed ? QString() : written(value);
}

QString NumberField::written(double value) const {
  return m_write ? m_write(value) : plainNumber(value, decimals());
}

void NumberField::setFitted(const QString& leastText) {
  m_leastText = leastText;
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  updateGeometry();
}

// Trailing zeros are not shown: just inside of a limit numbers have all their decimals.
QStringList NumberField::widestTexts() const {
  const double last = std::pow(10.0, -decimals());
  QStringList texts;
  for (const double number : {m_lowest, m_lowest + last, m_highest - last, m_highest})
    texts << written(number) + usualSuffix();
  return texts << *m_leastText;
}

QSize NumberField::sizeHint() const {
  if (!m_leastText)
    return QDoubleSpinBox::sizeHint();
  ensurePolished(); // the style has a say in the font
  int widest = 0;
  for (const QString& text : widestTexts())
    widest = std::max(widest, fontMetrics().horizontalAdvance(text));
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  const QSize contents(widest + besideText, lineEdit()->sizeHint().height());
  return style()->sizeFromContents(QStyle::CT_SpinBox, &option, contents, this);
}

QValidator::State NumberField::validate(QString& text, int& position) const {
  const QString point = locale().decimalPoint();
  const QString unit = unitOf(text); // which may hold a hyphen or a point of its own
  QString shown = text.chopped(unit.size());
  shown.replace(QLatin1Char('-'), minusSign); // also while one types
  shown.replace(QLatin1Char(point == QLatin1String(",") ? '.' : ','), point);
  text = shown + unit;
  // What does not fit can be typed, or "10" would become 1 without a word; it is refused when it is done.
  const std::optional<double> number = read(text);
  if (number && (*number < minimum() || *number > maximum()))
    return QValidator::Intermediate;
  if (text.trimmed() == minusSign)
    return QValidator::Intermediate;
  if (number && isInOtherUnit(text))
    return QValidator::Acceptable;
  if (number && m_takesPercent && (text.endsWith(QLatin1Char('%')) || text.endsWith(QLatin1Char(' '))))
    return QValidator::Acceptable;
  QString typed = withHyphen(shown) + unit;
  const int cursor = position;
  const QValidator::State state = QDoubleSpinBox::validate(typed, position); // which may add the unit
  text = shown + unitOf(typed);
  if (state != QValidator::Invalid)
    return state;
  position = cursor; // the spin box would have taken the last letter out
  // Letters can be typed, too: left out without a word they would make another number, 81 of 8x1.
  return number ? QValidator::Acceptable : QValidator::Intermediate;
}

QString NumberField::unitOf(const QString& text) const {
  return text.endsWith(suffix()) ? suffix() : QString();
}

// The point in a number would part words, and what is typed next leaves the unit.
void NumberField::selectNumber() {
  const QString text = lineEdit()->text();
  lineEdit()->setSelection(0, static_cast<int>(text.size() - unitOf(text).size()));
}

// Without suffix, in the user's locale.
std::optional<double> NumberField::read(const QString& text) const {
  QString plain = withHyphen(text.chopped(unitOf(text).size())).trimmed();
  for (const QString& unit : {suffix().trimmed(), m_unit, m_unitOfOne, m_otherUnit})
    if (!unit.isEmpty() && plain.endsWith(unit)) { // typed by hand
      plain = plain.chopped(unit.size()).trimmed();
      break;
    }
  const bool isPercent = m_takesPercent && plain.endsWith(QLatin1Char('%'));
  if (isPercent)
    plain = plain.chopped(1).trimmed();
  bool isNumber = false;
  const double number = locale().toDouble(plain, &isNumber);
  if (!isNumber || !std::isfinite(number)) // "nan" is a number, too
    return std::nullopt;
  if (isInOtherUnit(text))
    return fromOtherUnit(number);
  return isPercent ? number / 100.0 : number;
}

// The limit that is told in the other unit is rounded, and fits as it is told.
double NumberField::fromOtherUnit(double number) const {
  const double own = m_otherFactor * number, rounding = 0.5 * std::pow(10.0, -otherDecimals) * m_otherFactor;
  return own > maximum() + rounding || own < minimum() - rounding ? own
                                                                  : std::clamp(own, minimum(), maximum());
}

// The spin box keeps its own unit behind what is typed.
bool NumberField::isInOtherUnit(const QString& text) const {
  return !m_otherUnit.isEmpty() && text.chopped(unitOf(text).size()).trimmed().endsWith(m_otherUnit);
}

void NumberField::noteTyped(const QString& text) {
  m_isTyped = !text.trimmed().isEmpty();
  m_typedInOther = isInOtherUnit(text) ? read(text) : std::nullopt;
  forgetRefusal();
}

// As it is shown: more digits can be typed.
double NumberField::valueFromText(const QString& text) const {
  const std::optional<double> number = read(text);
  return number ? QString::number(*number, 'f', decimals()).toDouble() : m_number;
}

// Asked of what is no number or does not fit, before the one before comes back.
void NumberField::fixup(QString& text) const {
  if (text.chopped(unitOf(text).size()).trimmed().isEmpty())
    return;
  const std::optional<double> number = read(text);
  if (!number || *number < minimum() || *number > maximum())
    const_cast<NumberField*>(this)->refuse(text); // Qt asks a constant object
}

// A number with its unit, once; what is none as it was typed, without the unit that stood behind it.
QString NumberField::asTyped(const QString& text) const {
  const QString typed = text.chopped(unitOf(text).size()).trimmed();
  const bool hasUnit = (m_takesPercent && typed.endsWith(QLatin1Char('%'))) ||
                       (!m_unit.isEmpty() && typed.endsWith(m_unit)) ||
                       (!m_otherUnit.isEmpty() && typed.endsWith(m_otherUnit)) ||
                       (!m_unitOfOne.isEmpty() && typed.endsWith(m_unitOfOne)) ||
                       (!suffix().trimmed().isEmpty() && typed.endsWith(suffix().trimmed()));
  return read(text) && !hasUnit ? typed + unitOf(text) : typed;
}

void NumberField::refuse(const QString& text) {
  const QString unit = usualSuffix();
  const QString lowest = written(minimum()) + unit, highest = written(maximum()) + unit,
                typed = asTyped(text);
  if (!m_otherUnit.isEmpty())
    m_refusal =
        tr("%1 does not fit: give a number from %2 to %3, or from %4 to %5.")
            .arg(typed, lowest, highest, valueText(minimum() / m_otherFactor, m_otherUnit, otherDecimals),
                 valueText(maximum() / m_otherFactor, m_otherUnit, otherDecimals));
  else
    m_refusal =
        (m_takesPercent ? tr("%1 does not fit: give a number from %2 to %3, or per cent such as 10 %.")
                        : tr("%1 does not fit: give a number from %2 to %3."))
            .arg(typed, lowest, highest);
  setAccessibleDescription(m_refusal);
  sayRefusal(*this, m_refusal);
  update();
}

void NumberField::forgetRefusal() {
  if (m_refusal.isEmpty())
    return;
  m_refusal.clear();
  m_refusalStands->stop();
  setAccessibleDescription({});
  update();
}

void NumberField::paintEvent(QPaintEvent* event) {
  QDoubleSpinBox::paintEvent(event);
  if (m_refusal.isEmpty())
    return;
  QPainter painter(this);
  paintRefusedEdge(painter, rect());
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
  if (takesWheel(*this))
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore(); // so that scrolling a panel changes nothing on the way
}

// What it is left with may be refused right now: that is seen for a while. What was refused before is over.
void NumberField::focusOutEvent(QFocusEvent* event) {
  const bool wasRefused = !m_refusal.isEmpty();
  QDoubleSpinBox::focusOutEvent(event);
  if (wasRefused)
    forgetRefusal();
  else if (!m_refusal.isEmpty())
    m_refusalStands->start();
}

void NumberField::reportIfChanged() {
  lineEdit()->setModified(false);
  const std::optional<double> exact = std::exchange(m_typedInOther, std::nullopt);
  if (m_isMixed) {
    if (!std::exchange(m_isTyped, false) || !m_refusal.isEmpty())
      return;
    setNumber(value());
    emit numberEdited(m_number);
    return;
  }
  if (exact && value() == QString::number(*exact, 'f', decimals()).toDouble()) {
    if (std::exchange(m_number, *exact) != *exact)
      emit numberEdited(m_number);
    return;
  }
  // The display rounds: an untouched field must not replace the exact number by its rounding.
  const double shownBefore =
      std::clamp(QString::number(m_number, 'f', decimals()).toDouble(), minimum(), maximum());
  // What was read back from the text may be rounded further.
  const double readBefore = valueFromText(written(shownBefore));
  if (value() == shownBefore || value() == readBefore)
    return;
  m_number = value();
  emit numberEdited(m_number);
}

void sayRefusal(QWidget& field, const QString& sentence) {
  // Once the focus has gone where it is going: that hides every tip.
  QTimer::singleShot(0, &field, [&field, sentence] {
    if (field.isVisible())
      QToolTip::showText(field.mapToGlobal(field.rect().bottomLeft()), sentence, &field, {}, refusalMs);
  });
}

void paintRefusedEdge(QPainter& painter, const QRectF& field) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(refusedColor, 2.0));
  painter.drawRoundedRect(field.adjusted(1.0, 1.0, -1.0, -1.0), 3.0, 3.0);
}

} // namespace limn
