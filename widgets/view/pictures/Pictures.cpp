// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/Pictures.h"

#include "engine/DrawingEngine.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/Translated.h"

#include <algorithm>
#include <chrono>

namespace limn {
namespace {

double msSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

Pictures::Pictures(std::unique_ptr<DrawingEngine> engine, std::unique_ptr<PictureScreen> screen,
                   MakePrecise makePrecise, MakeEngine followsLight)
    : m_engine(std::move(engine)),
      m_screen(std::move(screen)), m_sides{SidePicture(*m_screen), SidePicture(*m_screen)}, m_rest(*m_screen),
      m_probe(*m_screen), m_refinement(*m_screen), m_light(std::move(followsLight)),
      m_chance(std::move(makePrecise)) {}

Pictures::~Pictures() = default;

void Pictures::want(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  m_count = static_cast<int>(scenes.size());
  for (int i = 0; i < m_count; ++i)
    m_sides[i].want(scenes[i], size);
  // One that nobody looks at any more would hold its volume, whichever is opened next, and its pictures.
  for (int i = m_count; i < static_cast<int>(m_sides.size()); ++i)
    if (m_sides[i].scene().volume)
      m_sides[i] = SidePicture(*m_screen);
  m_rest.want(scenes, size);
  m_refinement.reset();
  m_light.reset();
  m_chance.reset();
  m_isFinal = false;
}

// Follow what is shown: its error is estimated, and whether it sees the transfer function.
void Pictures::noteShown() {
  std::vector<Scene> shown;
  for (int i = 0; i < m_count; ++i) {
    shown.push_back(m_sides[i].shownScene());
    m_isResolved[i] = isResolved(*m_engine, shown.back());
    m_isLightMeasured[i] =
        !hasTravellingLight(shown.back()) || m_engine->facts(shown.back()).findsLightOfSamples;
  }
  m_limitation = translated(m_engine->limitation());
  if (m_count > 0)
    m_probe.want(shown, m_sides[0].size());
}

bool Pictures::probeError() {
  m_screen->reset();
  return m_probe.step(*m_engine);
}

RestTurn Pictures::workAtRest(bool refines, double budgetMs) {
  m_screen->reset();
  if (const RestTurn turn = m_refinement.completeLight(*m_engine, sides(), budgetMs);
      turn != RestTurn::nothing)
    return turn;
  if (m_rest.step(*m_engine))
    return m_rest.isWaiting() ? RestTurn::waiting : RestTurn::worked;
  if (m_probe.step(*m_engine))
    return RestTurn::worked;
  if (!refines)
    return RestTurn::nothing;
  std::vector<std::optional<ErrorEstimate>> rough;
  rough.reserve(static_cast<std::size_t>(m_count));
  for (int i = 0; i < m_count; ++i)
    rough.push_back(m_probe.estimate(i, m_sides[i].finishedQuality().stepVoxels));
  const RestTurn turn = m_refinement.step(*m_engine, sides(), rough, budgetMs);
  for (int i = 0; turn == RestTurn::finished && i < m_count; ++i)
    m_isResolved[i] = m_refinement.hasResolved() || isResolved(*m_engine, m_sides[i].shownScene());
  if (turn == RestTurn::finished)
    m_chance.follow(sides());
  if (turn != RestTurn::nothing)
    return turn;
  if (const RestTurn light = followLight(); light != RestTurn::nothing)
    return light;
  const RestTurn check = checkByChance();
  m_isFinal = check == RestTurn::nothing;
  return check;
}

RestTurn Pictures::followLight() {
  if (!m_light.isPending(sides()))
    return RestTurn::nothing;
  std::vector<std::optional<ErrorEstimate>> ofSteps;
  for (int i = 0; i < m_count; ++i)
    ofSteps.push_back(stateOf(i).estimate);
  return m_light.step(*m_engine, sides(), ofSteps);
}

// A tolerance is a percentile of small pictures; of single pixels the drawn ones tell more.
RestTurn Pictures::checkByChance() {
  // Nobody else draws physical light.
  if (std::ranges::any_of(sides(), [](const SidePicture& side) { return isPhysical(side.scene()); }))
    return RestTurn::nothing;
  if (const RestTurn turn = m_chance.step(sides()); turn != RestTurn::nothing)
    return turn;
  for (int i = 0; i < m_count; ++i)
    if (const std::optional<ErrorByChance> error = m_chance.error(i); error && error->levels > screenLevels)
      return m_refinement.tighten(*m_engine, sides()) ? RestTurn::worked : RestTurn::nothing;
  return RestTurn::nothing;
}

SideState Pictures::stateOf(int index) const {
  const SidePicture& side = m_sides[index];
  SideState state;
  state.model = side.scene().shading.model;
  state.fraction = side.fraction();
  const Scene shown = side.shownScene();
  state.stepVoxels = shown.quality.stepVoxels * smallestSpacingMm(shown.volume->grid()) /
                     smallestSpacingMm(side.scene().volume->grid());
  state.toleranceLevels = shown.quality.toleranceLevels;
  state.coarseness = side.shownCoarseness();
  state.imageScale = side.shownImageScale();
  state.shownMs = side.shownMs();
  state.completeMs = side.completeMs();
  state.contrast = side.contrast();
  state.overflow = m_rest.overflow(index);
  state.estimate = m_refinement.estimate(index);
  state.isRough = !state.estimate;
  if (state.isRough)
    state.estimate = m_probe.estimate(index, shown.quality.stepVoxels);
  if (m_light.hasReplaced(index))
    state.estimate = m_light.estimate(index);
  if (isPhysical(side.scene())) {
    state.paths = m_refinement.paths(index).value_or(PathFigures{side.shownPaths(), {}, {}});
    state.onTheWay = m_refinement.pathsOnTheWay(index);
    state.estimate = estimateOf(*state.paths);
    state.isRough = false;
    state.msPerPath = side.msPerPath();
  }
  state.chance = m_chance.error(index);
  state.isResolved = m_isResolved[index];
  state.isLightMeasured = m_isLightMeasured[index] || m_light.estimate(index);
  return state;
}

PictureState Pictures::state() const {
  PictureState state;
  state.resting = m_count > 0;
  state.refines = m_refinement.isSearching();
  state.limitation = m_limitation;
  state.renderer = QString::fromStdString(m_engine->name());
  int finer = 0;
  for (int i = 0; i < m_count; ++i) {
    state.sides.push_back(stateOf(i));
    state.resting = state.resting && m_sides[i].finished();
    if (m_sides[i].isFiner()) {
      ++finer;
      state.refinementFraction += m_sides[i].finerSchedule().fraction();
    }
  }
  const bool lightFollows = m_refinement.end() && m_light.isPending(sides());
  state.refines = state.refines || finer > 0 || lightFollows;
  state.refinementFraction /= std::max(finer, 1);
  if (!lightFollows)
    state.refinementEnd = m_refinement.end();
  state.isFinal = state.resting && m_isFinal;
  return state;
}

std::vector<EffectRow> Pictures::effectRowsOf(int side) {
  m_screen->reset();
  // Of what is shown: to ask about a volume that does not lie in memory takes time that nobody has while it
  // moves.
  Scene scene = m_sides[side].shownScene();
  scene.quality = m_sides[side].scene().quality;
  return effectRows(scene, m_engine->facts(scene).plan);
}

bool Pictures::hadStandIns() const {
  return std::any_of(m_sides.begin(), m_sides.begin() + m_count,
                     [](const SidePicture& side) { return side.hadStandIn(); });
}

double Pictures::makeReady(const Scene& scene, const Effort& effort, double budgetMs) {
  m_screen->reset();
  const auto start = std::chrono::steady_clock::now();
  double done = 0.0;
  do
    done = m_engine->makeReady(scene, effort);
  while (done < 1.0 && msSince(start) < budgetMs);
  return done;
}

int Pictures::finestLevel() const {
  int finest = 0;
  for (int i = 0; i < m_count; ++i)
    finest = std::max(finest, m_sides[i].finestLevel(*m_engine));
  return finest;
}

double Pictures::drawCoarsely(int level, const std::array<Columns, 2>& seen) {
  m_screen->reset();
  double ms = 0.0;
  for (int i = 0; i < m_count; ++i)
    ms += m_sides[i].drawCoarsely(*m_engine, level, seen[i]);
  noteShown();
  return ms;
}

bool Pictures::coarseLacksLight() const {
  return std::any_of(m_sides.begin(), m_sides.begin() + m_count,
                     [](const SidePicture& side) { return side.coarseLacksLight(); });
}

bool Pictures::isFindingCoarseLight() {
  return std::any_of(m_sides.begin(), m_sides.begin() + m_count, [this](const SidePicture& side) {
    return m_engine->isFindingLight(side.coarseScene());
  });
}

bool Pictures::refine(double budgetMs) {
  m_screen->reset();
  const auto start = std::chrono::steady_clock::now();
  // Draw at least one strip, then as many as the budget is likely to hold.
  for (SidePicture* side = leastComplete(); side; side = leastComplete()) {
    side->drawStrip(*m_engine);
    const SidePicture* next = leastComplete();
    if (next && msSince(start) + next->predictedMs() > budgetMs)
      return false;
  }
  // Read one picture back per turn: it takes about as long as a few strips.
  for (int i = 0; i < m_count; ++i)
    if (!m_sides[i].finished()) {
      m_sides[i].finish();
      if (i + 1 < m_count)
        return false;
    }
  noteShown();
  return true;
}

SidePicture* Pictures::leastComplete() {
  const auto end = m_sides.begin() + m_count;
  const auto least = std::min_element(m_sides.begin(), end, [](const SidePicture& a, const SidePicture& b) {
    return a.fraction() < b.fraction();
  });
  return least == end || least->complete() ? nullptr : &*least;
}

void Pictures::show(const PictureOrder& order) {
  const glm::dvec3& background = order.scenes.front().image.background;
  m_screen->reset();
  m_screen->clear(order.screen, background);
  if (m_count == 0 || static_cast<int>(order.places.size()) != m_count)
    return;
  if (order.layout == CompareLayout::difference)
    return showDifference(order, background);
  for (int position = 0; position < m_count; ++position) {
    const PixelRect& place = order.places[position];
    PixelRect part = place;
    if (order.layout == CompareLayout::wipe) {
      part.topLeft.x = position == 0 ? 0 : order.wipeColumn;
      part.size.x = position == 0 ? order.wipeColumn : order.screen.x - order.wipeColumn;
    }
    const int side = order.isSwapped ? m_count - 1 - position : position;
    m_sides[side].show(*m_screen, place, part);
  }
}

void Pictures::showDifference(const PictureOrder& order, const glm::dvec3& background) {
  const SidePicture& left = m_sides[0];
  const SidePicture& right = m_sides[1];
  const PixelRect place = order.places[0];
  const int done = std::min(left.rowsDone(), right.rowsDone());
  if (done > 0)
    m_screen->showDifference(left.finerPixels(), right.finerPixels(), place,
                             {place.topLeft, {place.size.x, done}}, background, differenceGain);
  if (done < place.size.y && left.hasCoarser() && right.hasCoarser())
    m_screen->showDifference(left.coarserPixels(), right.coarserPixels(), place,
                             {{place.topLeft.x, place.topLeft.y + done}, {place.size.x, place.size.y - done}},
                             background, differenceGain);
}

} // namespace limn
