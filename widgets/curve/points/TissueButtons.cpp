// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/points/TissueButtons.h"

#include "scene/function/TissueOpacity.h"
#include "widgets/ValueText.h"
#include "widgets/curve/plot/Tissue.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace limn {
namespace {

// Where values have no names, so much of the volume's range to either side counts as the same tissue.
constexpr double sameTissue = 1.0 / 40.0;

std::optional<Tissue> tissueOf(double value, const QString& unit) {
  return unit == QLatin1String("HU") ? tissueAt(value) : std::nullopt;
}

ValueBand bandOf(double value, const QString& unit, const ValueRange& range) {
  if (const auto tissue = tissueOf(value, unit))
    return {std::max(tissue->range.lowest, range.lowest), std::min(tissue->range.highest, range.highest)};
  const double reach = sameTissue * (range.highest - range.lowest);
  return {value - reach, value + reach};
}

} // namespace

TissueButtons::TissueButtons(QWidget* parent) : QWidget(parent), m_label(new QLabel(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_label);
  layout->addWidget(button(tr("Less"), tr("Halves the opacity around the pinned value"), lessOpacity));
  layout->addWidget(button(tr("More"), tr("Doubles the opacity around the pinned value"), moreOpacity));
}

void TissueButtons::setValue(double value, const QString& unit, const ValueRange& range, int decimals) {
  m_value = value;
  m_unit = unit;
  m_range = range;
  m_text = valueText(value, unit, decimals);
  const auto tissue = tissueOf(value, unit);
  m_label->setText(tissue ? tr("Pinned: %1, %2").arg(m_text, tissue->name) : tr("Pinned: %1").arg(m_text));
}

QToolButton* TissueButtons::button(const QString& text, const QString& toolTip, double (*change)(double)) {
  auto* made = new QToolButton(this);
  made->setText(text);
  made->setToolTip(toolTip);
  made->setAccessibleName(tr("%1 of the pinned tissue", "less or more").arg(text));
  made->setFocusPolicy(Qt::StrongFocus);
  made->setProperty("framed", true);
  connect(made, &QToolButton::clicked, this, [this, change, text] {
    emit functionEdited(
        withOpacityChanged(m_function, bandOf(m_value, m_unit, m_range), change),
        {nextGestureId(), tr("%1 of %2", "less or more, a value").arg(text.toLower(), m_text)});
  });
  return made;
}

} // namespace limn
