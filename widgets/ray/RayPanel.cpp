// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ray/RayPanel.h"

#include "widgets/ray/ProfileChart.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace limn {

RayPanel::RayPanel(QWidget* parent)
    : QWidget(parent), m_summary(new QLabel), m_goToHalf(new QPushButton(tr("Go to that depth"))),
      m_chart(new ProfileChart), m_reading(new QLabel) {
  setAccessibleName(tr("Ray"));
  for (QLabel* label : {m_summary, m_reading}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::NoTextInteraction);
  }
  m_summary->setObjectName(QStringLiteral("raySummary"));
  m_reading->setObjectName(QStringLiteral("rayReading"));
  m_reading->setForegroundRole(QPalette::PlaceholderText);
  // Of all readings as high as the longest, so that the chart does not jump.
  m_reading->setMinimumHeight(3 * m_reading->fontMetrics().lineSpacing());
  m_reading->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_goToHalf->setObjectName(QStringLiteral("goToHalf"));
  m_goToHalf->setToolTip(
      tr("<p>The crosshair goes to where half of the light is gathered, in the slices and in "
         "the picture.</p>"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(m_summary);
  column->addWidget(m_goToHalf, 0, Qt::AlignLeft);
  column->addWidget(m_chart, 1);
  column->addWidget(m_reading);
  connect(m_chart, &ProfileChart::cursorMoved, this, &RayPanel::showReading);
  connect(m_chart, &ProfileChart::depthChosen, this,
          [this](double depth) { emit placeChosen(placeAt(*m_chart->profile(), depth)); });
  connect(m_goToHalf, &QAbstractButton::clicked, this, [this] {
    const RayProfile& profile = *m_chart->profile();
    emit placeChosen(placeAt(profile, *halfLightDepth(profile)));
  });
  setProfile(std::nullopt, {}, std::nullopt);
}

void RayPanel::setProfile(const std::optional<RayProfile>& profile, const ProfileNames& names,
                          const std::optional<double>& crosshairMm) {
  m_names = names;
  m_summary->setText(profile
                         ? profileSummary(*profile, names)
                         : tr("No ray is read. Hold Shift over the picture: what lies along the ray below "
                              "the pointer shows here, and stays."));
  m_goToHalf->setEnabled(profile && halfLightDepth(*profile));
  m_chart->setProfile(profile, names, crosshairMm);
  m_chart->setAccessibleDescription(m_summary->text());
}

void RayPanel::showReading() {
  const std::optional<RayProfile>& profile = m_chart->profile();
  const std::optional<double> depth = m_chart->cursor();
  m_reading->setText(!profile ? QString()
                     : depth  ? readingAt(*profile, m_names, *depth)
                              : tr("Point at the chart to read a depth; a click goes there."));
  if (profile && depth)
    m_chart->setAccessibleDescription(m_reading->text());
}

void RayPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit shown(true);
}

void RayPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit shown(false);
}

} // namespace limn
