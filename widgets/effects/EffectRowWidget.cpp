// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/effects/EffectRowWidget.h"

#include "widgets/Theme.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>

namespace limn {
namespace {

constexpr int markSize = 10;
constexpr int textLeft = 32; // of the row, right of the mark

QString sentence(QString phrase) {
  if (!phrase.isEmpty())
    phrase[0] = phrase[0].toUpper();
  return phrase;
}

void setTextColor(QLabel& label, const QColor& color) {
  QPalette palette = label.palette();
  palette.setColor(QPalette::WindowText, color);
  label.setPalette(palette);
}

} // namespace

EffectRowWidget::EffectRowWidget(QWidget* parent)
    : QWidget(parent), m_title(new QLabel), m_cost(new QLabel), m_reason(new QLabel) {
  m_title->setWordWrap(true);
  m_reason->setWordWrap(true);
  m_cost->setAlignment(Qt::AlignRight | Qt::AlignTop);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(textLeft, 6, 12, 6);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->addWidget(m_title, 0, 0);
  grid->addWidget(m_cost, 0, 1);
  grid->addWidget(m_reason, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  showColors();
}

void EffectRowWidget::setRow(const EffectRow& row) {
  if (row == m_row)
    return;
  m_row = row;
  m_title->setText(translated(row.title));
  m_reason->setText(sentence(translated(row.reason)));
  QFont font = m_title->font();
  font.setWeight(row.isOn ? QFont::DemiBold : QFont::Normal);
  m_title->setFont(font);
  showColors();
  describe();
}

void EffectRowWidget::setCost(const std::optional<EffectCost>& cost) {
  m_cost->setText(cost ? translated(costText(*cost)) : QString());
  m_cost->setToolTip(
      cost ? tr("The picture takes %1 ms %2 with this effect; repeated measurements scatter by ±%3 ms.")
                 .arg(fixedNumber(std::abs(cost->ms), 1))
                 .arg(cost->ms < 0.0 ? tr("less") : tr("more"))
                 .arg(fixedNumber(cost->spreadMs, 1))
           : QString());
  describe();
}

bool EffectRowWidget::showsCost() const {
  return !m_cost->text().isEmpty();
}

// What a screen reader says.
void EffectRowWidget::describe() {
  setAccessibleName(tr("%1: %2").arg(m_title->text(), m_row.isOn ? tr("on") : tr("off")));
  const QString cost = m_cost->text();
  setAccessibleDescription(cost.isEmpty() ? m_reason->text()
                                          : QStringLiteral("%1. %2").arg(m_reason->text(), cost));
}

void EffectRowWidget::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double top = m_title->y() + 0.5 * (m_title->fontMetrics().height() - markSize);
  const QRectF mark(12.0, top, markSize, markSize);
  painter.setPen(QPen(m_row.isOn ? colors.accent : colors.secondaryText, 1.5));
  painter.setBrush(m_row.isOn ? QBrush(colors.accent) : QBrush(Qt::NoBrush));
  painter.drawEllipse(mark.adjusted(0.75, 0.75, -0.75, -0.75));
}

void EffectRowWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    showColors();
  QWidget::changeEvent(event);
}

void EffectRowWidget::showColors() {
  const ThemeColors colors = themeColors(palette());
  setTextColor(*m_title, m_row.isOn ? colors.text : colors.secondaryText);
  setTextColor(*m_reason, colors.secondaryText);
  setTextColor(*m_cost, colors.text);
  update();
}

} // namespace limn
