// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/PictureLoop.h"

#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"
#include "widgets/Translated.h"

#include <algorithm>
#include <exception>

namespace limn {
namespace {

constexpr int showEveryMs = 250;          // while refining: showing costs as much as a turn of it
constexpr int tellEveryMs = 50;           // how far a volume is got ready
constexpr int waitMs = 4;                 // for another thread
constexpr double timeBetweenProbes = 9.0; // in times of one; between judgements of paths, too

} // namespace

PictureLoop::PictureLoop(MakePictures makePictures, PictureContext context, PicturePace pace, QObject* parent)
    : QObject(parent), m_makePictures(std::move(makePictures)), m_context(std::move(context)), m_pace(pace) {
  for (QTimer* timer : {&m_idleTimer, &m_refineTimer, &m_restTimer, &m_lightTimer, &m_probeTimer}) {
    timer->setParent(this); // they go along to another thread
    timer->setSingleShot(true);
  }
  m_idleTimer.setInterval(pace.idleMs);
  connect(&m_idleTimer, &QTimer::timeout, this, &PictureLoop::refine);
  connect(&m_refineTimer, &QTimer::timeout, this, &PictureLoop::refine);
  connect(&m_restTimer, &QTimer::timeout, this, &PictureLoop::workAtRest);
  connect(&m_lightTimer, &QTimer::timeout, this, &PictureLoop::awaitLight);
  connect(&m_probeTimer, &QTimer::timeout, this, &PictureLoop::probeError);
}

template <class T>
void PictureLoop::tell(T& news, T value) {
  if (news == value)
    return;
  news = std::move(value);
  emit told(m_news);
}

void PictureLoop::show(const PictureOrder& order) {
  if (order == m_order)
    return;
  const PictureOrder before = std::exchange(m_order, order);
  m_quality.setTargetMs(order.movingMs);
  if (volumeOf(order) != volumeOf(before)) { // nothing that was told holds any more
    m_quality.forget();
    tell(m_news.state, {});
    if (!volumeOf(order))
      tellEffects({});
  } else if (volumeOf(order) && order.scenes.front().projection != before.scenes.front().projection) {
    m_quality.forget();
  }
  const bool isOther = asksForOthers(order, before, state().resting);
  if (isOther)
    restart();
  if (!order.isSeen)
    return stop();
  if (isOther || !m_pictures || !state().resting)
    return;
  if (before.refines && !order.refines)
    m_pictures->leaveRefinementPass();
  updateState();
  tellEffects(std::vector(m_news.effects));
  if (order.refines != before.refines)
    emit showNeeded();
  m_restTimer.start(0);
}

void PictureLoop::restart() {
  m_isStale = true;
  m_refineTimer.stop();
  m_idleTimer.stop();
  m_restTimer.stop();
  PictureState stale = state();
  if (stale.resting)
    stale = staleState(std::move(stale));
  tell(m_news.state, std::move(stale));
  tell(m_news.times, {});
  tell(m_news.failureAtRest, {});
}

void PictureLoop::stop() {
  endPreparing();
  m_idleTimer.stop();
  m_refineTimer.stop();
  m_restTimer.stop();
  m_lightTimer.stop();
  m_probeTimer.stop();
}

void PictureLoop::release(bool isLost) {
  stop();
  // To delete what a lost context held would need another.
  if (isLost)
    static_cast<void>(m_pictures.release());
  else
    m_pictures.reset();
  tell(m_news.state, {});
}

void PictureLoop::drawIfStale() {
  if (!m_pictures) {
    m_pictures = m_makePictures();
    m_isStale = true;
  }
  if (!m_isStale)
    return;
  if (m_order.size.x > 0 && m_order.size.y > 0) {
    if (!makeReady(m_order.scenes.front()))
      return;
    m_isStale = false;
    drawCoarsely();
  } else {
    m_isStale = false;
  }
}

// A large volume takes long: the rest is done in later turns.
bool PictureLoop::makeReady(const Scene& scene) {
  if (!isPreparing())
    m_sincePreparing.start();
  const Effort effort{0, m_context.isCancelled, [this](double fraction) { tellPreparing(0.99 * fraction); }};
  double done = 0.0;
  try {
    done = m_pictures->makeReady(scene, effort, m_pace.budgetMs);
  } catch (...) {
    endPreparing();
    throw;
  }
  if (done < 1.0) {
    tellPreparing(done);
    QTimer::singleShot(0, this, &PictureLoop::showNeeded);
    return false;
  }
  endPreparing();
  return true;
}

void PictureLoop::tellPreparing(double fraction) {
  const bool isDue = m_sinceTold.isValid() ? m_sinceTold.elapsed() >= tellEveryMs
                                           : m_sincePreparing.elapsed() >= m_pace.tellMs;
  if (!isDue)
    return;
  m_sinceTold.start();
  tell(m_news.prepared, fraction);
}

void PictureLoop::endPreparing() {
  m_sincePreparing.invalidate();
  if (!m_sinceTold.isValid())
    return;
  m_sinceTold.invalidate();
  tell(m_news.prepared, 1.0);
}

// Draw at the quality that was fast enough last time; where it proves to have been too careful, once more.
void PictureLoop::drawCoarsely() {
  m_pictures->want(m_order.scenes, m_order.size);
  m_volume = volumeOf(m_order);
  const double all = static_cast<double>(m_order.scenes.size()) * m_order.size.x * m_order.size.y;
  const double seen = m_order.seenShare * all;
  const int finest = m_pictures->finestLevel();
  int level = std::max(m_quality.levelFor(seen), finest);
  if (level == 0 && m_quality.levelFor(all) > 0)
    level = 1; // full quality draws the hidden parts too
  if (const double ms = m_pictures->drawCoarsely(level, m_order.seen); ms > 0.0)
    m_quality.measured(level, level == 0 ? all : seen, ms);
  requireVolume();
  if (std::max(m_quality.levelFor(all), finest) < level) {
    m_isStale = true;
    QTimer::singleShot(0, this, &PictureLoop::showNeeded);
  }
  if (m_pictures->coarseLacksLight())
    m_lightTimer.start(waitMs);
  m_idleTimer.start();
  if (!m_probeTimer.isActive())
    m_probeTimer.start(0);
  updateState();
  tellEffects(m_pictures->effectRowsOf(m_pictures->count() - 1));
}

// A picture drawn in the light of the scene before is drawn anew in its own; at rest that follows by itself.
void PictureLoop::awaitLight() {
  if (!m_pictures || isPreparing() || !m_order.isSeen || state().resting)
    return;
  if (m_pictures->isFindingCoarseLight())
    return m_lightTimer.start(waitMs);
  restart();
  emit showNeeded();
}

// What is drawn of voxels that were lost meanwhile is an error.
void PictureLoop::requireVolume() const {
  if (const auto volume = m_volume.lock())
    requireWhole(*volume);
}

void PictureLoop::refine() {
  if (!m_pictures || !m_order.isSeen)
    return;
  bool isComplete = false;
  m_context.makeCurrent();
  std::vector<EffectRow> rows = m_news.effects;
  m_context.guard([&] {
    isComplete = m_pictures->refine(m_pace.budgetMs);
    requireVolume();
    if (isComplete && m_pictures->hadStandIns())
      rows = m_pictures->effectRowsOf(m_pictures->count() - 1);
  });
  m_context.doneCurrent();
  updateState();
  tellEffects(std::move(rows));
  if (isComplete || m_sinceShown.elapsed() >= showEveryMs)
    emit showNeeded();
  if (!m_order.isSeen)
    return;
  (isComplete ? m_restTimer : m_refineTimer).start(0);
}

void PictureLoop::measureEffects(bool measures) {
  if (!m_pictures || m_news.effects.empty())
    return;
  m_context.makeCurrent(); // what was measured before ends in it
  if (measures)
    m_pictures->rest().measureCosts(m_pictures->count() - 1);
  else
    m_pictures->rest().giveUpCosts();
  m_context.doneCurrent();
  tell(m_news.times, m_pictures->rest().times());
  m_restTimer.start(0);
}

void PictureLoop::updateState() {
  PictureState state = m_pictures->state();
  // What else is done at rest comes first: refinement is under way as soon as nothing stands between.
  state.refines = state.refines || (state.resting && m_order.refines && !state.refinementEnd);
  tell(m_news.state, std::move(state));
}

// Asked before work that nobody waits for, which ends quietly where it fails.
bool PictureLoop::isDriverLost() {
  m_context.guard([] {});
  return !m_order.isSeen;
}

// Small pictures take a part of the time that the ones they stand for are given.
void PictureLoop::probeError() {
  if (!m_pictures || isPreparing() || !m_order.isSeen)
    return;
  QElapsedTimer clock;
  clock.start();
  bool didSomething = false;
  m_context.makeCurrent();
  if (isDriverLost())
    return m_context.doneCurrent();
  try {
    didSomething = m_pictures->probeError();
  } catch (const Cancelled&) {
    didSomething = true; // an order came, perhaps the same once more
  } catch (const std::exception& error) {
    // The picture stays; only the estimate of its error is missing.
    tell(m_news.failureAtRest, translated(error));
  }
  m_context.doneCurrent();
  updateState();
  if (didSomething)
    m_probeTimer.start(static_cast<int>(timeBetweenProbes * static_cast<double>(clock.elapsed())));
}

void PictureLoop::workAtRest() {
  if (!m_pictures || !state().resting || !m_order.isSeen)
    return;
  const RestTurn turn = restTurn();
  const std::vector<SideState> before = state().sides;
  updateState();
  const bool isDue = state().refinementFraction > 0.0 && m_sinceShown.elapsed() >= showEveryMs;
  if (turn == RestTurn::finished || isDue || before != state().sides)
    emit showNeeded();
  if (turn == RestTurn::nothing)
    return;
  tell(m_news.times, m_pictures->rest().times());
  m_restTimer.start(turn == RestTurn::waiting ? waitMs : 0);
}

RestTurn PictureLoop::restTurn() {
  RestTurn turn = RestTurn::nothing;
  m_context.makeCurrent();
  if (isDriverLost()) {
    m_context.doneCurrent();
    return turn;
  }
  try {
    turn = m_pictures->workAtRest(m_order.refines, m_pace.restBudgetMs);
    judgeWhatIsShown();
  } catch (const Cancelled&) {
    // An order came. Another one ends this, but it may be the same once more: then nothing else would go on.
    turn = RestTurn::waiting;
  } catch (const std::exception& error) {
    // The picture is complete: it stays, only what was to be measured or refined is missing.
    m_pictures->giveUpRefinement();
    tell(m_news.failureAtRest, translated(error));
  }
  m_context.doneCurrent();
  return turn;
}

// The error of a picture that gets more paths follows what is shown of it, in a tenth of the time at most.
void PictureLoop::judgeWhatIsShown() {
  if (m_sinceShown.elapsed() < showEveryMs)
    return;
  if (m_sinceJudged.isValid() && m_sinceJudged.elapsed() < (1.0 + timeBetweenProbes) * m_judgedInMs)
    return;
  m_sinceJudged.start();
  m_pictures->judgePass();
  m_judgedInMs = static_cast<double>(m_sinceJudged.elapsed());
}

const SidePicture* PictureLoop::resting(int side) const {
  return state().resting && side < m_pictures->count() ? &m_pictures->side(side) : nullptr;
}

GradientScale PictureLoop::gradientScaleOf(int side) const {
  return m_pictures && side < m_pictures->count() ? m_pictures->side(side).gradientScale() : GradientScale{};
}

void PictureLoop::tellEffects(std::vector<EffectRow> rows) {
  const QString name = rows.empty() ? QString() : m_order.lastName;
  if (rows == m_news.effects && name == m_news.effectsOf)
    return;
  m_news.effects = std::move(rows);
  m_news.effectsOf = name;
  emit told(m_news);
}

} // namespace limn
