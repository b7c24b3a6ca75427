// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ColorPicker.h"

#include "widgets/controls/Popups.h"
#include "widgets/theme/Theme.h"

#include <QFrame>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

// Bone, fat, skin, muscle, vessel, brain, lung, metal.
constexpr std::array<const char*, 8> swatches{"#f4ecd8", "#f0cf7a", "#e0a98c", "#a8473d",
                                              "#d8261c", "#e6b7b0", "#8fb8d8", "#cfd6de"};

constexpr double barWidth = 16.0;
constexpr double gap = 8.0;
constexpr double rowHeight = 26.0;

// Closes on a click elsewhere, which keeps what was picked, and on Esc.
class PickerPopup : public QFrame {
public:
  PickerPopup(ColorPicker& picker, QWidget* parent) : QFrame(parent, Qt::Popup), m_picker(picker) {
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(&picker);
  }

protected:
  void keyPressEvent(QKeyEvent* event) override {
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
  setAccessibleName(tr("Colour"));
  m_hex->setAccessibleName(tr("Colour as hex code"));
  m_hex->setToolTip(tr("The colour as a hex code, from #000000 (black) to #ffffff (white)"));
  connect(m_hex, &QLineEdit::editingFinished, this, [this] {
    const QColor typed(m_hex->text().startsWith('#') ? m_hex->text() : '#' + m_hex->text());
    const QColor shown = QColor::fromHsvF(float(m_hue), float(m_saturation), float(m_brightness));
    if (!typed.isValid())
      return m_hex->setText(shown.name());
    if (typed.rgb() != shown.rgb())
      pick(typed);
  });
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
  const QColor shown = QColor::fromHsvF(float(m_hue), float(m_saturation), float(m_brightness));
  m_hex->setText(wanted.name());
  if (wanted.rgb() == shown.rgb())
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

QRectF ColorPicker::swatchRect(int index) const {
  const double pitch = (width() + 4.0) / swatches.size();
  const double left = std::round(index * pitch); // whole pixels, or frames blur
  return {left, fieldRect().bottom() + gap, std::round((index + 1) * pitch) - 4.0 - left, rowHeight};
}

void ColorPicker::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);

  QLinearGradient toHue(fieldRect().topLeft(), fieldRect().topRight());
  toHue.setColorAt(0.0, Qt::white);
  toHue.setColorAt(1.0, QColor::fromHsvF(float(m_hue), 1.0f, 1.0f));
  QLinearGradient toBlack(fieldRect().topLeft(), fieldRect().bottomLeft());
  toBlack.setColorAt(0.0, QColor(0, 0, 0, 0));
  toBlack.setColorAt(1.0, Qt::black);
  for (const QLinearGradient& gradient : {toHue, toBlack}) {
    painter.setBrush(gradient);
    painter.drawRoundedRect(fieldRect(), 4.0, 4.0);
  }

  QLinearGradient hues(hueRect().topLeft(), hueRect().bottomLeft());
  for (int i = 0; i <= 6; ++i)
    hues.setColorAt(i / 6.0, QColor::fromHsvF(float(i % 6) / 6.0f, 1.0f, 1.0f));
  painter.setBrush(hues);
  painter.drawRoundedRect(hueRect(), 4.0, 4.0);
  paintSwatches(painter);

  const QPointF place(fieldRect().left() + m_saturation * fieldRect().width(),
                      fieldRect().bottom() - m_brightness * fieldRect().height());
  const double hueY = hueRect().top() + m_hue * hueRect().height();
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, thickness] : {std::pair{QColor(Qt::black), 4.0}, {QColor(Qt::white), 2.0}}) {
    painter.setPen(QPen(color, thickness));
    painter.drawEllipse(place, 6.0, 6.0);
    painter.drawRoundedRect(QRectF(hueRect().left() + 2.0, hueY - 3.0, barWidth - 4.0, 6.0), 2.0, 2.0);
  }
}

void ColorPicker::paintSwatches(QPainter& painter) const {
  painter.setPen(themeColors(palette()).border);
  for (int i = 0; i < static_cast<int>(swatches.size()); ++i) {
    painter.setBrush(QColor(QLatin1String(swatches[static_cast<std::size_t>(i)])));
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
  for (int i = 0; i < static_cast<int>(swatches.size()); ++i)
    if (swatchRect(i).contains(position))
      return pick(QColor(QLatin1String(swatches[static_cast<std::size_t>(i)])));
  pickAt(position);
}

void ColorPicker::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    pickAt(event->position());
}

void ColorPicker::resizeEvent(QResizeEvent*) {
  m_hex->setGeometry(0, height() - static_cast<int>(rowHeight), width(), static_cast<int>(rowHeight));
}

void ColorPicker::pickAt(const QPointF& position) {
  const QRectF field = fieldRect();
  if (m_part == Part::none)
    return;
  if (m_part == Part::hue) {
    m_hue = std::clamp((position.y() - hueRect().top()) / hueRect().height(), 0.0, 0.999);
  } else {
    m_saturation = std::clamp((position.x() - field.left()) / field.width(), 0.0, 1.0);
    m_brightness = std::clamp((field.bottom() - position.y()) / field.height(), 0.0, 1.0);
  }
  pick(QColor::fromHsvF(float(m_hue), float(m_saturation), float(m_brightness)));
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
  return picker;
}

ColorButton::ColorButton(const QString& undoText, QWidget* parent)
    : QAbstractButton(parent), m_undoText(undoText) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setAccessibleName(tr("Colour"));
  connect(this, &QAbstractButton::clicked, this, &ColorButton::openPicker);
}

void ColorButton::setColor(const glm::dvec3& color) {
  m_color = color;
  update();
}

void ColorButton::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(isEnabled() ? 1.0 : 0.35);
  painter.setBrush(toQColor(m_color));
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
  const ColorPicker* picker = openColorPicker(m_color, QRect(mapToGlobal(QPoint(0, 0)), size()), this);
  connect(picker, &ColorPicker::colorPicked, this, [this](const glm::dvec3& color, std::uint64_t id) {
    setColor(color);
    emit colorEdited(color, {id, m_undoText});
  });
  connect(picker, &ColorPicker::takenBack, this, &ColorButton::takenBack);
}

} // namespace limn
