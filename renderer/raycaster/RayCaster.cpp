// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/RayCaster.h"

#include "gl/FloatTarget.h"
#include "gl/GlVersion.h"
#include "gl/SavedState.h"
#include "gl/ShaderProgram.h"
#include "raycaster/SceneTextures.h"
#include "raycaster/SceneUniforms.h"
#include "raycaster/ShaderVariant.h"
#include "scene/EffectSet.h"
#include "scene/RayFrame.h"

#include <epoxy/gl.h>

#include <map>

namespace limn {
namespace {

// Pictures drawn off screen go to the driver in pieces that no watchdog takes for a hang.
constexpr int tileSize = 256;

} // namespace

struct RayCaster::Parts {
  SceneTextures textures;
  std::map<EffectSet, ShaderProgram> programs;
  GlBuffer corners;
  GlVertexArray vertexArray;
  std::string stepLimitation;
  bool skipsEmptySpace = true;

  Parts();
  const ShaderProgram& program(EffectSet effects);
  EffectSet prepare(const Scene& scene, bool countsSamples);
  void draw(const Scene& scene, bool countsSamples, const glm::ivec2& size, const PixelRect& tile);
  Image render(const Scene& scene, bool countsSamples, const glm::ivec2& size);
  void noteStepLimit(const Scene& scene);
};

RayCaster::Parts::Parts() {
  const SavedState saved;
  const float triangle[] = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
  glBindVertexArray(vertexArray.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners.name());
  glBufferData(GL_ARRAY_BUFFER, sizeof(triangle), triangle, GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

const ShaderProgram& RayCaster::Parts::program(EffectSet effects) {
  const auto known = programs.find(effects);
  if (known != programs.end())
    return known->second;
  return programs.emplace(effects, ShaderProgram(vertexSource(), fragmentSource(effects))).first->second;
}

void RayCaster::Parts::noteStepLimit(const Scene& scene) {
  const int most = sampleLimit(textures);
  stepLimitation.clear();
  if (longestRaySamples(scene) > most)
    stepLimitation = "The step is so small that long rays would need more than " + std::to_string(most) +
                     " samples; they are drawn with that number.";
}

EffectSet RayCaster::Parts::prepare(const Scene& scene, bool countsSamples) {
  textures.update(scene);
  noteStepLimit(scene);
  if (countsSamples)
    return EffectSet().with(Effect::sampleCounts);
  SceneFacts facts = textures.facts(scene);
  facts.canSkipEmptySpace = skipsEmptySpace;
  const EffectSet effects = requiredEffects(scene, facts).effects;
  textures.measure(scene, effects);
  return effects;
}

void RayCaster::Parts::draw(const Scene& scene, bool countsSamples, const glm::ivec2& size,
                            const PixelRect& tile) {
  requireDrawable(scene);
  const SavedState saved;
  const ShaderProgram& shader = program(prepare(scene, countsSamples));
  shader.use();
  setUniforms(shader, scene, size, textures);
  bindTextures(textures);
  // Rays follow gl_FragCoord in the whole picture, so any tile gives the same pixels.
  glViewport(0, 0, size.x, size.y);
  glEnable(GL_SCISSOR_TEST);
  glScissor(tile.topLeft.x, size.y - tile.topLeft.y - tile.size.y, tile.size.x, tile.size.y);
  glBindVertexArray(vertexArray.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image RayCaster::Parts::render(const Scene& scene, bool countsSamples, const glm::ivec2& size) {
  const FloatTarget target(size);
  for (int y = 0; y < size.y; y += tileSize)
    for (int x = 0; x < size.x; x += tileSize) {
      draw(scene, countsSamples, size, {{x, y}, glm::min(glm::ivec2(tileSize), size - glm::ivec2(x, y))});
      glFlush();
    }
  return readBack(size);
}

RayCaster::RayCaster(EmptySpace emptySpace) {
  requireOpenGl3();
  m_parts = std::make_unique<Parts>();
  m_parts->skipsEmptySpace = emptySpace == EmptySpace::skipped;
}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile) {
  m_parts->draw(scene, false, size, tile);
}

Image RayCaster::render(const Scene& scene, const glm::ivec2& size) {
  return m_parts->render(scene, false, size);
}

std::vector<int> RayCaster::sampleCounts(const Scene& scene, const glm::ivec2& size) {
  const Image image = m_parts->render(scene, true, size);
  std::vector<int> counts;
  for (const glm::vec4& pixel : image.pixels)
    counts.push_back(static_cast<int>(pixel.r));
  return counts;
}

int RayCaster::compiledPrograms() const {
  return static_cast<int>(m_parts->programs.size());
}

const GradientScale& RayCaster::gradientScale() const {
  return m_parts->textures.gradientScale();
}

std::string RayCaster::limitation() const {
  return m_parts->textures.limitation() + m_parts->stepLimitation;
}

} // namespace limn
