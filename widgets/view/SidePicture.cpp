// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h>

#include "widgets/view/SidePicture.h"

#include "widgets/view/PictureBytes.h"

#include <chrono>
#include <utility>

namespace limn {
namespace {

// Wait for the drawing to end: a software renderer only then does the work.
template <class Work> double timedMs(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

void SidePicture::want(const Scene& scene, const glm::ivec2& size) {
  m_scene = scene;
  m_size = size;
  m_schedule = TileSchedule(size);
  m_finished = false;
  m_image.reset();
  m_bytes = QImage();
}

double SidePicture::drawCoarsely(RayCaster& caster, int level) {
  const QualityLevel quality = InteractionQuality::levelAt(level);
  PictureTarget& target = level == 0 ? m_full : m_coarse;
  const glm::ivec2 size = sizeAt(quality, m_size);
  const Scene scene = withQualityLevel(m_scene, quality);
  target.resize(size);
  target.bind();
  // Draw one pixel first: uploads and compilation are no measure of the frames to come.
  caster.draw(scene, size, {size / 2, {1, 1}});
  glFinish();
  const double ms = timedMs([&] { caster.draw(scene, size, {{0, 0}, size}); });
  m_coarseFactor = quality.stepFactor;
  if (level == 0) {
    m_schedule.finishedWhole(ms);
    m_completeMs = ms;
  }
  return ms;
}

void SidePicture::drawStrip(RayCaster& caster) {
  m_full.resize(m_size);
  m_full.bind();
  m_schedule.finished(timedMs([&] { caster.draw(m_scene, m_size, m_schedule.next()); }));
  if (m_schedule.complete())
    m_completeMs = m_schedule.spentMs();
}

void SidePicture::finish() {
  m_image = m_full.read();
  m_bytes = overBackground(*m_image, m_scene.image.background);
  const QImage upwards = m_bytes.mirrored();
  m_bytesTexture.upload(m_size, upwards.constBits());
  m_finished = true;
}

void SidePicture::show(const PicturePresenter& presenter, PicturePresenter::Placement placement) const {
  const PixelRect part = placement.part;
  const int done = rowsDone();
  if (done > 0) {
    placement.part.size.y = done;
    presenter.show(fullTexture(), placement, m_scene.image.background);
  }
  if (done < part.size.y && m_coarse.texture() != 0) {
    placement.part = {{part.topLeft.x, part.topLeft.y + done}, {part.size.x, part.size.y - done}};
    presenter.show(coarseTexture(), placement, m_scene.image.background);
  }
}

double SidePicture::shownStepVoxels() const {
  return m_scene.quality.stepVoxels * (rowsDone() >= m_size.y ? 1.0 : m_coarseFactor);
}

} // namespace limn
