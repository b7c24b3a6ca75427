// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/SceneTextures.h"

#include "gl/DriverHealth.h"
#include "scene/ProjectionFacts.h"
#include "scene/basics/StableMath.h"
#include "scene/steps/BlockWalk.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

int entryCount(TableFormat format) {
  switch (format) {
  case TableFormat::exact:
    return 0;
  case TableFormat::floats1024:
    return 1024;
  case TableFormat::floats256:
  case TableFormat::bytes256:
  case TableFormat::correctedFloats:
    return 256;
  }
  return 0;
}

double valueOf(int entry, int count, const ValueRange& range) {
  return std::lerp(range.lowest, range.highest, static_cast<double>(entry) / (count - 1));
}

glm::vec4 inBytes(const glm::vec4& entry) {
  return glm::floor(entry * 255.0f + 0.5f) / 255.0f;
}

// The mean share of a box of voxels: what a texel of a reduced volume stands for.
std::uint16_t meanShare(const Region& region, const glm::ivec3& from, const glm::ivec3& to) {
  const glm::ivec3& dims = region.labels->dims();
  double sum = 0.0;
  for (int z = from.z; z < to.z; ++z)
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x)
        sum +=
            region.weights[region.labels->placeAt((static_cast<std::size_t>(z) * dims.y + y) * dims.x + x)];
  const glm::ivec3 box = to - from;
  return static_cast<std::uint16_t>(
      std::lround(65535.0 * sum / (static_cast<double>(box.x) * box.y * box.z)));
}

// A plane of texels with its apron, a copy of the outermost: weights are clamped there as the field is.
void fillPlane(const Region& region, const VolumeTexture& volume, int plane, std::vector<std::uint16_t>& to) {
  const glm::ivec3& dims = region.labels->dims();
  const glm::ivec3& size = volume.size();
  const glm::ivec3& reduction = volume.reduction();
  const int k = std::clamp(plane - 1, 0, size.z - 3);
  for (int y = 0; y < size.y; ++y) {
    const int j = std::clamp(y - 1, 0, size.y - 3);
    std::uint16_t* row = &to[static_cast<std::size_t>(y) * size.x];
    if (reduction == glm::ivec3(1))
      sharesOf(region, (static_cast<std::size_t>(k) * dims.y + j) * dims.x, static_cast<std::size_t>(dims.x),
               row + 1);
    else
      for (int i = 0; i < size.x - 2; ++i) {
        const glm::ivec3 from = glm::ivec3(i, j, k) * reduction;
        row[i + 1] = meanShare(region, from, glm::min(from + reduction, dims));
      }
    row[0] = row[1];
    row[size.x - 1] = row[size.x - 2];
  }
}

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

void uploadTable(unsigned texture, const glm::ivec2& size, bool isPair, const void* texels) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, isPair ? GL_RG32F : GL_RGBA32F, size.x, size.y, 0, isPair ? GL_RG : GL_RGBA,
               GL_FLOAT, texels);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
}

} // namespace

std::vector<glm::vec4> tableEntries(const TransferFunction& function, const ValueRange& range,
                                    TableFormat format, double stepMm) {
  const int count = entryCount(format);
  std::vector<glm::vec4> entries;
  entries.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Classified at = classify(function, valueOf(i, count, range));
    double opacity = at.opacity;
    if (format == TableFormat::correctedFloats)
      opacity = oneMinusExpNeg(extinctionPerMm(opacity, function.unitDistanceMm) * stepMm);
    const glm::vec4 entry(glm::dvec4(at.color, opacity));
    entries.push_back(format == TableFormat::bytes256 ? inBytes(entry) : entry);
  }
  return entries;
}

TransferFunction tabulated(const TransferFunction& function, const ValueRange& range, TableFormat format) {
  if (format == TableFormat::exact || !(range.highest > range.lowest))
    return function;
  // A corrected opacity is 0 where the opacity is.
  const TableFormat shown = format == TableFormat::correctedFloats ? TableFormat::floats256 : format;
  const std::vector<glm::vec4> entries = tableEntries(function, range, shown, 0.0);
  TransferFunction table{function.unitDistanceMm, {}};
  for (std::size_t i = 0; i < entries.size(); ++i)
    table.points.push_back({valueOf(static_cast<int>(i), static_cast<int>(entries.size()), range),
                            glm::dvec3(entries[i]), entries[i].a});
  return table;
}

void RegionTexture::update(const Region& region, const VolumeTexture& volume) {
  if (m_region == region)
    return;
  m_texture.reset();
  m_blocks.clear();
  m_region = region;
  if (!isRestricting(region))
    return;
  m_blocks = blockWeights(region, {volume.ranges().blocks(), blockSize * volume.reduction()});
  m_texture.emplace();
  const glm::ivec3& size = volume.size();
  glBindTexture(GL_TEXTURE_3D, m_texture->name());
  forgetDriverErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R16, size.x, size.y, size.z, 0, GL_RED, GL_UNSIGNED_SHORT, nullptr);
  if (glGetError() != GL_NO_ERROR)
    throw Error(Error::Kind::openGl, Message::tr("The graphics driver has no room for the kept region; draw "
                                                 "all of the volume, or with --engine cpu."));
  std::vector<std::uint16_t> plane(static_cast<std::size_t>(size.x) * size.y);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  for (int z = 0; z < size.z; ++z) {
    fillPlane(region, volume, z, plane);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, size.x, size.y, 1, GL_RED, GL_UNSIGNED_SHORT, plane.data());
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
}

void BlockStepTexture::update(const Scene& scene) {
  if (m_volume != scene.volume) {
    m_facts = blockFacts(*scene.volume);
    m_volume = scene.volume;
    m_looks.reset();
  }
  const LabelLooks looks = labelLooks(scene);
  if (m_looks == looks && m_keep == scene.keep)
    return;
  m_steps = limn::blockSteps(scene, m_facts);
  m_looks = looks;
  m_keep = scene.keep;
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  const glm::ivec3 size = m_steps.blocks;
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, size.x, size.y, size.z, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texelsOf(m_steps).data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_NEAREST);
}

void FunctionTexture::upload(const PiecewiseTable& table) {
  const auto bins = static_cast<int>(table.bins.size());
  uploadTable(m_bins.name(), {bins, 1}, false, table.bins.data());
  uploadTable(m_segments.name(), table.segmentsSize, false, table.segments.data());
  const auto rows = static_cast<int>(table.occupancy.size()) / bins;
  uploadTable(m_occupancy.name(), {bins, rows}, true, table.occupancy.data());
  m_domain = table.domain;
  m_loopSteps = table.loopSteps;
}

void EmptySpaceTexture::upload(const glm::ivec3& blocks, const BlockDistances& distances) {
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (blocks == m_blocks)
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, blocks.x, blocks.y, blocks.z, GL_RED, GL_UNSIGNED_BYTE,
                    distances.data());
  else
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, blocks.x, blocks.y, blocks.z, 0, GL_RED, GL_UNSIGNED_BYTE,
                 distances.data());
  m_blocks = blocks;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_NEAREST);
}

double SceneTextures::gradientUnit() const {
  const ValueRange& range = m_volume->range();
  return (range.highest - range.lowest) / smallestSpacingMm(m_volume->grid());
}

double SceneTextures::uploadVolume(const Scene& scene) {
  if (m_volume != scene.volume)
    beginVolume(scene);
  if (!m_volumeTexture->isComplete()) {
    const std::shared_ptr<const Volume> volume = std::move(m_volume); // should the driver refuse it
    m_volume.reset();
    m_volumeTexture->uploadMore(*volume);
    m_volume = volume;
  }
  const double uploaded = m_volumeTexture->uploadedShare();
  const double smoothingMm = smoothsNormals(scene) ? scene.shading.gradientSmoothing : 0.0;
  const double ofVolume = smoothingMm > 0.0 ? 0.4 : 1.0;
  if (uploaded < 1.0)
    return ofVolume * uploaded;
  if (const double smoothed = m_gradients.more(m_volume, smoothingMm); smoothed < 1.0)
    return ofVolume + (0.9 - ofVolume) * smoothed;
  if (!m_gradients.smoothed())
    return 1.0;
  const double there = m_smoothed.uploadMore(m_gradients.smoothed(), *m_volumeTexture, m_room);
  return there < 1.0 ? 0.9 + 0.1 * there : 1.0;
}

void SceneTextures::beginVolume(const Scene& scene) {
  // The old texture goes first: two large volumes need not fit together.
  m_volumeTexture.reset();
  m_region = {};
  m_looks = {};
  m_volume.reset();
  m_functionShown.reset();
  m_emptySpaceShown.reset();
  m_gradientOpacityShown.reset();
  m_steepness.reset();
  m_gradients = GradientField();
  m_gradientScale = {};
  m_smoothed = {};
  m_volumeTexture.emplace(*scene.volume, m_decisions.volume, m_room);
  m_volume = scene.volume;
}

void SceneTextures::measure(const Scene& scene, EffectSet effects) {
  if (effects.has(Effect::gradient))
    m_gradientScale = m_gradients.scale(scene.shading, usesRatio(effects));
}

void SceneTextures::updateEmptySpace(const Scene& scene) {
  if (classifiesOnce(scene.projection))
    return;
  const bool hasSurface = showsSurface(scene.projection);
  EmptySpaceKey key{scene.transferFunction, scene.projection != Projection::isosurface, std::nullopt,
                    scene.keep};
  if (hasSurface)
    key.isovalue = scene.isovalue;
  if (!key.showsFunction)
    key.function = {};
  if (m_emptySpaceShown == key)
    return;
  Visibility visibility;
  if (key.showsFunction)
    visibility.function = &m_functionTable;
  if (hasSurface)
    visibility.isovalue = static_cast<float>(normalisedValue(m_volume->range(), scene.isovalue));
  visibility.weights = &m_region.blocks();
  if (!m_looks.isEmpty()) {
    visibility.looks = &m_looks.tables();
    visibility.blockLooks = &m_looks.ofBlocks();
  }
  const BlockRanges& ranges = m_volumeTexture->ranges();
  mapEmptySpace(ranges, visibility, m_empty);
  m_emptySpace.upload(ranges.blocks(), m_empty.distances);
  m_emptySpaceShown = key;
}

IndexBox SceneTextures::visibleBox() const {
  if (glm::any(glm::lessThanEqual(m_empty.visible.upper, m_empty.visible.lower)))
    return {};
  const Grid& grid = m_volume->grid();
  const glm::dvec3 voxelsPerTexel(m_volumeTexture->reduction());
  const auto faceAt = [&](const glm::ivec3& block, double margin) {
    // Block 0 begins at the first texel's centre, half a texel behind the volume's face.
    return (glm::dvec3(block * blockSize) + 0.5 + margin) * voxelsPerTexel;
  };
  glm::dvec3 lower = faceAt(m_empty.visible.lower, -blockMargin);
  glm::dvec3 upper = glm::min(faceAt(m_empty.visible.upper, blockMargin), glm::dvec3(grid.dims));
  for (int axis = 0; axis < 3; ++axis) {
    if (m_empty.visible.lower[axis] == 0)
      lower[axis] = 0.0;
    if (m_empty.visible.upper[axis] == m_volumeTexture->ranges().blocks()[axis])
      upper[axis] = grid.dims[axis];
  }
  // A voxel begins half an index before its centre.
  const glm::dvec3 shift = centreIndex(grid) + 0.5;
  return {lower - shift, upper - shift};
}

void SceneTextures::update(const Scene& scene) {
  while (uploadVolume(scene) < 1.0) {
  }
  if (m_looks.update(scene, *m_volumeTexture))
    m_functionShown.reset();
  if (const LabelLooks looks = labelLooks(scene); m_functionShown != looks) {
    const ValueRange& range = m_volume->range();
    m_functionTable = looks.areAny()
                          ? m_looks.together()
                          : tableOf(tabulated(scene.transferFunction, range, m_decisions.table), range);
    m_function.upload(m_functionTable);
    m_functionShown = looks;
  }
  m_region.update(scene.keep, *m_volumeTexture);
  updateEmptySpace(scene);
  if (scene.quality.toleranceLevels)
    m_blockSteps.update(scene);
  const GradientOpacity curve = scene.gradientOpacity.value_or(GradientOpacity{});
  if (m_gradientOpacityShown != curve) {
    m_gradientCurve.upload(tableOf(curve, gradientUnit()));
    m_gradientOpacityShown = curve;
  }
}

SceneFacts SceneTextures::facts(const Scene& scene) {
  SceneFacts facts;
  facts.emptyShare = m_empty.emptyShare;
  facts.hasDenseFunctions = m_function.loopSteps() + m_gradientCurve.loopSteps() > 0;
  if (readsSteepness(scene))
    facts.steepestPerMm = steepestPerMm();
  return facts;
}

double SceneTextures::steepestPerMm() {
  if (!m_steepness)
    m_steepness = steepness(*m_volume);
  return *m_steepness;
}

} // namespace limn
