// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/BlockStepTexture.h"

#include "scene/steps/EmptySpace.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

struct Texel {
  std::uint8_t distance = 0;
  std::uint8_t plain = 0;
  std::uint8_t resolving = 0;
  std::uint8_t unused = 0;
};

std::vector<Texel> texelsOf(const BlockSteps& steps) {
  BlockDistances distances;
  distances.reserve(steps.rungs.size());
  for (const StepRungs& block : steps.rungs)
    distances.push_back(block.isEmpty ? farthestBlock : 0);
  spreadDistances(steps.blocks, distances);
  std::vector<Texel> texels;
  texels.reserve(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i)
    texels.push_back(
        {distances[i], static_cast<std::uint8_t>(steps.rungs[i].plain + 128), steps.rungs[i].resolving});
  return texels;
}

} // namespace

void BlockStepTexture::update(const Scene& scene) {
  if (m_volume != scene.volume) {
    m_facts = blockFacts(*scene.volume);
    m_volume = scene.volume;
    m_function.reset();
  }
  if (m_function == scene.transferFunction && m_keep == scene.keep)
    return;
  m_steps = blockSteps(m_facts, scene.transferFunction, smallestSpacingMm(m_volume->grid()),
                       factWeights(scene.keep, m_facts));
  m_function = scene.transferFunction;
  m_keep = scene.keep;
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  const glm::ivec3 size = m_steps.blocks;
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, size.x, size.y, size.z, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texelsOf(m_steps).data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_NEAREST);
}

} // namespace limn
