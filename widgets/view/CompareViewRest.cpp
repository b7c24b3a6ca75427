// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/CompareView.h"

#include "widgets/view/SideText.h"
#include "widgets/view/ViewPictures.h"

#include <exception>

// What the compare view does while its pictures rest, one piece per turn of the event loop.

namespace limn {

void CompareView::measureEffects() {
  if (!m_pictures || m_effects.empty())
    return;
  m_pictures->rest().measureCosts(sideOfEffects());
  showTimes(m_pictures->rest().times());
  m_restTimer.start(0);
}

void CompareView::workAtRest() {
  if (!isVisible() || !m_pictures || !m_error.isEmpty() || !m_state.resting)
    return;
  bool didSomething = false;
  makeCurrent();
  try {
    didSomething = m_pictures->workAtRest();
  } catch (const std::exception& error) {
    // The picture is complete: it stays, only what was to be measured is missing.
    emit errorOccurred(QString::fromStdString(error.what()));
  }
  doneCurrent();
  if (!didSomething)
    return;
  const PictureState before = m_state;
  updateState();
  if (before != m_state)
    update();
  showTimes(m_pictures->rest().times());
  m_restTimer.start(0);
}

void CompareView::leaveRest() {
  m_restTimer.stop();
  showTimes({});
  if (!m_scene.volume && !m_effects.empty())
    tellEffects({}, {});
}

void CompareView::showEffects() {
  const std::vector<EffectRow> rows = m_pictures->effectRowsOf(sideOfEffects());
  const QString title = sideTitle(sceneOfSide(sideOfEffects()));
  const QString picture = pictureCount(m_layout) == 1 ? title : tr("%1 (right)").arg(title);
  if (rows != m_effects || picture != m_effectsPicture)
    tellEffects(rows, picture);
}

// Receivers set widgets, which must not happen in the middle of painting.
void CompareView::tellEffects(const std::vector<EffectRow>& rows, const QString& picture) {
  m_effects = rows;
  m_effectsPicture = picture;
  QTimer::singleShot(0, this, [this, rows, picture] { emit effectsChanged(rows, picture); });
}

void CompareView::showTimes(const EffectTimes& times) {
  if (times == m_times)
    return;
  m_times = times;
  QTimer::singleShot(0, this, [this, times] { emit effectTimesChanged(times); });
}

} // namespace limn
