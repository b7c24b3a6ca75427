// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/LightTextures.h"

#include "gl/DriverHealth.h"
#include "glsl/programs/SceneUniforms.h"
#include "scene/basics/Error.h"

#include <epoxy/gl.h>

#include <array>
#include <cstdint>

namespace limn {
namespace {

// A single node to which all light comes.
constexpr std::array<std::uint8_t, 1> allDirect{255};
constexpr std::array<std::uint8_t, 4> allAmbient{255, 127, 127, 127};

void uploadNodes(std::optional<GlTexture>& texture, bool isAmbient, const glm::ivec3& count,
                 const void* codes) {
  texture.emplace();
  glBindTexture(GL_TEXTURE_3D, texture->name());
  glTexImage3D(GL_TEXTURE_3D, 0, isAmbient ? GL_RGBA8 : GL_R8, count.x, count.y, count.z, 0,
               isAmbient ? GL_RGBA : GL_RED, GL_UNSIGNED_BYTE, codes);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
}

void bindNodes(TextureUnit unit, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_3D, texture);
}

// From voxels to texture coordinates; without nodes the single one there is.
void setPlace(const ShaderProgram& program, const char* scale, const char* offset, const LightNodes& nodes) {
  const bool isKnown = nodes.count.x > 0;
  const glm::dvec3 count = isKnown ? glm::dvec3(nodes.count) : glm::dvec3(1.0);
  // The first node lies in the middle of the first texel.
  const glm::dvec3 perVoxel = isKnown ? 1.0 / (nodes.stride * count) : glm::dvec3(0.0);
  program.set(scale, glm::vec3(perVoxel));
  program.set(offset, glm::vec3(0.5 / count - nodes.first * perVoxel));
}

} // namespace

void LightTextures::update(const LightVolumes& light) {
  if (m_direct && light == m_light)
    return;
  forgetDriverErrors();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (!m_direct || light.directNodes != m_light.directNodes || light.direct != m_light.direct)
    uploadNodes(m_direct, false, light.direct ? light.directNodes.count : glm::ivec3(1),
                light.direct ? static_cast<const void*>(light.direct->data()) : allDirect.data());
  if (!m_ambient || light.ambientNodes != m_light.ambientNodes || light.ambient != m_light.ambient)
    uploadNodes(m_ambient, true, light.ambient ? light.ambientNodes.count : glm::ivec3(1),
                light.ambient ? static_cast<const void*>(light.ambient->data()) : allAmbient.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (glGetError() != GL_NO_ERROR) {
    m_direct.reset();
    m_ambient.reset();
    throw Error(Error::Kind::openGl, Message::tr("The graphics driver has no room for shadows and occlusion; "
                                                 "draw without them, or with --engine cpu."));
  }
  m_light = light;
}

LightLook LightTextures::lookOn(const Grid& grid, bool isFine) const {
  return m_light.areKnown() ? lightLook(m_light, grid, isFine) : LightLook();
}

bool LightTextures::looksNear(const Grid& grid, bool isFine) const {
  return lookOn(grid, isFine).looksNear;
}

void LightTextures::apply(const ShaderProgram& program, const Grid& grid, bool isFine) const {
  if (!m_direct)
    return;
  setPlace(program, "u_directScale", "u_directOffset", m_light.directNodes);
  setPlace(program, "u_ambientScale", "u_ambientOffset", m_light.ambientNodes);
  const LightLook look = lookOn(grid, isFine);
  program.set("u_directAway", static_cast<float>(look.directAway));
  program.set("u_directAsked", static_cast<float>(look.directAsked));
  program.set("u_ambientAway", static_cast<float>(look.ambientAway));
  program.set("u_layersReach", static_cast<float>(LightLook::layersReach));
  program.set("u_looksNear", look.looksNear ? 1.0f : 0.0f);
  bindNodes(TextureUnit::directLight, m_direct->name());
  bindNodes(TextureUnit::ambientLight, m_ambient->name());
}

std::size_t LightTextures::bytes() const {
  return (m_light.direct ? m_light.direct->size() : 0) + (m_light.ambient ? 4 * m_light.ambient->size() : 0);
}

} // namespace limn
