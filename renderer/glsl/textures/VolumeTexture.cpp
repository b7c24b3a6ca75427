// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/VolumeTexture.h"

#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"
#include "glsl/textures/TextureBlocks.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <optional>

namespace limn {
namespace {

GLint internalFormat(VolumeFormat format) {
  return format == VolumeFormat::r32f ? GL_R32F : format == VolumeFormat::r16 ? GL_R16 : GL_R8;
}

std::size_t bytesOf(const glm::ivec3& size, VolumeFormat format) {
  const std::size_t each = format == VolumeFormat::r32f ? 4 : format == VolumeFormat::r16 ? 2 : 1;
  return each * static_cast<std::size_t>(size.x) * size.y * size.z;
}

bool fits(const glm::ivec3& size, GLint format) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  if (std::max({size.x, size.y, size.z}) > largest)
    return false;
  glTexImage3D(GL_PROXY_TEXTURE_3D, 0, format, size.x, size.y, size.z, 0, GL_RED, GL_FLOAT, nullptr);
  GLint width = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
  return width == size.x;
}

// What 16 bits hold (shaders/decisions/volume_wide.glsl): an extrapolated texel 2a - b lies within it.
constexpr ValueRange wideRange{-1.0, 2.0};

// Blocks are uploaded and looked at in so many layers at a time: texels are floats, and all of them at once
// would take several times the memory of the volume.
constexpr int layersAtATime = 4;

// Turns texels into what a texture of the format holds of them; returns what is uploaded for that.
void quantise(VolumeFormat format, std::vector<float>& texels, std::vector<float>& uploaded) {
  for (float& texel : texels)
    texel =
        format == VolumeFormat::r16 ? quantised(texel, wideRange, 65535) : quantised(texel, {0.0, 1.0}, 255);
  uploaded = texels;
  for (float& texel : uploaded)
    if (format == VolumeFormat::r16)
      texel = static_cast<float>((texel - wideRange.lowest) / (wideRange.highest - wideRange.lowest));
}

// Makes the texture that is bound and finds the ranges of its blocks; nothing where the driver has no memory.
std::optional<BlockRanges> upload(const Volume& volume, const glm::ivec3& reduction, VolumeFormat format) {
  const glm::ivec3 size = reducedDims(volume.grid().dims, reduction) + 2;
  const std::size_t plane = static_cast<std::size_t>(size.x) * size.y;
  forgetDriverErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, internalFormat(format), size.x, size.y, size.z, 0, GL_RED, GL_FLOAT,
               nullptr);
  if (glGetError() != GL_NO_ERROR)
    return std::nullopt;
  BlockRanges ranges(blocksOf(size - 2));
  std::vector<float> texels;
  std::vector<float> stored;
  int uploadedPlanes = 0;
  for (int layer = 0; layer < ranges.blocks().z; layer += layersAtATime) {
    const int endLayer = std::min(layer + layersAtATime, ranges.blocks().z);
    const glm::ivec2 planes(planesOfLayer(size, layer).x, planesOfLayer(size, endLayer - 1).y);
    texels.resize(plane * static_cast<std::size_t>(planes.y - planes.x));
    fillPlanes(volume, reduction, planes.x, planes.y, texels.data());
    if (format != VolumeFormat::r32f)
      quantise(format, texels, stored);
    const std::vector<float>& source = format == VolumeFormat::r32f ? texels : stored;
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, uploadedPlanes, size.x, size.y, planes.y - uploadedPlanes, GL_RED,
                    GL_FLOAT, source.data() + plane * static_cast<std::size_t>(uploadedPlanes - planes.x));
    uploadedPlanes = planes.y;
    gatherLayers(texels.data(), size, layer, endLayer, ranges);
  }
  if (glGetError() != GL_NO_ERROR)
    return std::nullopt;
  ranges.finish();
  return ranges;
}

std::string times(const glm::ivec3& v) {
  return std::to_string(v.x) + "×" + std::to_string(v.y) + "×" + std::to_string(v.z);
}

// Halves the resolution along the axis that has most texels.
void reduceLongest(const glm::ivec3& dims, glm::ivec3& reduction) {
  const glm::ivec3 reduced = reducedDims(dims, reduction);
  const int axis = reduced.x >= reduced.y && reduced.x >= reduced.z ? 0 : reduced.y >= reduced.z ? 1 : 2;
  if (reduced[axis] < 2)
    throw Error(Error::Kind::openGl, "The graphics driver refused even a tiny 3D texture; update the driver "
                                     "or draw with --engine cpu.");
  ++reduction[axis];
}

} // namespace

VolumeTexture::VolumeTexture(const Volume& volume, VolumeFormat format, const VolumeRoom& room)
    : m_format(format), m_room(room), m_dims(volume.grid().dims) {
  const GLint stored = internalFormat(format);
  const auto isTooLarge = [&] {
    const glm::ivec3 size = reducedDims(m_dims, m_reduction) + 2;
    return static_cast<double>(bytesOf(size, format)) > 1e6 * room.mostMb || !fits(size, stored);
  };
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  for (;;) {
    while (isTooLarge())
      reduce();
    m_size = reducedDims(m_dims, m_reduction) + 2;
    if (std::optional<BlockRanges> ranges = upload(volume, m_reduction, format)) {
      m_ranges = std::move(*ranges);
      break;
    }
    reduce();
  }
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
  // The centre of the box lies at dims/(2·reduction) texels from the apron, the texture's at its half.
  const glm::dvec3 covered = glm::dvec3(m_dims) / glm::dvec3(m_reduction);
  m_shift = (covered - glm::dvec3(m_size - 2)) / 2.0 / glm::dvec3(m_size);
}

glm::dvec3 VolumeTexture::scale() const {
  return 1.0 / (glm::dvec3(m_reduction) * glm::dvec3(m_size));
}

std::size_t VolumeTexture::bytes() const {
  return bytesOf(m_size, m_format);
}

void VolumeTexture::reduce() {
  if (!m_room.mayReduce)
    throw VolumeTooLarge(tooLarge() + '.');
  reduceLongest(m_dims, m_reduction);
}

std::string VolumeTexture::tooLarge() const {
  const bool isOwnLimit = static_cast<double>(bytesOf(m_dims + 2, m_format)) > 1e6 * m_room.mostMb;
  return "The volume of " + times(m_dims) + " voxels is too large for the graphics " +
         (isOwnLimit ? "memory that it may take" : "driver");
}

std::string VolumeTexture::limitation() const {
  if (m_reduction == glm::ivec3(1))
    return {};
  return tooLarge() + " and is shown with " + times(m_size - 2) + ".";
}

} // namespace limn
