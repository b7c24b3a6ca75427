// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/EffectsPanel.h"

#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/controls/WorkRow.h"
#include "widgets/theme/Theme.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

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
    : QWidget(parent), m_switch(new QCheckBox(this)), m_title(new QLabel), m_cost(new QLabel),
      m_reason(new QLabel) {
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
  m_switch->hide();
  connect(m_switch, &QCheckBox::clicked, this, [this](bool isOn) {
    m_switch->setChecked(m_row.isOn); // until the picture has it
    emit switched(QString::fromStdString(m_row.name), isOn);
  });
  showColors();
}

// In the place of the mark.
void EffectRowWidget::setSwitchable(bool isSwitchable) {
  m_switch->setVisible(isSwitchable);
  m_switch->setFocusPolicy(isSwitchable ? Qt::StrongFocus : Qt::NoFocus);
  m_switch->setChecked(m_row.isOn);
  m_switch->setAccessibleName(m_title->text());
  m_switch->setToolTip(m_row.isOn ? tr("Leaves this effect out of the picture.")
                                  : tr("Has the picture show it."));
  const QSize size = m_switch->sizeHint();
  const int line = m_title->fontMetrics().height();
  m_switch->setGeometry(8, layout()->contentsMargins().top() + (line - size.height()) / 2, size.width(),
                        size.height());
  update();
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

void EffectRowWidget::setCost(const std::optional<EffectCost>& cost,
                              const std::optional<EffectCost>& wouldCost) {
  m_cost->setText(cost ? translated(costWithSpreadText(*cost)) : QString());
  m_cost->setToolTip(
      cost ? tr("The picture takes %1 ms %2 with this effect; repeated measurements scatter by ±%3 ms.")
                 .arg(fixedNumber(std::abs(cost->ms), 1))
                 .arg(cost->ms < 0.0 ? tr("less") : tr("more"))
                 .arg(fixedNumber(cost->spreadMs, 1))
           : QString());
  QString reason = sentence(translated(m_row.reason));
  if (cost && cost->brought)
    reason = tr("%1; it %2.").arg(reason, translated(broughtText(*cost->brought)));
  else if (wouldCost && wouldCost->brought)
    reason = tr("%1; switched on it %2, and %3.")
                 .arg(reason, translated(wouldCostText(*wouldCost)),
                      translated(wouldBringText(*wouldCost->brought)));
  else if (wouldCost)
    reason = tr("%1; switched on it %2.").arg(reason, translated(wouldCostText(*wouldCost)));
  m_reason->setText(reason);
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
  if (!m_switch->isHidden())
    return;
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double top = m_title->y() + 0.5 * (m_title->fontMetrics().height() - markSize);
  const QRectF mark(12.0, top, markSize, markSize);
  painter.setPen(QPen(m_row.isOn ? colors.accent : colors.secondaryText, 2.0, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  // A bare tick or dash: in a box or a circle it would look as if it could be clicked.
  const auto at = [&mark](double x, double y) {
    return mark.topLeft() + QPointF(x * mark.width(), y * mark.height());
  };
  const QPolygonF tick{at(0.05, 0.55), at(0.38, 0.88), at(0.95, 0.18)};
  const QPolygonF dash{at(0.2, 0.5), at(0.8, 0.5)};
  painter.drawPolyline(m_row.isOn ? tick : dash);
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

EffectsPanel::EffectsPanel(QWidget* parent)
    : SectionPanel(parent), m_list(new QWidget), m_heading(new QLabel),
      m_measure(new QPushButton(tr("Measure cost"))), m_work(new WorkRow(tr("Measuring what effects cost"))),
      m_method(new QLabel) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 8, 0, 12);
  column->setSpacing(4);
  m_heading->setWordWrap(true);
  m_heading->setContentsMargins(12, 0, 12, 4);
  column->addWidget(m_heading);
  auto* buttonRow = new QHBoxLayout;
  buttonRow->setContentsMargins(12, 0, 12, 4);
  m_measure->setObjectName(QStringLiteral("measureCost"));
  m_measure->setToolTip(
      tr("Draws the picture several times with and without each effect, also with those that "
         "are off, while nothing else is to be drawn; any change of the scene stops it."));
  buttonRow->addWidget(m_measure);
  buttonRow->addStretch(1);
  column->addLayout(buttonRow);
  m_work->setContentsMargins(12, 0, 12, 4);
  column->addWidget(m_work);
  connect(m_work, &WorkRow::cancelled, this, &EffectsPanel::cancelRequested);
  connect(m_measure, &QPushButton::clicked, this, &EffectsPanel::measureRequested);
  auto* rows = new QVBoxLayout(m_list);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  column->addWidget(m_list);
  m_method->setWordWrap(true);
  m_method->setForegroundRole(QPalette::PlaceholderText);
  m_method->setContentsMargins(12, 4, 12, 0);
  column->addWidget(m_method);
  column->addStretch(1);
  setWidget(content);
  // Narrower, texts would be columns of words, and the tabs above it cut off.
  setMinimumWidth(260);
  setAccessibleName(tr("Effects"));
  setRows({}, {});
  showTimes();
}

void EffectsPanel::setRows(const std::vector<EffectRow>& rows, const QString& picture) {
  if (rows == m_shown && picture == m_picture && !m_heading->text().isEmpty())
    return;
  m_shown = rows;
  m_picture = picture;
  while (m_rows.size() < rows.size()) {
    m_rows.push_back(new EffectRowWidget);
    m_list->layout()->addWidget(m_rows.back());
    connect(m_rows.back(), &EffectRowWidget::switched, this, &EffectsPanel::effectSwitched);
  }
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    m_rows[i]->setVisible(i < rows.size());
    if (i < rows.size())
      m_rows[i]->setRow(rows[i]);
  }
  showSwitches();
  const auto on = std::count_if(rows.begin(), rows.end(), [](const EffectRow& row) { return row.isOn; });
  m_heading->setText(rows.empty()
                         ? tr("Open a volume to see which effects its picture calls for.")
                         : tr("%1: the picture calls for %2 of %3 effects; nothing else is computed.")
                               .arg(picture)
                               .arg(on)
                               .arg(rows.size()));
  m_measure->setEnabled(!rows.empty() && !m_times.isMeasuring);
}

QString EffectsPanel::titleOf(const QString& effect) const {
  const auto row = std::ranges::find(m_shown, effect.toStdString(), &EffectRow::name);
  return row == m_shown.end() ? effect : translated(row->title);
}

void EffectsPanel::setSwitchable(const std::set<std::string>& effects) {
  if (effects == m_switchable)
    return;
  m_switchable = effects;
  showSwitches();
}

void EffectsPanel::showSwitches() {
  for (std::size_t i = 0; i < m_shown.size(); ++i)
    m_rows[i]->setSwitchable(m_switchable.contains(m_shown[i].name));
}

void EffectsPanel::setTimes(const EffectTimes& times) {
  if (times == m_times)
    return;
  m_times = times;
  showTimes();
}

void EffectsPanel::showTimes() {
  const auto ofRow = [](const std::vector<std::optional<EffectCost>>& costs, std::size_t row) {
    return row < costs.size() ? costs[row] : std::nullopt;
  };
  for (std::size_t i = 0; i < m_rows.size(); ++i)
    m_rows[i]->setCost(ofRow(m_times.costs, i), ofRow(m_times.wouldCosts, i));
  m_work->showProgress(m_times.isMeasuring ? std::optional(m_times.fraction) : std::nullopt,
                       tr("Measuring… %1 %").arg(qRound(100.0 * m_times.fraction)));
  m_measure->setEnabled(!m_shown.empty() && !m_times.isMeasuring);
  m_method->setVisible(!m_times.costs.empty());
  if (!m_times.costs.empty())
    m_method->setText(
        tr("The whole picture takes %1 ms at %2 × %3 pixels. Each cost is the median time with the "
           "effect less the median without it; costs overlap and do not add up. Method: %4.")
            .arg(fixedNumber(m_times.wholeMs, m_times.wholeMs < 10.0 ? 1 : 0))
            .arg(m_times.size.width())
            .arg(m_times.size.height())
            .arg(m_times.method));
}

} // namespace limn
