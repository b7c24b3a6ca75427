// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/SidePicture.h"

#include "engine/DrawingEngine.h"
#include "scene/effects/EffectPlan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

namespace limn {
namespace {

template <class Work>
double timedMs(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A picture coarser than this is bettered once before the full one is drawn, at about a seventh of its cost.
constexpr int veryCoarse = 6;
constexpr int middleLevel = 3;

// All pixels, on the way to a picture whose light takes some minutes.
constexpr int wholeLevel = 1;

// With a tolerance many paths of light are followed.
bool hasSampledLight(const Scene& scene) {
  return scene.quality.toleranceLevels && hasTravellingLight(scene);
}

// The columns of a picture of `size` pixels that are seen, and one more to each side for smoothing.
PixelRect seenPart(const glm::ivec2& size, const Columns& seen) {
  const int first = std::max(0, static_cast<int>(std::floor(seen.from * size.x)) - 1);
  const int last = std::min(size.x, static_cast<int>(std::ceil(seen.to * size.x)) + 1);
  return {{first, 0}, {std::max(1, last - first), size.y}};
}

} // namespace

SidePicture::SidePicture(PictureScreen& screen)
    : m_coarse(screen.makeSheet()), m_middle(screen.makeSheet()), m_full(screen.makeSheet()),
      m_finishedSheet(screen.makeFinishedSheet()), m_stripMs(screen.stripMs()) {}

void SidePicture::want(const Scene& scene, const glm::ivec2& size) {
  m_scene = scene;
  m_size = size;
  m_pass = 0;
  m_hasMiddlePass = false;
  m_schedule = TileSchedule(size, m_stripMs);
  m_finished = m_lacksLight = false;
  m_picture = {};
  m_finer.reset();
  m_paths.reset();
  m_msPerPath.reset();
  m_middlePaths = m_coarsePaths = 1;
  m_spentMs = 0.0;
}

// Of a picture that is drawn on the way to the full one.
Scene SidePicture::passScene(DrawingEngine& engine, const QualityLevel& quality, const glm::ivec2& size) {
  m_standIn = engine.standInFor(m_scene, size);
  return withQualityLevel(m_standIn ? m_standIn->scene : m_scene, quality);
}

// The full picture; of physical light it goes on from the paths that were followed before.
Scene SidePicture::fullScene(DrawingEngine& engine) {
  Scene scene = withQualityLevel(m_scene, {});
  if (!isPhysical(m_scene))
    return scene;
  if (!m_paths) {
    m_followedBefore = engine.followedPaths(m_scene, m_size);
    m_paths = std::max(m_hasMiddlePass ? m_middlePaths : 1, m_followedBefore);
  }
  scene.quality.paths = m_paths;
  return scene;
}

// What was found before, as it is to be shown now.
void SidePicture::drawFollowed(DrawingEngine& engine) {
  m_paths = m_coarsePaths = engine.followedPaths(m_scene, m_size);
  Scene scene = m_scene;
  scene.quality.paths = 0;
  m_coarse->resize(m_size);
  m_coarseMs = timedMs([&] { m_coarse->draw(engine, scene, {{0, 0}, m_size}); });
  m_coarseLacksLight = m_lacksLight = false;
  m_standIn.reset();
  m_coarseQuality = {};
}

// Paths of light at rest take longer than a hand may wait.
int SidePicture::finestLevel(DrawingEngine& engine) const {
  const bool followsLight = hasTravellingLight(m_scene) && engine.facts(m_scene).findsLightOfSamples;
  return followsLight || hasSampledLight(m_scene) ? wholeLevel : 0;
}

double SidePicture::drawCoarsely(DrawingEngine& engine, int level, const Columns& seen) {
  if (isPhysical(m_scene) && engine.followedPaths(m_scene, m_size) > 0) {
    drawFollowed(engine);
    return 0.0;
  }
  const QualityLevel quality = InteractionQuality::levelAt(level);
  const glm::ivec2 size = sizeAt(quality, m_size);
  const Scene scene = passScene(engine, quality, size);
  const bool isFull = level == 0 && !m_standIn;
  PictureSheet& target = isFull ? *m_full : *m_coarse;
  target.resize(size);
  m_coarseLacksLight = engine.isFindingLight(scene);
  m_lacksLight = isFull && m_coarseLacksLight;
  // Draw one pixel first: uploads and compilation are no measure of the frames to come.
  target.draw(engine, scene, {size / 2, {1, 1}});
  const PixelRect part = level == 0 ? PixelRect{{0, 0}, size} : seenPart(size, seen);
  const double ms = timedMs([&] { target.draw(engine, scene, part); });
  m_coarseQuality = quality;
  m_coarseMs = ms;
  m_gradientScale = engine.gradientScale();
  if (isFull) {
    m_schedule.finishedWhole(ms);
    m_completeMs = ms;
  } else if (level >= veryCoarse || isPhysical(m_scene) || (hasSampledLight(m_scene) && level > wholeLevel)) {
    m_pass = hasSampledLight(m_scene) ? wholeLevel : middleLevel;
    m_hasMiddlePass = true;
    m_schedule = TileSchedule(sizeAt(InteractionQuality::levelAt(m_pass), m_size), m_stripMs);
  }
  return ms;
}

void SidePicture::drawStrip(DrawingEngine& engine) {
  const QualityLevel quality = InteractionQuality::levelAt(m_pass);
  PictureSheet& target = m_pass == 0 ? *m_full : *m_middle;
  const glm::ivec2 size = sizeAt(quality, m_size);
  Scene scene = m_pass == 0 ? fullScene(engine) : passScene(engine, quality, size);
  if (m_pass != 0 && isPhysical(m_scene))
    scene.quality.paths = m_middlePaths;
  target.resize(size);
  m_lacksLight = m_lacksLight || (m_pass == 0 && engine.isFindingLight(scene));
  m_schedule.finished(timedMs([&] { target.draw(engine, scene, m_schedule.next()); }));
  if (!m_schedule.complete())
    return;
  if (m_pass == 0) {
    m_completeMs = m_schedule.spentMs();
    if (const int followed = m_paths.value_or(0) - m_followedBefore; followed > 0)
      m_msPerPath = *m_completeMs / followed;
    m_gradientScale = engine.gradientScale(); // which the coarse picture of paths leaves as it was
    return;
  }
  std::swap(m_coarse, m_middle);
  m_coarseQuality = quality;
  m_coarseMs = m_schedule.spentMs();
  if (isPhysical(m_scene))
    return betterMiddle();
  m_pass = 0;
  m_schedule = TileSchedule(m_size, m_stripMs);
}

// As many paths again take as long as those before, but for the first two.
void SidePicture::betterMiddle() {
  const double nextMs = (m_middlePaths > 1 ? 2.0 : 1.0) * m_coarseMs;
  m_coarsePaths = m_middlePaths;
  m_spentMs += m_coarseMs;
  if (2 * m_middlePaths <= mostMiddlePaths && m_spentMs + nextMs <= middleMs)
    m_middlePaths *= 2;
  else
    m_pass = 0;
  m_schedule = TileSchedule(sizeAt(InteractionQuality::levelAt(m_pass), m_size), m_stripMs);
}

double SidePicture::fraction() const {
  const double middle = m_hasMiddlePass ? InteractionQuality::relativeCost(middleLevel) : 0.0;
  // Each of several middling pictures does half of what is left.
  const double ofMiddle =
      isPhysical(m_scene) ? 1.0 - std::exp2(-m_schedule.fraction()) / m_middlePaths : m_schedule.fraction();
  const double done = m_pass == 0 ? middle + m_schedule.fraction() : middle * ofMiddle;
  return done / (middle + 1.0);
}

int SidePicture::rowsDone() const {
  if (m_finer)
    return m_finer->schedule.rowsDone();
  if (m_finished || m_pass == 0)
    return m_finished ? m_size.y : m_schedule.rowsDone();
  // Smoothing reaches half a row further: leave out what would reach into rows not drawn yet.
  const double rowHeight = 1.0 / InteractionQuality::levelAt(m_pass).imageScale;
  return static_cast<int>(std::max(0, m_schedule.rowsDone() - 1) * rowHeight);
}

const ShownPixels& SidePicture::finerPixels() const {
  if (m_finished && !m_finer)
    return *m_finishedSheet;
  return m_pass == 0 ? *m_full : *m_middle;
}

const ShownPixels& SidePicture::coarserPixels() const {
  if (m_finer)
    return *m_finishedSheet;
  return *m_coarse;
}

void SidePicture::finish() {
  Quality quality = m_scene.quality;
  if (isPhysical(m_scene))
    quality.paths = m_paths.value_or(1);
  adopt(m_full->finished(m_scene.image.background), quality);
  m_finishedRowMs = m_schedule.rowMs();
}

void SidePicture::adopt(FinishedPicture picture, const Quality& quality) {
  m_finishedSheet->set(picture);
  m_picture = std::move(picture);
  m_finishedQuality = quality;
  m_finished = true;
}

// The full picture was read back: its place is free. Its rows share out the time as they did.
void SidePicture::beginFiner(const Quality& quality, double expectedMs) {
  std::vector<double> rowMs = m_finishedRowMs;
  const double before = std::accumulate(rowMs.begin(), rowMs.end(), 0.0);
  for (double& ms : rowMs)
    ms *= expectedMs / std::max(before, 1e-6);
  m_finer = Finer{quality, TileSchedule(m_size, m_stripMs, std::move(rowMs))};
}

Scene SidePicture::finerScene() const {
  Scene scene = m_scene;
  scene.quality = m_finer->quality;
  return scene;
}

bool SidePicture::prepareFiner(DrawingEngine& engine, double stepVoxels) {
  const Scene scene = withStep(m_scene, stepVoxels);
  if (engine.facts(scene).isReady)
    return false;
  // One pixel in the middle, which is drawn again before the strips reach it.
  m_full->draw(engine, scene, {m_size / 2, {1, 1}});
  return true;
}

void SidePicture::drawFinerStrip(DrawingEngine& engine) {
  const Scene scene = finerScene();
  TileSchedule& schedule = m_finer->schedule;
  schedule.finished(timedMs([&] { m_full->draw(engine, scene, schedule.next()); }));
}

void SidePicture::adoptFiner(FinishedPicture picture) {
  const int followed = m_finer->quality.paths.value_or(0) - m_finishedQuality.paths.value_or(0);
  adopt(std::move(picture), m_finer->quality);
  m_completeMs = m_finer->schedule.spentMs();
  if (followed > 0)
    m_msPerPath = *m_completeMs / followed;
  m_finishedRowMs = m_finer->schedule.rowMs();
  m_finer.reset();
  m_lacksLight = false;
}

std::optional<double> SidePicture::contrast() const {
  return m_finished ? std::optional(m_picture.contrast) : std::nullopt;
}

void SidePicture::show(PictureScreen& screen, const PixelRect& place, const PixelRect& part) const {
  const glm::dvec3& background = m_scene.image.background;
  const int done = rowsDone();
  if (done > 0)
    screen.show(finerPixels(), place, {part.topLeft, {part.size.x, done}}, background);
  if (done < part.size.y && hasCoarser())
    screen.show(coarserPixels(), place,
                {{part.topLeft.x, part.topLeft.y + done}, {part.size.x, part.size.y - done}}, background);
}

std::optional<Coarseness> SidePicture::shownCoarseness() const {
  return m_standIn && !complete() ? std::optional(m_standIn->coarseness) : std::nullopt;
}

Scene SidePicture::shownScene() const {
  if (complete() && !m_finished)
    return withQualityLevel(m_scene, {});
  if (!m_finished)
    return withQualityLevel(m_standIn ? m_standIn->scene : m_scene, m_coarseQuality);
  Scene scene = m_scene;
  scene.quality = m_finishedQuality;
  return scene;
}

} // namespace limn
