// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/SceneTextures.h"

#include "scene/RayFrame.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

void uploadTable(unsigned texture, const glm::ivec2& size, bool isScalar, const void* texels) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, isScalar ? GL_R32F : GL_RGBA32F, size.x, size.y, 0,
               isScalar ? GL_RED : GL_RGBA, GL_FLOAT, texels);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
}

} // namespace

void FunctionTexture::upload(const PiecewiseTable& table) {
  const glm::ivec2 row(static_cast<int>(table.bins.size()), 1);
  uploadTable(m_bins.name(), row, false, table.bins.data());
  uploadTable(m_segments.name(), table.segmentsSize, false, table.segments.data());
  uploadTable(m_occupancy.name(), row, true, table.occupancy.data());
  m_domain = table.domain;
  m_loopSteps = table.loopSteps;
}

void EmptySpaceTexture::upload(const glm::ivec3& blocks, const std::vector<std::uint8_t>& distances) {
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, blocks.x, blocks.y, blocks.z, 0, GL_RED, GL_UNSIGNED_BYTE,
               distances.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_NEAREST);
}

double SceneTextures::gradientUnit() const {
  const ValueRange& range = m_volume->range();
  return (range.highest - range.lowest) / smallestSpacingMm(m_volume->grid());
}

void SceneTextures::updateVolume(const Scene& scene) {
  if (m_volume == scene.volume)
    return;
  // The old texture goes first: two large volumes need not fit together.
  m_volumeTexture.reset();
  m_volume.reset();
  m_functionShown.reset();
  m_gradientOpacityShown.reset();
  m_largestGradient.reset();
  m_percentiles.clear();
  m_volumeTexture.emplace(*scene.volume);
  m_volume = scene.volume;
}

void SceneTextures::measure(const Scene& scene, EffectSet effects) {
  if (!effects.has(Effect::gradient))
    return;
  if (!m_largestGradient)
    m_largestGradient = largestGradient(*m_volume);
  m_gradientScale = {*m_largestGradient, *m_largestGradient};
  const GradientReference reference = resolvedReference(scene.shading);
  if (const auto* fixed = std::get_if<FixedReference>(&reference))
    m_gradientScale.reference = fixed->valuePerMm;
  if (const auto* percentile = std::get_if<PercentileReference>(&reference)) {
    const bool isRead = effects.has(Effect::exponentMap) || effects.has(Effect::opacityMap) ||
                        effects.has(Effect::significance);
    if (!isRead)
      return;
    auto known = m_percentiles.find(percentile->percent);
    if (known == m_percentiles.end())
      known = m_percentiles.emplace(percentile->percent, gradientPercentile(*m_volume, percentile->percent))
                  .first;
    m_gradientScale.reference = known->second;
  }
}

void SceneTextures::update(const Scene& scene) {
  updateVolume(scene);
  if (m_functionShown != scene.transferFunction) {
    const PiecewiseTable table = tableOf(scene.transferFunction, m_volume->range());
    m_function.upload(table);
    const BlockRanges& ranges = m_volumeTexture->ranges();
    m_emptySpace.upload(ranges.blocks, emptyDistances(ranges, table));
    m_functionShown = scene.transferFunction;
  }
  const GradientOpacity curve = scene.gradientOpacity.value_or(GradientOpacity{});
  if (m_gradientOpacityShown != curve) {
    m_gradientCurve.upload(tableOf(curve, gradientUnit()));
    m_gradientOpacityShown = curve;
  }
}

SceneFacts SceneTextures::facts(const Scene& scene) const {
  SceneFacts facts;
  facts.longestRaySamples = longestRaySamples(scene);
  facts.hasDenseFunctions = m_function.loopSteps() + m_gradientCurve.loopSteps() > 0;
  return facts;
}

} // namespace limn
