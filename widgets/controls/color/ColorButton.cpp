// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/color/ColorButton.h"

#include "widgets/Theme.h"
#include "widgets/controls/PopupPlacement.h"
#include "widgets/controls/color/ColorConversion.h"
#include "widgets/controls/color/ColorPicker.h"

#include <QFrame>
#include <QPainter>
#include <QVBoxLayout>

namespace limn {

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
  auto* popup = new QFrame(this, Qt::Popup);
  popup->setAttribute(Qt::WA_DeleteOnClose);
  popup->setFrameShape(QFrame::StyledPanel);
  auto* layout = new QVBoxLayout(popup);
  layout->setContentsMargins(12, 12, 12, 12);
  auto* picker = new ColorPicker;
  picker->setColor(m_color);
  layout->addWidget(picker);
  connect(picker, &ColorPicker::colorPicked, this, [this](const glm::dvec3& color, std::uint64_t id) {
    setColor(color);
    emit colorEdited(color, {id, m_undoText});
  });
  showPopupAt(*popup, QRect(mapToGlobal(QPoint(0, 0)), size()));
}

} // namespace limn
