// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/DecisionTextures.h"

#include "glsl/programs/SceneUniforms.h"
#include "glsl/textures/FunctionTable.h"
#include "scene/steps/RayFrame.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

void uploadEntries(unsigned texture, const std::vector<glm::vec4>& entries, TableFormat format) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format == TableFormat::bytes256 ? GL_RGBA8 : GL_RGBA32F,
               static_cast<int>(entries.size()), 1, 0, GL_RGBA, GL_FLOAT, entries.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void bind(TextureUnit unit, unsigned target, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(target, texture);
}

bool gathers(EffectSet effects) {
  return !effects.hasAny(
      {Effect::mip, Effect::minip, Effect::average, Effect::isosurface, Effect::preintegration});
}

} // namespace

void DecisionTextures::updateTable(const Scene& scene) {
  const TableKey key{scene.transferFunction, scene.volume->range(), stepMm(scene)};
  if (m_tableShown == key)
    return;
  const std::vector<glm::vec4> entries = tableEntries(key.function, key.range, m_decisions.table, key.stepMm);
  uploadEntries(m_table.name(), entries, m_decisions.table);
  m_tableEntries = static_cast<int>(entries.size());
  m_tableShown = key;
}

void DecisionTextures::updateGradients(const Scene& scene, const VolumeTexture& volume) {
  if (m_gradients)
    return;
  const Grid& grid = scene.volume->grid();
  m_gradients.emplace(storedGradients(textureVoxels(*scene.volume, volume.reduction()),
                                      differenceScale(grid, volume), m_decisions.gradients));
}

void DecisionTextures::updateClassified(const Scene& scene, const VolumeTexture& volume) {
  if (m_classifiedBy == scene.transferFunction)
    return;
  // The old texture goes first: two need not fit together.
  m_classified.reset();
  m_classifiedBy.reset();
  if (!m_voxels)
    m_voxels = textureVoxels(*scene.volume, volume.reduction());
  m_classified.emplace(
      classifiedVolume(*m_voxels, scene.volume->range(), scene.transferFunction, m_decisions.classification));
  m_classifiedBy = scene.transferFunction;
}

void DecisionTextures::update(const Scene& scene, const VolumeTexture& volume, EffectSet effects) {
  if (m_decisions == Decisions{})
    return;
  if (m_volume != scene.volume) {
    m_gradients.reset();
    m_classified.reset();
    m_classifiedBy.reset();
    m_voxels.reset();
    m_volume = scene.volume;
  }
  if (m_decisions.table != TableFormat::exact)
    updateTable(scene);
  if (storesGradients(m_decisions) && effects.has(Effect::gradient))
    updateGradients(scene, volume);
  if (m_decisions.classification != ClassificationOrder::afterInterpolation && gathers(effects))
    updateClassified(scene, volume);
}

void DecisionTextures::apply(const ShaderProgram& program) const {
  if (m_tableShown) {
    program.set("u_functionTable", static_cast<int>(TextureUnit::functionTable));
    const auto entries = static_cast<double>(m_tableEntries);
    program.set("u_tableScale", glm::vec2(glm::dvec2(entries - 1.0, 0.5) / entries));
    program.set("u_tableUnits",
                static_cast<float>(m_tableShown->stepMm / m_tableShown->function.unitDistanceMm));
    bind(TextureUnit::functionTable, GL_TEXTURE_2D, m_table.name());
  }
  if (m_gradients) {
    program.set("u_storedGradient", static_cast<int>(TextureUnit::storedGradient));
    program.set("u_gradientPerStored", static_cast<float>(m_gradients->unitPerStored));
    bind(TextureUnit::storedGradient, GL_TEXTURE_3D, m_gradients->texture.name());
  }
  if (m_classified) {
    program.set("u_classifiedVolume", static_cast<int>(TextureUnit::classifiedVolume));
    bind(TextureUnit::classifiedVolume, GL_TEXTURE_3D, m_classified->name());
  }
}

std::size_t DecisionTextures::bytes() const {
  return (m_gradients ? m_gradients->texture.bytes() : 0) + (m_classified ? m_classified->bytes() : 0);
}

} // namespace limn
