// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/RayCaster.h"

#include "cpu/LightFinder.h"
#include "engine/PixelRect.h"
#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"
#include "gl/PictureTarget.h"
#include "glsl/programs/FilterBits.h"
#include "glsl/programs/SceneUniforms.h"
#include "glsl/programs/ShaderVariant.h"
#include "glsl/textures/SceneTextures.h"
#include "raycaster/DecisionTextures.h"
#include "raycaster/LightTextures.h"
#include "raycaster/ProgramCache.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "scene/steps/LocalSteps.h"
#include "scene/steps/RayFrame.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace limn {
namespace {

// OpenGL's rows go upwards.
void scissor(const PixelRect& rect, const glm::ivec2& size) {
  glScissor(rect.topLeft.x, size.y - rect.topLeft.y - rect.size.y, rect.size.x, rect.size.y);
}

} // namespace

// What is drawn of a scene.
enum class Content { picture, unlimitedPicture, sampleCounts };

struct RayCaster::Parts {
  Decisions decisions;
  SceneTextures textures;
  DecisionTextures decisionTextures;
  LightTextures light;
  std::optional<LightFinder> finder;
  KnowLight knowLight;
  std::optional<LightVolumes> heldLight;
  ProgramCache programs;
  ProgramCache nodePrograms; ///< of light that nodes alone tell
  FilterBits filter;
  GlBuffer corners;
  GlVertexArray vertexArray;
  Message stepLimitation;
  bool skipsEmptySpace = true;
  bool compilesAllEffects = false;
  std::optional<EffectSet> leftOut;

  Parts(const Decisions& chosen, const VolumeRoom& room);
  SceneFacts facts(const Scene& scene);
  EffectPlan plan(const Scene& scene);
  void measure(const Scene& scene, EffectSet effects);
  EffectSet programFor(EffectSet needed, Content content) const;
  void draw(const Scene& scene, Content content, const glm::ivec2& size, const PixelRect& tile);
  IndexBox drawnBox(const Scene& scene, EffectSet effects) const;
  void drawWith(const ShaderProgram& shader, const Scene& scene, const glm::ivec2& size);
  Image render(const Scene& scene, Content content, const glm::ivec2& size, const Effort& effort = {});
  void noteStepLimit(const Scene& scene);
  LightVolumes lightOf(const Scene& scene);
  void updateLight(const Scene& scene, EffectSet effects);
  const ShaderProgram& programOf(EffectSet effects, const Scene& scene);
  bool isOfNodes(EffectSet effects, const Scene& scene);
  void tryOut(ProgramCache& cache, EffectSet effects, const Scene& scene, const glm::ivec2& size);
};

RayCaster::Parts::Parts(const Decisions& chosen, const VolumeRoom& room)
    : decisions(chosen), textures(chosen, room), decisionTextures(chosen), programs(chosen),
      nodePrograms(
          chosen,
          [chosen](EffectSet effects) { return fragmentSource(effects, chosen, LightFrom::nodesAlone); },
          ProgramCache::most / 5),
      filter(chosen) {
  const SavedState saved;
  const float triangle[] = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
  glBindVertexArray(vertexArray.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners.name());
  glBufferData(GL_ARRAY_BUFFER, sizeof(triangle), triangle, GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void RayCaster::Parts::noteStepLimit(const Scene& scene) {
  stepLimitation = limn::stepLimitation(scene, sampleLimit(scene, textures));
}

SceneFacts RayCaster::Parts::facts(const Scene& scene) {
  requireDrawable(scene);
  requireLightOfShaders(scene);
  textures.update(scene);
  noteStepLimit(scene);
  SceneFacts facts = textures.facts(scene);
  facts.canSkipEmptySpace = skipsEmptySpace;
  if (scene.quality.ownWeights)
    facts.filterBits = filter.measured();
  return facts;
}

EffectPlan RayCaster::Parts::plan(const Scene& scene) {
  return requiredEffects(scene, facts(scene));
}

void RayCaster::Parts::measure(const Scene& scene, EffectSet effects) {
  textures.measure(scene, effects);
  decisionTextures.update(scene, textures.volume(), effects);
}

LightVolumes RayCaster::Parts::lightOf(const Scene& scene) {
  if (!knowLight && !finder)
    finder.emplace();
  return knowLight ? knowLight(scene) : finder->find(scene);
}

void RayCaster::Parts::updateLight(const Scene& scene, EffectSet effects) {
  if (effects.hasAny(travellingLight))
    light.update(heldLight ? *heldLight : lightOf(scene));
}

EffectSet RayCaster::Parts::programFor(EffectSet needed, Content content) const {
  if (content == Content::sampleCounts)
    return canonical(needed.with(Effect::sampleCounts));
  if (content == Content::unlimitedPicture)
    needed = canonical(needed.with(Effect::unlimited));
  if (leftOut)
    needed = leavingOut(needed, *leftOut);
  return compilesAllEffects ? withAllNeutral(needed) : needed;
}

void RayCaster::Parts::draw(const Scene& scene, Content content, const glm::ivec2& size,
                            const PixelRect& tile) {
  const SavedState saved;
  const EffectPlan needed = plan(scene);
  // Rays follow gl_FragCoord in the whole picture, so any tile gives the same pixels.
  glViewport(0, 0, size.x, size.y);
  glEnable(GL_SCISSOR_TEST);
  scissor(tile, size);
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, nothing);
  const bool countsEqualSteps = content == Content::sampleCounts && !finenessOf(scene.quality);
  if (!needed.isVisible && !countsEqualSteps)
    return;
  const EffectSet effects = programFor(needed.effects, content);
  scissor(
      intersection(tile, coveredPixels(scene.camera, scene.volume->grid(), drawnBox(scene, effects), size)),
      size);
  measure(scene, needed.effects);
  updateLight(scene, needed.effects);
  drawWith(programOf(effects, scene), scene, size);
}

// While something moves nodes alone tell of light. The other program draws the same, several times as slowly
// in a software driver: it serves where the driver refuses this one, and at rest; until fine light is there,
// only if it is at hand.
const ShaderProgram& RayCaster::Parts::programOf(EffectSet effects, const Scene& scene) {
  if (leftOut || compilesAllEffects)
    return programs.exactly(effects);
  if (isOfNodes(effects, scene))
    try {
      return nodePrograms.programFor(effects);
    } catch (const DriverError&) {
      // Asked once: from now on it is known to be refused.
    }
  return programs.programFor(effects);
}

bool RayCaster::Parts::isOfNodes(EffectSet effects, const Scene& scene) {
  const bool isFine = asksFineLight(scene.quality);
  return !leftOut && !compilesAllEffects && effects.hasAny(travellingLight) &&
         !light.looksNear(scene.volume->grid(), isFine) &&
         (nodePrograms.isAtHand(effects) || (!isFine && !nodePrograms.has(effects)));
}

// The box outside which all pixels are empty.
IndexBox RayCaster::Parts::drawnBox(const Scene& scene, EffectSet effects) const {
  const IndexBox cropped = croppedBox(scene.volume->grid(), scene.crop);
  if (!effects.has(Effect::emptySpaceSkipping))
    return cropped;
  const IndexBox visible = textures.visibleBox();
  return {glm::max(cropped.lower, visible.lower), glm::min(cropped.upper, visible.upper)};
}

void RayCaster::Parts::drawWith(const ShaderProgram& shader, const Scene& scene, const glm::ivec2& size) {
  shader.use();
  setUniforms(shader, scene, size, textures);
  bindTextures(textures);
  decisionTextures.apply(shader);
  light.apply(shader, scene.volume->grid(), asksFineLight(scene.quality));
  glBindVertexArray(vertexArray.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image RayCaster::Parts::render(const Scene& scene, Content content, const glm::ivec2& size,
                               const Effort& effort) {
  forgetDriverErrors();
  const FloatTarget target(size);
  for (int y = 0; y < size.y; y += tileSize) {
    for (int x = 0; x < size.x; x += tileSize) {
      draw(scene, content, size, {{x, y}, glm::min(glm::ivec2(tileSize), size - glm::ivec2(x, y))});
      glFlush();
      if (effort.isCancelled) {
        glFinish(); // what waits in a queue could not be ended
        if (effort.isCancelled())
          throw Cancelled();
      }
    }
    if (effort.report)
      effort.report(1.0 * std::min(size.y, y + tileSize) / size.y);
  }
  Image image = readBack(size);
  requireHealthyDriver(Message::tr("drawing a picture"));
  return image;
}

// Some drivers compile only when something is drawn: one pixel is enough.
void RayCaster::Parts::tryOut(ProgramCache& cache, EffectSet effects, const Scene& scene,
                              const glm::ivec2& size) {
  glViewport(0, 0, size.x, size.y);
  glEnable(GL_SCISSOR_TEST);
  glScissor(size.x / 2, size.y / 2, 1, 1);
  measure(scene, effects);
  drawWith(cache.exactly(effects), scene, size);
}

RayCaster::RayCaster(EmptySpace emptySpace, Programs programs, const Decisions& decisions,
                     const VolumeRoom& room) {
  requireOpenGl3();
  m_parts = std::make_unique<Parts>(decisions, room);
  m_parts->skipsEmptySpace = emptySpace == EmptySpace::skipped;
  m_parts->compilesAllEffects = programs == Programs::allEffects;
}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::askForLight(KnowLight knowLight) {
  m_parts->knowLight = std::move(knowLight);
}

void RayCaster::draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile) {
  m_parts->draw(scene, Content::picture, size, tile);
}

Image RayCaster::render(const Scene& scene, const glm::ivec2& size, const Effort& effort) {
  return m_parts->render(scene, Content::picture, size, effort);
}

Image RayCaster::renderUnlimited(const Scene& scene, const glm::ivec2& size) {
  return m_parts->render(scene, Content::unlimitedPicture, size);
}

std::vector<int> RayCaster::sampleCounts(const Scene& scene, const glm::ivec2& size) {
  const Image image = m_parts->render(scene, Content::sampleCounts, size);
  std::vector<int> counts;
  for (const glm::vec4& pixel : image.pixels)
    counts.push_back(static_cast<int>(pixel.r));
  return counts;
}

EffectPlan RayCaster::plan(const Scene& scene) {
  const SavedState saved;
  return m_parts->plan(scene);
}

SceneFacts RayCaster::sceneFacts(const Scene& scene) {
  const SavedState saved;
  return m_parts->facts(scene);
}

double RayCaster::makeReady(const Scene& scene) {
  requireDrawable(scene);
  const SavedState saved;
  return m_parts->textures.uploadVolume(scene);
}

void RayCaster::prepare(const Scene& scene) {
  const SavedState saved;
  const EffectSet effects = m_parts->plan(scene).effects;
  m_parts->measure(scene, effects);
  m_parts->updateLight(scene, effects);
}

double RayCaster::volumeMb() const {
  const SceneTextures& textures = m_parts->textures;
  const std::size_t bytes = textures.volume().bytes() + textures.smoothed().bytes() +
                            m_parts->decisionTextures.bytes() + m_parts->light.bytes();
  return static_cast<double>(bytes) / 1e6;
}

void RayCaster::leaveOut(std::optional<EffectSet> effects) {
  m_parts->leftOut = effects;
}

LightVolumes RayCaster::lightOf(const Scene& scene) {
  return hasTravellingLight(scene) ? m_parts->lightOf(scene) : LightVolumes();
}

void RayCaster::holdLight(const std::optional<LightVolumes>& light) {
  m_parts->heldLight = light;
}

std::string RayCaster::fragmentShader(const Scene& scene) {
  const EffectPlan needed = plan(scene);
  if (!needed.isVisible)
    return {};
  const EffectSet effects = m_parts->programFor(needed.effects, Content::picture);
  const LightFrom lightFrom =
      m_parts->isOfNodes(effects, scene) ? LightFrom::nodesAlone : LightFrom::nodesAndNear;
  return fragmentSource(effects, m_parts->decisions, lightFrom).text;
}

bool RayCaster::warmUp(const Scene& scene, const glm::ivec2& size) {
  const SavedState saved;
  const EffectPlan needed = m_parts->plan(scene);
  if (!needed.isVisible)
    return false;
  if (!m_parts->programs.has(needed.effects)) {
    m_parts->tryOut(m_parts->programs, needed.effects, scene, size);
    return true;
  }
  if (needed.effects.hasAny(travellingLight) && m_parts->programs.isAtHand(needed.effects) &&
      !m_parts->nodePrograms.has(needed.effects)) {
    try {
      m_parts->tryOut(m_parts->nodePrograms, needed.effects, scene, size);
    } catch (const DriverError&) {
      // Without it what moves is drawn by the other, which draws the same.
    }
    return true;
  }
  for (const Scene& neighbour : neighbours(scene)) {
    const EffectSet wanted = m_parts->plan(neighbour).effects;
    if (m_parts->programs.canDraw(wanted))
      continue;
    m_parts->tryOut(m_parts->programs, withAllNeutral(wanted), neighbour, size);
    return true;
  }
  return false;
}

DrawingFacts RayCaster::facts(const Scene& scene) {
  const SavedState saved;
  DrawingFacts facts;
  facts.plan = m_parts->plan(scene);
  facts.steepestPerMm = m_parts->textures.steepestPerMm();
  facts.takesAllSamples = m_parts->stepLimitation.empty();
  facts.filterBits = m_parts->filter.measured();
  const EffectSet program = m_parts->programFor(facts.plan.effects, Content::picture);
  ProgramCache& cache = m_parts->isOfNodes(program, scene) ? m_parts->nodePrograms : m_parts->programs;
  facts.isReady = !facts.plan.isVisible || cache.canDraw(program);
  return facts;
}

int RayCaster::compiledPrograms() const {
  return m_parts->programs.compiled() + m_parts->nodePrograms.compiled();
}

int RayCaster::filterBits() {
  return m_parts->filter.measured();
}

const GradientScale& RayCaster::gradientScale() const {
  return m_parts->textures.gradientScale();
}

Message RayCaster::limitation() const {
  return m_parts->textures.limitation().followedBy(" ", m_parts->stepLimitation);
}

} // namespace limn
