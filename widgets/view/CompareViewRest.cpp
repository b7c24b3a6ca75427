// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/CompareView.h"

#include "scene/LocalSteps.h"
#include "widgets/view/SideText.h"
#include "widgets/view/ViewPictures.h"

#include <exception>

// What the compare view does while its pictures rest, one piece per turn of the event loop.

namespace limn {
namespace {

constexpr int waitMs = 4;                 // for another thread
constexpr double timeBetweenProbes = 9.0; // in times of one

} // namespace

void CompareView::measureEffects() {
  if (!m_pictures || m_effects.empty())
    return;
  m_pictures->rest().measureCosts(sideOfEffects());
  showTimes(m_pictures->rest().times());
  m_restTimer.start(0);
}

Scene CompareView::sceneOfRestingImage(int side) const {
  Scene scene = sceneOfSide(side);
  if (m_state.resting && side < m_pictures->count())
    scene.quality = withSteps(scene.quality, m_pictures->side(side).finishedStepVoxels());
  return scene;
}

void CompareView::setRefinesAtRest(bool refines) {
  if (refines == m_refinesAtRest)
    return;
  m_refinesAtRest = refines;
  if (!m_pictures || !m_state.resting)
    return;
  if (!refines)
    m_pictures->leaveRefinementPass();
  updateState();
  update();
  m_restTimer.start(0);
}

void CompareView::updateState() {
  const PictureState state = m_pictures->state();
  if (state == m_state)
    return;
  m_state = state;
  // Receivers may set widgets, which must not happen in the middle of painting.
  QTimer::singleShot(0, this, [this, state] { emit pictureStateChanged(state); });
}

// Small pictures take a part of the time that the ones they stand for are given.
void CompareView::probeError() {
  if (!isVisible() || !m_pictures || !m_error.isEmpty() || !m_scene.volume)
    return;
  QElapsedTimer clock;
  clock.start();
  bool didSomething = false;
  makeCurrent();
  if (isDriverLost())
    return doneCurrent();
  try {
    didSomething = m_pictures->probeError();
  } catch (const std::exception& error) {
    // The picture stays; only the estimate of its error is missing.
    emit errorOccurred(QString::fromStdString(error.what()));
  }
  doneCurrent();
  updateState();
  if (didSomething)
    m_probeTimer.start(static_cast<int>(timeBetweenProbes * static_cast<double>(clock.elapsed())));
}

void CompareView::workAtRest() {
  if (!isVisible() || !m_pictures || !m_error.isEmpty() || !m_state.resting)
    return;
  const RestTurn turn = restTurn();
  const std::vector<SideState> before = m_state.sides;
  updateState();
  const bool isDue = m_state.refines && m_sinceShown.elapsed() >= showEveryMs;
  if (turn == RestTurn::finished || isDue || before != m_state.sides)
    update();
  if (turn == RestTurn::nothing)
    return;
  showTimes(m_pictures->rest().times());
  m_restTimer.start(turn == RestTurn::waiting ? waitMs : 0);
}

RestTurn CompareView::restTurn() {
  RestTurn turn = RestTurn::nothing;
  makeCurrent();
  if (isDriverLost()) {
    doneCurrent();
    return turn;
  }
  try {
    turn = m_pictures->workAtRest(m_refinesAtRest, restBudgetMs);
  } catch (const std::exception& error) {
    // The picture is complete: it stays, only what was to be measured or refined is missing.
    m_pictures->giveUpRefinement();
    emit errorOccurred(QString::fromStdString(error.what()));
  }
  doneCurrent();
  return turn;
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
