// SPDX-License-Identifier: GPL-3.0-or-later
#include "slices/SliceRenderer.h"

#include "gl/DriverHealth.h"
#include "gl/PictureTarget.h"
#include "gl/ShaderProgram.h"
#include "glsl/programs/FilterBits.h"
#include "glsl/programs/SceneUniforms.h"
#include "glsl/programs/ShaderVariant.h"
#include "glsl/textures/SceneTextures.h"
#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/steps/RayFrame.h"
#include "slices/ProxySlabs.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <map>
#include <vector>

namespace limn {
namespace {

struct Dropped {
  Effect effect;
  Message reason;
};

// What slices leave out, and why.
std::vector<Dropped> droppedBySlices() {
  return {{Effect::earlyTermination,
           Message::tr("slices are blended one after the other and none knows which pixels are done")},
          {Effect::emptySpaceSkipping, Message::tr("a slice is one sample: there is nothing to step over")},
          {Effect::longRays, Message::tr("slices do not march along rays, so no ray is too long")}};
}

// Slabs go to the driver in pieces that no watchdog takes for a hang.
constexpr std::size_t fragmentsPerDraw = std::size_t(1) << 25;

// The triangles of all slabs in the order of blending, and where each slab's begin.
struct Triangles {
  std::vector<glm::vec4> corners; // place in the viewport, near and far plane in shader lengths
  std::vector<int> starts{0};
};

void appendSlab(const ProxySlab& slab, const glm::dvec2& halfSize, double unitMm, Triangles& triangles) {
  const auto corner = [&](std::size_t i) {
    return glm::vec4(glm::vec2(slab.polygon[i] / halfSize), slab.nearMm / unitMm, slab.farMm / unitMm);
  };
  for (std::size_t i = 2; i < slab.polygon.size(); ++i)
    for (const std::size_t k : {std::size_t(0), i - 1, i})
      triangles.corners.push_back(corner(k));
  triangles.starts.push_back(static_cast<int>(triangles.corners.size()));
}

Triangles trianglesOf(const Scene& scene, const glm::ivec2& size, BlendOrder order) {
  const std::vector<ProxySlab> slabs = proxySlabs(scene, size);
  const double unitMm = lengthUnitMm(scene.volume->grid());
  Triangles triangles;
  for (std::size_t i = 0; i < slabs.size(); ++i)
    appendSlab(slabs[order == BlendOrder::frontToBack ? i : slabs.size() - 1 - i], glm::dvec2(size) / 2.0,
               unitMm, triangles);
  return triangles;
}

// The lecture's "F over B" for premultiplied colours, whether B comes last or F does.
void setBlending(BlendOrder order) {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  if (order == BlendOrder::frontToBack)
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  else
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void drawInPieces(const Triangles& triangles, const glm::ivec2& size) {
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const std::size_t piece = std::max<std::size_t>(1, fragmentsPerDraw / pixels);
  const std::size_t slabs = triangles.starts.size() - 1;
  for (std::size_t first = 0; first < slabs; first += piece) {
    const int begin = triangles.starts[first];
    glDrawArrays(GL_TRIANGLES, begin, triangles.starts[std::min(first + piece, slabs)] - begin);
    glFlush();
  }
}

} // namespace

void requireSliceable(const Scene& scene) {
  requireDrawable(scene);
  if (scene.projection != Projection::composite && scene.projection != Projection::xray)
    throw Error(Error::Kind::usage, Message::tr("Slices cannot draw the projection \"%1\", only composite "
                                                "and xray; use --engine gl or reference for it.")
                                        .arg(nameOf(scene.projection)));
  if (hasTravellingLight(scene))
    throw Error(Error::Kind::usage,
                Message::tr("Slices cannot draw shadows and occlusion; use --engine gl, cpu or reference, or "
                            "set their strength to 0."));
  if (isPhysical(scene))
    throw Error(Error::Kind::usage,
                Message::tr("Slices cannot draw physical light; use --engine cpu or another model."));
}

EffectPlan sliceEffects(const Scene& scene, const SceneFacts& facts) {
  EffectPlan plan = requiredEffects(scene, facts);
  for (const Dropped& dropped : droppedBySlices()) {
    plan.effects = plan.effects.without(dropped.effect);
    for (EffectReason& reason : plan.reasons)
      if (reason.effect == dropped.effect)
        reason = {dropped.effect, false, dropped.reason};
  }
  plan.effects = canonical(plan.effects);
  return plan;
}

struct SliceRenderer::Parts {
  BlendOrder order;
  SceneTextures textures;
  FilterBits filter;
  std::map<EffectSet, ShaderProgram> programs;
  GlBuffer corners;
  GlVertexArray vertexArray;
  Message stepLimitation;

  explicit Parts(BlendOrder blendOrder);
  const ShaderProgram& program(EffectSet effects);
  void noteStepLimit(const Scene& scene, const glm::ivec2& size);
  void draw(const Scene& scene, const glm::ivec2& size);
};

SliceRenderer::Parts::Parts(BlendOrder blendOrder) : order(blendOrder) {
  const SavedState saved;
  glBindVertexArray(vertexArray.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
}

const ShaderProgram& SliceRenderer::Parts::program(EffectSet effects) {
  const auto known = programs.find(effects);
  if (known != programs.end())
    return known->second;
  return programs.emplace(effects, ShaderProgram(sliceVertexSource(), sliceSource(effects))).first->second;
}

void SliceRenderer::Parts::noteStepLimit(const Scene& scene, const glm::ivec2& size) {
  stepLimitation = {};
  if (slabsWanted(scene, size) > mostSamples)
    stepLimitation =
        Message::tr("The step is so small that the volume would need more than %1 slices; it is drawn "
                    "with that number.")
            .arg(mostSamples);
}

void SliceRenderer::Parts::draw(const Scene& scene, const glm::ivec2& size) {
  const SavedState saved;
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, nothing);
  textures.update(scene);
  SceneFacts facts = textures.facts(scene);
  if (scene.quality.ownWeights)
    facts.filterBits = filter.measured();
  const EffectPlan plan = sliceEffects(scene, facts);
  if (!plan.isVisible)
    return;
  textures.measure(scene, plan.effects);
  const ShaderProgram& shader = program(plan.effects);
  shader.use();
  setUniforms(shader, scene, size, textures);
  bindTextures(textures);
  glViewport(0, 0, size.x, size.y);
  const Triangles triangles = trianglesOf(scene, size, order);
  glBindVertexArray(vertexArray.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.corners.size() * sizeof(glm::vec4)),
               triangles.corners.data(), GL_STREAM_DRAW);
  setBlending(order);
  drawInPieces(triangles, size);
}

SliceRenderer::SliceRenderer(BlendOrder order) {
  requireOpenGl3();
  m_parts = std::make_unique<Parts>(order);
}
SliceRenderer::~SliceRenderer() = default;
SliceRenderer::SliceRenderer(SliceRenderer&&) noexcept = default;
SliceRenderer& SliceRenderer::operator=(SliceRenderer&&) noexcept = default;

Image SliceRenderer::render(const Scene& scene, const glm::ivec2& size) {
  requireSliceable(scene);
  m_parts->noteStepLimit(scene, size);
  forgetDriverErrors();
  const FloatTarget target(size);
  m_parts->draw(scene, size);
  Image image = readBack(size);
  requireHealthyDriver(Message::tr("drawing a picture of slices"));
  return image;
}

int SliceRenderer::filterBits() {
  return m_parts->filter.measured();
}

Message SliceRenderer::limitation() const {
  return m_parts->textures.limitation().followedBy(" ", m_parts->stepLimitation);
}

} // namespace limn
