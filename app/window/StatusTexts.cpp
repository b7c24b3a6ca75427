// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/StatusTexts.h"

#include "app/document/DocumentText.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/status/PictureStatus.h"

#include <QLabel>
#include <QStatusBar>

namespace limn {

namespace {

// "310 HU at cursor · 12.0, -3.5, 40.1 mm"
QString probeText(const Probe& probe, const QString& unit) {
  return QObject::tr("%1 %2 at cursor · %3, %4, %5 mm")
      .arg(probe.value, 0, 'f', unit.isEmpty() ? 2 : 0)
      .arg(unit)
      .arg(probe.positionMm.x, 0, 'f', 1)
      .arg(probe.positionMm.y, 0, 'f', 1)
      .arg(probe.positionMm.z, 0, 'f', 1);
}

} // namespace

StatusTexts::StatusTexts(QStatusBar& bar)
    : m_volume(new QLabel(&bar)), m_probe(new QLabel(&bar)), m_picture(new PictureStatus(&bar)) {
  bar.addWidget(m_volume);
  bar.addWidget(m_probe, 1);
  bar.addPermanentWidget(m_picture);
  m_probe->setAlignment(Qt::AlignCenter);
}

void StatusTexts::showVolume(const Volume* volume) {
  m_volume->setText(volume ? volumeText(*volume) : QString());
}

void StatusTexts::showProbe(const std::optional<Probe>& probe, const Volume* volume) {
  m_probe->setText(probe && volume ? probeText(*probe, QString::fromStdString(volume->info().unit))
                                   : QString());
}

void StatusTexts::showPicture(const PictureState& state, const Scene& scene) {
  m_picture->setText(pictureStatusText(state, scene));
}

} // namespace limn
