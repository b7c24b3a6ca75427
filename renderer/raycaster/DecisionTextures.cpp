// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/DecisionTextures.h"

#include "gl/DriverHealth.h"
#include "glsl/programs/SceneUniforms.h"
#include "glsl/textures/SceneTextures.h"
#include "scene/steps/RayFrame.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// Lifts the components of gradients, at most 1, to where halves have all their digits: far below 65504.
constexpr float halvesLift = 0x1p15f;

// The gradient of a texel; the apron has that of its neighbour, with which it is never mixed.
glm::vec3 gradientOf(const TextureVoxels& voxels, const glm::ivec3& texel, const glm::vec3& scale) {
  const glm::ivec3 at = glm::clamp(texel, glm::ivec3(1), voxels.size - 2);
  const std::ptrdiff_t strides[3] = {1, voxels.size.x,
                                     static_cast<std::ptrdiff_t>(voxels.size.x) * voxels.size.y};
  const float* here = &voxels.texels[voxelOffset(voxels.size, at.x, at.y, at.z)];
  return scale * glm::vec3(here[strides[0]] - here[-strides[0]], here[strides[1]] - here[-strides[1]],
                           here[strides[2]] - here[-strides[2]]);
}

// Calls `function(texel number, gradient)` for a slice.
template <class Function>
void forSlice(const TextureVoxels& voxels, const glm::vec3& scale, int k, Function&& function) {
  std::size_t texel = 0;
  for (int j = 0; j < voxels.size.y; ++j)
    for (int i = 0; i < voxels.size.x; ++i)
      function(texel++, gradientOf(voxels, {i, j, k}, scale));
}

float largestModulus(const TextureVoxels& voxels, const glm::vec3& scale) {
  float largest = 0.0f;
  for (int k = 1; k + 1 < voxels.size.z; ++k)
    forSlice(voxels, scale, k, [&largest](std::size_t, const glm::vec3& gradient) {
      largest = std::max(largest, glm::dot(gradient, gradient));
    });
  return std::sqrt(largest);
}

glm::vec4 inBytes(const glm::vec3& gradient, float largest) {
  const float modulus = glm::length(gradient);
  const glm::vec3 direction = modulus > 0.0f ? gradient / modulus : glm::vec3(0.0f);
  return {0.5f + 0.5f * direction, largest > 0.0f ? modulus / largest : 0.0f};
}

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

VoxelTexture::VoxelTexture(const glm::ivec3& size, Format format, const Message& what,
                           const FillSlice& fill) {
  const std::size_t texels = static_cast<std::size_t>(size.x) * size.y * size.z;
  m_bytes = texels * (format == Format::halves ? 8 : 4);
  const GLint stored = format == Format::halves ? GL_RGBA16F : GL_RGBA8;
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  forgetDriverErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, stored, size.x, size.y, size.z, 0, GL_RGBA, GL_FLOAT, nullptr);
  if (glGetError() != GL_NO_ERROR)
    throw Error(Error::Kind::openGl,
                Message::tr("The graphics driver has no room for %1, %2 MB; draw without them.")
                    .arg(what, m_bytes / 1000000));
  std::vector<glm::vec4> slice(static_cast<std::size_t>(size.x) * size.y);
  for (int k = 0; k < size.z; ++k) {
    fill(k, slice);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, k, size.x, size.y, 1, GL_RGBA, GL_FLOAT, slice.data());
  }
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
}

StoredGradients storedGradients(const TextureVoxels& voxels, const glm::dvec3& scale, GradientFormat format) {
  const glm::vec3 scaleInFloat(scale);
  if (format == GradientFormat::halves)
    return {VoxelTexture(voxels.size, VoxelTexture::Format::halves, Message::tr("gradients in half floats"),
                         [&](int k, std::vector<glm::vec4>& texels) {
                           forSlice(voxels, scaleInFloat, k, [&](std::size_t i, const glm::vec3& gradient) {
                             texels[i] = glm::vec4(halvesLift * gradient, 0.0f);
                           });
                         }),
            1.0 / halvesLift};
  assert(format == GradientFormat::directions);
  const float largest = largestModulus(voxels, scaleInFloat);
  return {VoxelTexture(voxels.size, VoxelTexture::Format::bytes, Message::tr("gradients in bytes"),
                       [&](int k, std::vector<glm::vec4>& texels) {
                         forSlice(voxels, scaleInFloat, k, [&](std::size_t i, const glm::vec3& gradient) {
                           texels[i] = inBytes(gradient, largest);
                         });
                       }),
          largest};
}

VoxelTexture classifiedVolume(const TextureVoxels& voxels, const ValueRange& range,
                              const TransferFunction& function, ClassificationOrder order) {
  assert(order != ClassificationOrder::afterInterpolation);
  const bool isHalves = order == ClassificationOrder::beforeInHalves;
  // A volume of one value keeps its distance to that value.
  const double width = range.highest > range.lowest ? range.highest - range.lowest : 1.0;
  const std::size_t sliceTexels = static_cast<std::size_t>(voxels.size.x) * voxels.size.y;
  return VoxelTexture(voxels.size, isHalves ? VoxelTexture::Format::halves : VoxelTexture::Format::bytes,
                      Message::tr("classified voxels"), [&](int k, std::vector<glm::vec4>& texels) {
                        const float* slice = &voxels.texels[sliceTexels * static_cast<std::size_t>(k)];
                        for (std::size_t i = 0; i < sliceTexels; ++i) {
                          const Classified at = classify(function, range.lowest + slice[i] * width);
                          texels[i] = glm::vec4(glm::dvec4(at.color * at.opacity, at.opacity));
                        }
                      });
}

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
