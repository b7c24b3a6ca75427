// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/VolumeTexture.h"

#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/steps/BlockGatherer.h"
#include "scene/volume/RowPieces.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// What lies beyond the outermost of so many inner texels along an axis.
float beyond(float outermost, float next, int inner) {
  return inner > 1 ? 2.0f * outermost - next : outermost;
}

// Writes a row of texels with its ends; each is the mean of its box of voxels.
template <class T>
void fillRow(const StoredVoxels<T>& stored, const Volume& volume, const glm::ivec3& reduction, int j, int k,
             int inner, float* row) {
  const glm::ivec3 dims = volume.grid().dims;
  const Rescale rescale = volume.rescale();
  const ValueRange range = volume.range();
  const auto texelOf = [&](double mean) {
    return static_cast<float>(normalisedValue(range, rescale.slope * mean + rescale.intercept));
  };
  if (reduction == glm::ivec3(1)) {
    const T* voxels = &stored[voxelOffset(dims, 0, j, k)];
    for (int i = 0; i < inner; ++i)
      row[i + 1] = texelOf(static_cast<double>(voxels[i]));
  } else {
    for (int i = 0; i < inner; ++i) {
      const glm::ivec3 from = glm::ivec3(i, j, k) * reduction;
      const glm::ivec3 to = glm::min(from + reduction, dims);
      double sum = 0.0;
      for (int z = from.z; z < to.z; ++z)
        for (int y = from.y; y < to.y; ++y)
          for (int x = from.x; x < to.x; ++x)
            sum += static_cast<double>(stored[voxelOffset(dims, x, y, z)]);
      const glm::ivec3 box = to - from;
      row[i + 1] = texelOf(sum / (static_cast<double>(box.x) * box.y * box.z));
    }
  }
  row[0] = beyond(row[1], row[2], inner);
  row[inner + 1] = beyond(row[inner], row[inner - 1], inner);
}

// Writes the plane of inner texels k with its edges.
template <class T>
void fillInnerPlane(const StoredVoxels<T>& stored, const Volume& volume, const glm::ivec3& reduction, int k,
                    float* plane) {
  const glm::ivec3 inner = reducedDims(volume.grid().dims, reduction);
  const int width = inner.x + 2;
  const auto rowAt = [&](int y) { return plane + static_cast<std::ptrdiff_t>(y) * width; };
  for (int j = 0; j < inner.y; ++j)
    fillRow(stored, volume, reduction, j, k, inner.x, rowAt(j + 1));
  for (int x = 0; x < width; ++x) {
    rowAt(0)[x] = beyond(rowAt(1)[x], rowAt(2)[x], inner.y);
    rowAt(inner.y + 1)[x] = beyond(rowAt(inner.y)[x], rowAt(inner.y - 1)[x], inner.y);
  }
}

// Writes texel plane z; the outermost two are extrapolated.
template <class T>
void fillPlane(const StoredVoxels<T>& stored, const Volume& volume, const glm::ivec3& reduction, int z,
               float* plane) {
  const glm::ivec3 inner = reducedDims(volume.grid().dims, reduction);
  const int nearest = std::clamp(z - 1, 0, inner.z - 1);
  fillInnerPlane(stored, volume, reduction, nearest, plane);
  if (nearest == z - 1 || inner.z == 1)
    return;
  std::vector<float> next((inner.x + std::size_t{2}) * (inner.y + std::size_t{2}));
  fillInnerPlane(stored, volume, reduction, z == 0 ? 1 : inner.z - 2, next.data());
  for (std::size_t i = 0; i < next.size(); ++i)
    plane[i] = beyond(plane[i], next[i], inner.z);
}

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

// Blocks are uploaded and looked at in so many layers at a time, or as have so many texels: these are floats,
// and all of them at once would take several times the memory of the volume. On two cores a piece takes some
// ten ms.
constexpr int layersAtATime = 4;
constexpr std::size_t texelsAtATime = std::size_t{1} << 22;

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

std::string times(const glm::ivec3& v) {
  return std::to_string(v.x) + "×" + std::to_string(v.y) + "×" + std::to_string(v.z);
}

// Halves the resolution along the axis that has most texels.
void reduceLongest(const glm::ivec3& dims, glm::ivec3& reduction) {
  const glm::ivec3 reduced = reducedDims(dims, reduction);
  const int axis = reduced.x >= reduced.y && reduced.x >= reduced.z ? 0 : reduced.y >= reduced.z ? 1 : 2;
  if (reduced[axis] < 2)
    throw Error(Error::Kind::openGl, Message::tr("The graphics driver refused even a tiny 3D texture; update "
                                                 "the driver or draw with --engine cpu."));
  ++reduction[axis];
}

} // namespace

glm::ivec3 reducedDims(const glm::ivec3& dims, const glm::ivec3& reduction) {
  return (dims + reduction - 1) / reduction;
}

void fillPlanes(const Volume& volume, const glm::ivec3& reduction, int first, int end, float* to) {
  const glm::ivec3 size = reducedDims(volume.grid().dims, reduction) + 2;
  visitVoxels(volume, [&](const auto& stored) {
    forEachPiece(end - first, {}, [&](int plane) {
      fillPlane(stored, volume, reduction, first + plane, to + voxelOffset(size, 0, 0, plane));
    });
  });
}

TextureVoxels textureVoxels(const Volume& volume, const glm::ivec3& reduction) {
  TextureVoxels voxels;
  voxels.reduction = reduction;
  voxels.size = reducedDims(volume.grid().dims, reduction) + 2;
  voxels.texels.resize(static_cast<std::size_t>(voxels.size.x) * voxels.size.y * voxels.size.z);
  fillPlanes(volume, reduction, 0, voxels.size.z, voxels.texels.data());
  return voxels;
}

float quantised(float texel, const ValueRange& stored, int parts) {
  const double part = (stored.highest - stored.lowest) / parts;
  const double place = (std::clamp<double>(texel, stored.lowest, stored.highest) - stored.lowest) / part;
  return static_cast<float>(stored.lowest + std::round(place) * part);
}

glm::ivec2 planesOfLayer(const glm::ivec3& size, int layer) {
  const int first = layer * blockSize;
  return {first, std::min(first + blockSize + 3, size.z)};
}

void gatherLayers(const float* texels, const glm::ivec3& size, int first, int end, BlockRanges& ranges) {
  const glm::ivec3 blocks = ranges.blocks();
  const int firstPlane = planesOfLayer(size, first).x;
  const RowPieces rows({blocks.x, blocks.y, end - first}, blockSize * blockSize * blockSize);
  shareOut(rows.pieces(), {}, [&](Pieces& pieces) {
    BlockGatherer<float> own(size - 2);
    BlockGatherer<float> around(size - 2, 1);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&](int j, int layer) {
        const int k = first + layer;
        const auto rowAt = [&](int x) {
          return [&, x](int y, int z) { return texels + voxelOffset(size, x, y + 1, z + 1 - firstPlane); };
        };
        own.gather(j, k, rowAt(1));
        around.gather(j, k, rowAt(0));
        for (int i = 0; i < blocks.x; ++i) {
          // Beyond a face the texels there weigh no more than the margin, along each of three axes.
          const float lowest = around.lowest(i);
          const float highest = around.highest(i);
          const float beyond = 3.0f * blockMargin * (highest - lowest);
          ranges.set({i, j, k},
                     {std::max(own.lowest(i) - beyond, lowest), std::min(own.highest(i) + beyond, highest)});
        }
      });
  });
}

VolumeTexture::VolumeTexture(const Volume& volume, VolumeFormat format, const VolumeRoom& room)
    : m_format(format), m_room(room), m_dims(volume.grid().dims) {
  requireInMemory(volume);
  allocate();
}

// Makes room for the whole; less where the driver has none and less may be shown.
void VolumeTexture::allocate() {
  const GLint stored = internalFormat(m_format);
  const auto isTooLarge = [&] {
    const glm::ivec3 size = reducedDims(m_dims, m_reduction) + 2;
    return static_cast<double>(bytesOf(size, m_format)) > 1e6 * m_room.mostMb || !fits(size, stored);
  };
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  for (bool isAllocated = false; !isAllocated;) {
    while (isTooLarge())
      reduce();
    m_size = reducedDims(m_dims, m_reduction) + 2;
    forgetDriverErrors();
    glTexImage3D(GL_TEXTURE_3D, 0, stored, m_size.x, m_size.y, m_size.z, 0, GL_RED, GL_FLOAT, nullptr);
    isAllocated = glGetError() == GL_NO_ERROR;
    if (!isAllocated)
      reduce();
  }
  m_ranges = BlockRanges(blocksOf(m_size - 2));
  m_layersDone = 0;
  m_planesDone = 0;
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
  // The centre of the box lies at dims/(2·reduction) texels from the apron, the texture's at its half.
  const glm::dvec3 covered = glm::dvec3(m_dims) / glm::dvec3(m_reduction);
  m_shift = (covered - glm::dvec3(m_size - 2)) / 2.0 / glm::dvec3(m_size);
}

bool VolumeTexture::isComplete() const {
  return m_layersDone == m_ranges.blocks().z;
}

double VolumeTexture::uploadedShare() const {
  return static_cast<double>(m_layersDone) / m_ranges.blocks().z;
}

void VolumeTexture::uploadMore(const Volume& volume) {
  const std::size_t plane = static_cast<std::size_t>(m_size.x) * m_size.y;
  const int layers = std::clamp(static_cast<int>(texelsAtATime / (plane * blockSize)), 1, layersAtATime);
  const int endLayer = std::min(m_layersDone + layers, m_ranges.blocks().z);
  const glm::ivec2 planes(planesOfLayer(m_size, m_layersDone).x, planesOfLayer(m_size, endLayer - 1).y);
  m_texels.resize(plane * static_cast<std::size_t>(planes.y - planes.x));
  fillPlanes(volume, m_reduction, planes.x, planes.y, m_texels.data());
  if (m_format != VolumeFormat::r32f)
    quantise(m_format, m_texels, m_quantised);
  const std::vector<float>& source = m_format == VolumeFormat::r32f ? m_texels : m_quantised;
  forgetDriverErrors();
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, m_planesDone, m_size.x, m_size.y, planes.y - m_planesDone, GL_RED,
                  GL_FLOAT, source.data() + plane * static_cast<std::size_t>(m_planesDone - planes.x));
  if (glGetError() != GL_NO_ERROR) {
    reduce();
    return allocate();
  }
  m_planesDone = planes.y;
  gatherLayers(m_texels.data(), m_size, m_layersDone, endLayer, m_ranges);
  m_layersDone = endLayer;
  if (!isComplete())
    return;
  m_ranges.finish();
  m_texels = {};
  m_quantised = {};
}

glm::dvec3 VolumeTexture::scale() const {
  return 1.0 / (glm::dvec3(m_reduction) * glm::dvec3(m_size));
}

std::size_t VolumeTexture::bytes() const {
  return bytesOf(m_size, m_format);
}

void VolumeTexture::reduce() {
  if (!m_room.mayReduce)
    throw VolumeTooLarge(Message::tr("%1.").arg(tooLarge()));
  reduceLongest(m_dims, m_reduction);
}

Message VolumeTexture::tooLarge() const {
  const bool isOwnLimit = static_cast<double>(bytesOf(m_dims + 2, m_format)) > 1e6 * m_room.mostMb;
  return (isOwnLimit
              ? Message::tr("The volume of %1 voxels is too large for the graphics memory that it may take")
              : Message::tr("The volume of %1 voxels is too large for the graphics driver"))
      .arg(times(m_dims));
}

Message VolumeTexture::limitation() const {
  if (m_reduction == glm::ivec3(1))
    return {};
  return Message::tr("%1 and is shown with %2.").arg(tooLarge(), times(m_size - 2));
}

} // namespace limn
