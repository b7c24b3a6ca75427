// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PictureStatus.h"

#include <QEvent>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <numeric>

namespace limn {
namespace {

constexpr int partGap = 12; // between parts

constexpr std::size_t badgePart = 0, estimatePart = 1, stepPart = 2, timePart = 3, enginePart = 4;

// In the order in which they give way when there is little room; the others stay.
constexpr std::array givesWay{enginePart, stepPart};

// Lines as rich text, which Qt breaks where they are long.
QString broken(const QString& lines) {
  return QStringLiteral("<p>%1</p>")
      .arg(lines.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>")));
}

using Texts = std::array<QString, 5>;

Texts partsOf(const PictureStatusText& text) {
  return {text.badge, text.estimate, text.step, text.time, text.engine};
}

} // namespace

PictureStatus::PictureStatus(QWidget* parent) : QWidget(parent), m_badge(new QToolButton(this)) {
  setAccessibleName(tr("Accuracy of the picture"));
  m_badge->setCheckable(true);
  m_badge->setAutoRaise(true);
  m_badge->setToolButtonStyle(Qt::ToolButtonTextOnly);
  m_badge->setObjectName(QStringLiteral("accuracyBadge"));
  m_parts[badgePart] = m_badge;
  for (std::size_t i = 0; i < m_labels.size(); ++i)
    m_parts[i + 1] = m_labels[i] = new QLabel(this);
  connect(m_badge, &QToolButton::toggled, this, [this] {
    updateGeometry();
    arrange();
  });
}

void PictureStatus::setText(const PictureStatusText& text) {
  if (text == m_text)
    return;
  m_text = text;
  const Texts shown = partsOf(text);
  m_badge->setText(shown[badgePart]);
  m_badge->setAccessibleName(tr("Accuracy: %1").arg(shown[badgePart].section(QLatin1Char(' '), 1)));
  for (std::size_t i = 0; i < m_labels.size(); ++i) {
    const QString& part = shown[i + 1];
    m_labels[i]->setText(part);
    const int advance = m_labels[i]->fontMetrics().horizontalAdvance(part);
    if (!part.isEmpty())
      m_padding = std::max(m_padding, m_labels[i]->sizeHint().width() - advance);
  }
  setToolTip(broken(text.toolTip + QLatin1Char('\n') + tr("Press for levels and steps.")));
  setAccessibleDescription(text.line());
  updateGeometry();
  arrange();
}

// Room for each part and for what commonly stands there; levels and steps when they are asked for.
std::array<int, PictureStatus::partCount> PictureStatus::widths() const {
  std::array<int, partCount> widths{};
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const QFontMetrics metrics = m_parts[i]->fontMetrics();
    int widest = metrics.horizontalAdvance(partsOf(m_text)[i]);
    for (const PictureStatusText& common : commonStatusTexts())
      widest = std::max(widest, metrics.horizontalAdvance(partsOf(common)[i]));
    widths[i] = widest + m_padding + partGap;
  }
  widths[badgePart] += partGap; // the button's own margins
  if (!m_badge->isChecked())
    widths[estimatePart] = widths[stepPart] = 0;
  return widths;
}

QSize PictureStatus::sizeHint() const {
  int width = 0;
  for (const int part : widths())
    width += part;
  return {width, fontMetrics().height()};
}

QSize PictureStatus::minimumSizeHint() const {
  const std::array<int, partCount> parts = widths();
  return {parts[badgePart] + parts[estimatePart] + parts[timePart], fontMetrics().height()};
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
  std::array<int, partCount> widths = this->widths();
  int total = std::accumulate(widths.begin(), widths.end(), 0);
  for (const std::size_t part : givesWay)
    if (total > width()) {
      total -= widths[part];
      widths[part] = 0;
    }
  int x = std::max(0, width() - total);
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    m_parts[i]->setVisible(widths[i] > 0);
    m_parts[i]->setGeometry(x, 0, std::max(0, widths[i] - (i == badgePart ? partGap : 0)), height());
    x += widths[i];
  }
}

} // namespace limn
