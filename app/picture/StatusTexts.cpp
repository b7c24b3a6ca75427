// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/StatusTexts.h"

#include "app/document/DocumentText.h"
#include "widgets/ValueText.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QLabel>
#include <QStatusBar>

#include <array>
#include <cmath>

namespace limn {

namespace {

// "12.0 L" for x, y or z of world millimetres; without a letter where the sides are unknown.
QString placeText(double mm, int axis, bool isKnown) {
  constexpr std::array<std::array<char, 2>, 3> letters{{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};
  if (!isKnown)
    return valueText(mm, {}, 1);
  const char letter = letters[static_cast<std::size_t>(axis)][mm < 0.0 ? 0 : 1];
  return valueText(std::abs(mm), QString(QLatin1Char(letter)), 1);
}

// "310 HU at cursor · 12 L, 3.5 A, 40.1 S mm"
QString probeText(const Probe& probe, const VolumeInfo& info) {
  const QString unit = QString::fromStdString(info.unit);
  QStringList places;
  for (int axis = 0; axis < 3; ++axis)
    places << placeText(probe.positionMm[axis], axis, info.orientationKnown);
  return QObject::tr("%1 at cursor · %2 mm")
      .arg(valueText(probe.value, unit, unit.isEmpty() ? 2 : 0), places.join(QStringLiteral(", ")));
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
  const bool isOnDisk = volume && volume->room();
  m_volume->setText(isOnDisk ? QObject::tr("%1 · on the disk").arg(volumeText(*volume).trimmed())
                    : volume ? volumeText(*volume)
                             : QString());
  m_volume->setToolTip(isOnDisk
                           ? QObject::tr("<p>The voxels stay on the disk, because they would take more than "
                                         "a third of the memory that Limn may use (--memory). The processor "
                                         "draws them, and reads what the curve shows.</p>")
                           : QString());
}

void StatusTexts::showProbe(const std::optional<Probe>& probe, const Volume* volume) {
  m_probe->setText(probe && volume ? probeText(*probe, volume->info()) : QString());
}

void StatusTexts::showPicture(const PictureState& state, const Scene& scene) {
  m_picture->setText(pictureStatusText(state, scene));
}

} // namespace limn
