// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/LabelFade.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int stayMs = 4000; // after the pointer rests
constexpr int fadeMs = 400;

} // namespace

LabelFade::LabelFade(QObject* parent) : QObject(parent) {
  m_fade.setDuration(fadeMs);
  m_fade.setStartValue(1.0);
  m_fade.setEndValue(0.0);
  connect(&m_fade, &QVariantAnimation::valueChanged, this, &LabelFade::changed);
  m_stay.setSingleShot(true);
  m_stay.setInterval(stayMs);
  connect(&m_stay, &QTimer::timeout, this, [this] { m_fade.start(); });
}

void LabelFade::wake() {
  m_awaitsPicture = true;
  show();
}

void LabelFade::noteState(const PictureState& state) {
  const bool isComplete = !state.sides.empty() && std::ranges::all_of(state.sides, [](const SideState& side) {
    return side.completeMs.has_value();
  });
  if (isComplete && std::exchange(m_awaitsPicture, false))
    show();
}

void LabelFade::show() {
  const bool wasFading =
      m_fade.state() == QAbstractAnimation::Running || m_fade.currentTime() == m_fade.totalDuration();
  m_fade.stop();
  m_fade.setCurrentTime(0);
  m_stay.start();
  if (wasFading)
    emit changed();
}

} // namespace limn
