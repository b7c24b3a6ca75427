// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ColorPicker.h"

#include "widgets/controls/NumberField.h"
#include "widgets/controls/Popups.h"
#include "widgets/theme/Theme.h"

#include <QFrame>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

constexpr std::array<const char*, 8> swatches{"#f4ecd8", "#f0cf7a", "#e0a98c", "#a8473d",
                                              "#d8261c", "#e6b7b0", "#8fb8d8", "#cfd6de"};

QString swatchName(int index) {
  const std::array<QString, swatches.size()> names{
      ColorPicker::tr("Bone"),   ColorPicker::tr("Fat"),   ColorPicker::tr("Skin"), ColorPicker::tr("Muscle"),
      ColorPicker::tr("Vessel"), ColorPicker::tr("Brain"), ColorPicker::tr("Lung"), ColorPicker::tr("Metal")};
  return names[static_cast<std::size_t>(index)];
}

constexpr double barWidth = 16.0;
constexpr double gap = 8.0;
constexpr double rowHeight = 26.0;
constexpr double ringRadius = 6.0;
constexpr double markReach = ringRadius + 2.0; // of what shows the colour in the field, with half its line
constexpr double keyShare = 0.01;              // of the field and the hues, at one press

QColor swatch(int index) {
  return QColor(QLatin1String(swatches[static_cast<std::size_t>(index)]));
}

// A hex code with or without its sign, or a name; what is a code is never a name. None that one sees through.
QColor typedColor(const QString& text) {
  const QColor code(text.startsWith('#') ? text : '#' + text);
  const QColor color = code.isValid() ? code : QColor(text);
  return color.alpha() == 255 ? color : QColor();
}

// Closes on a click elsewhere and on Enter, which keep what was picked, and on Esc.
class PickerPopup : public QFrame {
public:
  PickerPopup(ColorPicker& picker, QWidget* parent) : QFrame(parent, Qt::Popup), m_picker(picker) {
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(&picker);
    auto* ends = new QLabel(ColorPicker::tr("Enter keeps it, Esc takes it back."));
    ends->setForegroundRole(QPalette::PlaceholderText);
    ends->setWordWrap(true);
    layout->addWidget(ends);
  }

protected:
  void keyPressEvent(QKeyEvent* event) override {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && m_picker.refusal().isEmpty())
      close();
    if (isEnter)
      return;
    if (event->matches(QKeySequence::Cancel))
      m_picker.takeBack();
    QFrame::keyPressEvent(event);
  }

private:
  ColorPicker& m_picker;
};

} // namespace

ColorPicker::ColorPicker(QWidget* parent) : QWidget(parent), m_hex(new QLineEdit(this)) {
  setMinimumWidth(sizeHint().width());
  setFixedHeight(sizeHint().height());
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Colour"));
  setAccessibleDescription(tr("Arrows: saturation and brightness. Page Up, Page Down: hue. 1 to 8: the "
                              "colours of tissues."));
  m_hex->setAccessibleName(tr("Colour as hex code"));
  m_hex->setToolTip(tr("The colour as a hex code, from #000000 (black) to #ffffff (white)"));
  connect(m_hex, &QLineEdit::editingFinished, this, &ColorPicker::takeTyped);
  connect(m_hex, &QLineEdit::textEdited, this, [this] { refuse({}); });
}

// As it was typed, where it is no colour: it is seen what was wrong.
void ColorPicker::takeTyped() {
  const QString text = m_hex->text().trimmed();
  if (text.isEmpty())
    return m_hex->setText(shown().name());
  const QColor typed = typedColor(text);
  if (!typed.isValid())
    return refuse(tr("%1 is no colour: give a hex code such as %2.").arg(text, shown().name()));
  if (typed.rgb() != shown().rgb())
    pick(typed);
  else
    m_hex->setText(typed.name());
}

void ColorPicker::refuse(const QString& refusal) {
  const bool isNews = refusal != m_refusal;
  m_refusal = refusal;
  m_hex->setAccessibleDescription(refusal);
  if (!isNews)
    return;
  placeHex();
  update();
  if (refusal.isEmpty())
    return;
  m_hex->selectAll(); // to be typed once more
  sayRefusal(*m_hex, refusal);
}

void ColorPicker::focusCode() {
  m_hex->setFocus(Qt::PopupFocusReason);
  m_hex->selectAll();
}

QColor ColorPicker::shown() const {
  return QColor::fromHsvF(float(m_hue), float(m_saturation), float(m_brightness));
}

void ColorPicker::setColor(const glm::dvec3& color) {
  m_before = color;
  m_gestureId = 0;
  showColor(toQColor(color));
}

void ColorPicker::takeBack() {
  const std::uint64_t gesture = m_gestureId;
  setColor(m_before);
  if (gesture == 0)
    return;
  emit colorPicked(m_before, gesture);
  emit takenBack(gesture);
}

void ColorPicker::showColor(const QColor& wanted) {
  m_hex->setText(wanted.name());
  refuse({});
  if (wanted.rgb() == shown().rgb())
    return;
  const QColor hsv = wanted.toHsv();
  if (hsv.hsvHueF() >= 0.0f)
    m_hue = hsv.hsvHueF();
  m_saturation = hsv.hsvSaturationF();
  m_brightness = hsv.valueF();
  update();
}

QRectF ColorPicker::fieldRect() const {
  return {0.0, 0.0, width() - barWidth - gap, height() - 2.0 * (rowHeight + gap)};
}

QRectF ColorPicker::hueRect() const {
  return {width() - barWidth, 0.0, barWidth, fieldRect().height()};
}

// At its corners, too, the ring is seen whole.
QRectF ColorPicker::shadesRect() const {
  return fieldRect().adjusted(markReach, markReach, -markReach, -markReach);
}

QRectF ColorPicker::huesRect() const {
  return hueRect().adjusted(0.0, markReach, 0.0, -markReach);
}

QRectF ColorPicker::swatchRect(int index) const {
  const double pitch = (width() + 4.0) / swatches.size();
  const double left = std::round(index * pitch); // whole pixels, or frames blur
  return {left, fieldRect().bottom() + gap, std::round((index + 1) * pitch) - 4.0 - left, rowHeight};
}

std::optional<int> ColorPicker::swatchAt(const QPointF& position) const {
  for (int i = 0; i < static_cast<int>(swatches.size()); ++i)
    if (swatchRect(i).contains(position))
      return i;
  return std::nullopt;
}

bool ColorPicker::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  if (const std::optional<int> index = swatchAt(help.pos()))
    QToolTip::showText(help.globalPos(), tr("%1 (key %2)").arg(swatchName(*index)).arg(*index + 1), this,
                       swatchRect(*index).toRect());
  else
    QToolTip::hideText();
  return true;
}

void ColorPicker::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);

  QLinearGradient toHue(shadesRect().topLeft(), shadesRect().topRight());
  toHue.setColorAt(0.0, Qt::white);
  toHue.setColorAt(1.0, QColor::fromHsvF(float(m_hue), 1.0f, 1.0f));
  QLinearGradient toBlack(shadesRect().topLeft(), shadesRect().bottomLeft());
  toBlack.setColorAt(0.0, QColor(0, 0, 0, 0));
  toBlack.setColorAt(1.0, Qt::black);
  for (const QLinearGradient& gradient : {toHue, toBlack}) {
    painter.setBrush(gradient);
    painter.drawRoundedRect(fieldRect(), 4.0, 4.0);
  }

  QLinearGradient hues(huesRect().topLeft(), huesRect().bottomLeft());
  for (int i = 0; i <= 6; ++i)
    hues.setColorAt(i / 6.0, QColor::fromHsvF(float(i % 6) / 6.0f, 1.0f, 1.0f));
  painter.setBrush(hues);
  painter.drawRoundedRect(hueRect(), 4.0, 4.0);
  paintSwatches(painter);

  const QPointF place(shadesRect().left() + m_saturation * shadesRect().width(),
                      shadesRect().bottom() - m_brightness * shadesRect().height());
  const double hueY = huesRect().top() + m_hue * huesRect().height();
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, thickness] : {std::pair{QColor(Qt::black), 4.0}, {QColor(Qt::white), 2.0}}) {
    painter.setPen(QPen(color, thickness));
    painter.drawEllipse(place, ringRadius, ringRadius);
    painter.drawRoundedRect(QRectF(hueRect().left() + 2.0, hueY - 3.0, barWidth - 4.0, 6.0), 2.0, 2.0);
  }
  if (hasFocus()) { // two rings: one of them stands out from whatever colour is there
    painter.setPen(QPen(themeColors(palette()).accent, 2.0));
    painter.drawRoundedRect(fieldRect().adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
    painter.setPen(QPen(themeColors(palette()).base, 1.0));
    painter.drawRoundedRect(fieldRect().adjusted(2.5, 2.5, -2.5, -2.5), 3.0, 3.0);
  }
  if (!m_refusal.isEmpty()) // around the field of the code
    paintRefusedEdge(painter, QRectF(m_hex->geometry()).adjusted(-2.0, -2.0, 2.0, 2.0));
}

void ColorPicker::paintSwatches(QPainter& painter) const {
  painter.setPen(themeColors(palette()).border);
  for (int i = 0; i < static_cast<int>(swatches.size()); ++i) {
    painter.setBrush(swatch(i));
    painter.drawRoundedRect(swatchRect(i).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  }
}

void ColorPicker::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  const QPointF position = event->position();
  m_part = fieldRect().contains(position) ? Part::field : Part::none;
  if (position.x() >= hueRect().left() && position.y() <= hueRect().bottom())
    m_part = Part::hue;
  if (const std::optional<int> index = swatchAt(position))
    return pick(swatch(*index));
  pickAt(position);
}

void ColorPicker::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    pickAt(event->position());
}

void ColorPicker::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? 10.0 * keyShare : keyShare;
  const int digit = event->key() - Qt::Key_1;
  if (digit >= 0 && digit < static_cast<int>(swatches.size()))
    return pick(swatch(digit));
  switch (event->key()) {
  case Qt::Key_Left:
  case Qt::Key_Right:
    m_saturation = std::clamp(m_saturation + (event->key() == Qt::Key_Left ? -step : step), 0.0, 1.0);
    return pickShown();
  case Qt::Key_Down:
  case Qt::Key_Up:
    m_brightness = std::clamp(m_brightness + (event->key() == Qt::Key_Down ? -step : step), 0.0, 1.0);
    return pickShown();
  case Qt::Key_PageUp:
  case Qt::Key_PageDown: // hues are a circle
    m_hue += event->key() == Qt::Key_PageUp ? -step : step;
    m_hue -= std::floor(m_hue);
    return pickShown();
  default:
    return QWidget::keyPressEvent(event);
  }
}

void ColorPicker::resizeEvent(QResizeEvent*) {
  placeHex();
}

// A red edge has room around it.
void ColorPicker::placeHex() {
  const QRect row(0, height() - static_cast<int>(rowHeight), width(), static_cast<int>(rowHeight));
  const int edge = m_refusal.isEmpty() ? 0 : 2;
  m_hex->setGeometry(row.adjusted(edge, -edge, -edge, -edge)); // as high as before: it cannot be lower
}

void ColorPicker::pickAt(const QPointF& position) {
  const QRectF shades = shadesRect();
  if (m_part == Part::none)
    return;
  if (m_part == Part::hue) {
    m_hue = std::clamp((position.y() - huesRect().top()) / huesRect().height(), 0.0, 0.999);
  } else {
    m_saturation = std::clamp((position.x() - shades.left()) / shades.width(), 0.0, 1.0);
    m_brightness = std::clamp((shades.bottom() - position.y()) / shades.height(), 0.0, 1.0);
  }
  pickShown();
}

void ColorPicker::pickShown() {
  pick(shown());
}

void ColorPicker::pick(const QColor& color) {
  if (m_gestureId == 0)
    m_gestureId = nextGestureId();
  showColor(color);
  update();
  emit colorPicked(toSceneColor(color), m_gestureId);
}

ColorPicker* openColorPicker(const glm::dvec3& color, const QRect& anchor, QWidget* parent) {
  auto* picker = new ColorPicker;
  picker->setColor(color);
  showPopupAt(*new PickerPopup(*picker, parent), anchor);
  picker->focusCode();
  return picker;
}

ColorButton::ColorButton(const QString& undoText, QWidget* parent)
    : QAbstractButton(parent), m_undoText(undoText) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setAccessibleName(tr("Colour"));
  connect(this, &QAbstractButton::clicked, this, &ColorButton::openPicker);
}

void ColorButton::setColors(const std::vector<glm::dvec3>& colors) {
  m_colors.clear();
  for (const glm::dvec3& color : colors)
    if (std::ranges::find(m_colors, color) == m_colors.end())
      m_colors.push_back(color);
  update();
}

// Beside each other, without a seam that none of the points has.
static QBrush stripesOf(const std::vector<glm::dvec3>& colors, int width) {
  if (colors.size() == 1)
    return toQColor(colors.front());
  QLinearGradient stripes(0.0, 0.0, width, 0.0);
  const auto count = static_cast<double>(colors.size());
  for (std::size_t n = 0; n < colors.size(); ++n) {
    const QColor color = toQColor(colors[n]);
    stripes.setColorAt(static_cast<double>(n) / count, color);
    stripes.setColorAt((static_cast<double>(n) + 0.999) / count, color);
  }
  return stripes;
}

void ColorButton::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(isEnabled() ? 1.0 : 0.35);
  painter.setBrush(stripesOf(m_colors, width()));
  const bool lively = hasFocus() || underMouse();
  painter.setPen(QPen(lively ? colors.accent : colors.outline, 1.0));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  if (!hasFocus())
    return;
  // Two rings: one of them stands out from whatever colour this is.
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 3.0, 3.0);
  painter.setPen(QPen(colors.base, 1.0));
  painter.drawRoundedRect(QRectF(rect()).adjusted(2.5, 2.5, -2.5, -2.5), 2.0, 2.0);
}

void ColorButton::openPicker() {
  const ColorPicker* picker = openColorPicker(color(), QRect(mapToGlobal(QPoint(0, 0)), size()), this);
  connect(picker, &ColorPicker::colorPicked, this, [this](const glm::dvec3& color, std::uint64_t id) {
    setColor(color);
    emit colorEdited(color, {id, m_undoText});
  });
  connect(picker, &ColorPicker::takenBack, this, &ColorButton::takenBack);
}

} // namespace limn
