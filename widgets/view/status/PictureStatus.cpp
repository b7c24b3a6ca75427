// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/status/PictureStatus.h"

#include <QEvent>
#include <QLabel>

#include <algorithm>

namespace limn {
namespace {

constexpr int partGap = 12; // between parts

// In the order in which they give way when there is little room: engine, step; estimate and time stay.
constexpr std::array<std::size_t, 2> givesWay{3, 1};

using Texts = std::array<QString, 4>;

Texts partsOf(const PictureStatusText& text) {
  return {text.estimate, text.step, text.time, text.engine};
}

} // namespace

PictureStatus::PictureStatus(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Accuracy of the picture"));
  for (QLabel*& part : m_parts)
    part = new QLabel(this);
}

void PictureStatus::setText(const PictureStatusText& text) {
  if (text == m_text)
    return;
  m_text = text;
  const Texts shown = partsOf(text);
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    m_parts[i]->setText(shown[i]);
    const int advance = m_parts[i]->fontMetrics().horizontalAdvance(shown[i]);
    if (!shown[i].isEmpty())
      m_padding = std::max(m_padding, m_parts[i]->sizeHint().width() - advance);
  }
  setToolTip(text.toolTip);
  setAccessibleDescription(text.line());
  updateGeometry();
  arrange();
}

// Room for each part and for what commonly stands there.
std::array<int, 4> PictureStatus::widths() const {
  std::array<int, 4> widths{};
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const QFontMetrics metrics = m_parts[i]->fontMetrics();
    int widest = metrics.horizontalAdvance(m_parts[i]->text());
    for (const PictureStatusText& common : commonStatusTexts())
      widest = std::max(widest, metrics.horizontalAdvance(partsOf(common)[i]));
    widths[i] = widest + m_padding + partGap;
  }
  return widths;
}

QSize PictureStatus::sizeHint() const {
  int width = 0;
  for (const int part : widths())
    width += part;
  return {width, fontMetrics().height()};
}

QSize PictureStatus::minimumSizeHint() const {
  const std::array<int, 4> parts = widths();
  return {parts[0] + parts[2], fontMetrics().height()};
}

void PictureStatus::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void PictureStatus::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    arrange();
}

// Leave out what does not fit, then line up the rest at the right edge.
void PictureStatus::arrange() {
  std::array<int, 4> widths = this->widths();
  int total = 0;
  for (const int part : widths)
    total += part;
  for (const std::size_t part : givesWay)
    if (total > width()) {
      total -= widths[part];
      widths[part] = 0;
    }
  int x = std::max(0, width() - total);
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    m_parts[i]->setVisible(widths[i] > 0);
    m_parts[i]->setGeometry(x, 0, widths[i], height());
    x += widths[i];
  }
}

} // namespace limn
