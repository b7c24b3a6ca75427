// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/pictures/SidePicture.h"

#include "widgets/view/pictures/TileDrawing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace limn {
namespace {

// Wait for the drawing to end: a software renderer only then does the work.
template <class Work>
double timedMs(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A picture coarser than this is bettered once before the full one is drawn, at about a seventh of its cost.
constexpr int veryCoarse = 5;
constexpr int middleLevel = 3;

// The columns of a picture of `size` pixels that are seen, and one more to each side for smoothing.
PixelRect seenPart(const glm::ivec2& size, const Columns& seen) {
  const int first = std::max(0, static_cast<int>(std::floor(seen.from * size.x)) - 1);
  const int last = std::min(size.x, static_cast<int>(std::ceil(seen.to * size.x)) + 1);
  return {{first, 0}, {std::max(1, last - first), size.y}};
}

} // namespace

void SidePicture::want(const Scene& scene, const glm::ivec2& size) {
  m_scene = scene;
  m_size = size;
  m_pass = 0;
  m_hasMiddlePass = false;
  m_schedule = TileSchedule(size);
  m_finished = false;
  m_picture = {};
  m_finer.reset();
}

double SidePicture::drawCoarsely(DrawingEngine& engine, int level, const Columns& seen) {
  const QualityLevel quality = InteractionQuality::levelAt(level);
  PictureTarget& target = level == 0 ? m_full : m_coarse;
  const glm::ivec2 size = sizeAt(quality, m_size);
  const Scene scene = withQualityLevel(m_scene, quality);
  target.resize(size);
  // Draw one pixel first: uploads and compilation are no measure of the frames to come.
  drawTile(engine, scene, {size / 2, {1, 1}}, target);
  glFinish();
  const PixelRect part = level == 0 ? PixelRect{{0, 0}, size} : seenPart(size, seen);
  const double ms = timedMs([&] { drawTile(engine, scene, part, target); });
  m_coarseQuality = quality;
  m_coarseMs = ms;
  m_gradientScale = engine.gradientScale();
  if (level == 0) {
    m_schedule.finishedWhole(ms);
    m_completeMs = ms;
  } else if (level >= veryCoarse) {
    m_pass = middleLevel;
    m_hasMiddlePass = true;
    m_schedule = TileSchedule(sizeAt(InteractionQuality::levelAt(m_pass), m_size));
  }
  return ms;
}

void SidePicture::drawStrip(DrawingEngine& engine) {
  const QualityLevel quality = InteractionQuality::levelAt(m_pass);
  PictureTarget& target = m_pass == 0 ? m_full : m_middle;
  const glm::ivec2 size = sizeAt(quality, m_size);
  const Scene scene = withQualityLevel(m_scene, quality);
  target.resize(size);
  m_schedule.finished(timedMs([&] { drawTile(engine, scene, m_schedule.next(), target); }));
  if (!m_schedule.complete())
    return;
  if (m_pass == 0) {
    m_completeMs = m_schedule.spentMs();
    return;
  }
  std::swap(m_coarse, m_middle);
  m_coarseQuality = quality;
  m_coarseMs = m_schedule.spentMs();
  m_pass = 0;
  m_schedule = TileSchedule(m_size);
}

double SidePicture::fraction() const {
  const double middle = m_hasMiddlePass ? InteractionQuality::relativeCost(middleLevel) : 0.0;
  const double done = m_pass == 0 ? middle + m_schedule.fraction() : middle * m_schedule.fraction();
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

unsigned SidePicture::finerTexture() const {
  if (m_finished && !m_finer)
    return m_bytesTexture.texture();
  return m_pass == 0 ? m_full.texture() : m_middle.texture();
}

void SidePicture::finish() {
  adopt(limn::finished(std::make_shared<const Image>(m_full.read()), m_scene.image.background),
        m_scene.quality.stepVoxels);
  m_finishedRowMs = m_schedule.rowMs();
}

void SidePicture::adopt(FinishedPicture picture, double stepVoxels) {
  m_bytesTexture.upload(m_size, picture.upwards.constBits());
  m_picture = std::move(picture);
  m_picture.upwards = QImage();
  m_finishedStepVoxels = stepVoxels;
  m_finished = true;
}

// The full picture was read back: its place is free. Its rows take as much longer as the steps are smaller.
void SidePicture::beginFiner(double stepVoxels) {
  std::vector<double> expectedMs = m_finishedRowMs;
  for (double& ms : expectedMs)
    ms *= m_finishedStepVoxels / stepVoxels;
  m_finer = Finer{stepVoxels, TileSchedule(m_size, std::move(expectedMs))};
}

bool SidePicture::prepareFiner(DrawingEngine& engine, double stepVoxels) {
  const Scene scene = withStep(m_scene, stepVoxels);
  if (engine.facts(scene).isReady)
    return false;
  // One pixel in the middle, which is drawn again before the strips reach it.
  drawTile(engine, scene, {m_size / 2, {1, 1}}, m_full);
  glFinish();
  return true;
}

void SidePicture::drawFinerStrip(DrawingEngine& engine) {
  const Scene scene = withStep(m_scene, m_finer->stepVoxels);
  TileSchedule& schedule = m_finer->schedule;
  schedule.finished(timedMs([&] { drawTile(engine, scene, schedule.next(), m_full); }));
}

void SidePicture::adoptFiner(FinishedPicture picture) {
  adopt(std::move(picture), m_finer->stepVoxels);
  m_completeMs = m_finer->schedule.spentMs();
  m_finishedRowMs = m_finer->schedule.rowMs();
  m_finer.reset();
}

std::optional<double> SidePicture::contrast() const {
  return m_finished ? std::optional(m_picture.contrast) : std::nullopt;
}

void SidePicture::show(const PicturePresenter& presenter, PicturePresenter::Placement placement) const {
  const PixelRect part = placement.part;
  const int done = rowsDone();
  if (done > 0) {
    placement.part.size.y = done;
    presenter.show(finerTexture(), placement, m_scene.image.background);
  }
  if (done < part.size.y && hasCoarser()) {
    placement.part = {{part.topLeft.x, part.topLeft.y + done}, {part.size.x, part.size.y - done}};
    presenter.show(coarserTexture(), placement, m_scene.image.background);
  }
}

double SidePicture::shownStepVoxels() const {
  if (m_finished)
    return m_finishedStepVoxels;
  return m_scene.quality.stepVoxels * (complete() ? 1.0 : m_coarseQuality.stepFactor);
}

} // namespace limn
