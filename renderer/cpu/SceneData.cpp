// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/SceneData.h"

#include "cpu/paths/PathScene.h"
#include "scene/ProjectionFacts.h"
#include "scene/steps/BlockRanges.h"
#include "scene/steps/CellRule.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limn::cpu {
namespace {

// So many unit distances hide everything; the whole box must not have more than a float holds.
constexpr double beyondAll = 1e30;

// Scenes may hold any double; an infinite float times 0 would be no number.
float asFloat(double value) {
  constexpr double most = 1e37;
  return static_cast<float>(std::clamp(value, -most, most));
}

glm::vec3 asFloats(const glm::dvec3& v) {
  return {asFloat(v.x), asFloat(v.y), asFloat(v.z)};
}

// What a brick leaves of a box; a little more, for which samples are a brick's is decided elsewhere.
IndexBox withinBrick(const IndexBox& box, const IndexBox& brick) {
  const glm::dvec3 margin(1.0 / 64.0);
  return {glm::max(box.lower, brick.lower - margin), glm::min(box.upper, brick.upper + margin)};
}

// Of normals, mm; 0 where none is smooth.
double smoothingAskedFor(const Scene& scene) {
  return smoothsNormals(scene) ? scene.shading.gradientSmoothing : 0.0;
}

// A range of one value has no unit: scalars are differences from it.
double rangeUnit(const ValueRange& range) {
  const double width = range.highest - range.lowest;
  return width > 0.0 ? width : 1.0;
}

void setFog(const Scene& scene, PictureTerms& terms) {
  terms.fogColor = asFloats(scene.fog.color);
  terms.fogStart = asFloat((scene.fog.startMm - terms.frame.anchorDistanceMm) / terms.lengthMm);
  terms.fogEnd = asFloat((scene.fog.endMm - terms.frame.anchorDistanceMm) / terms.lengthMm);
  terms.fogDensity = asFloat(scene.fog.densityPerMm * terms.lengthMm);
}

void setGradient(const Scene& scene, const GradientScale& scale, PictureTerms& terms) {
  const Grid& grid = scene.volume->grid();
  const double unitPerMm = rangeUnit(scene.volume->range()) / terms.lengthMm;
  const bool isSmoothed = terms.effects.has(Effect::smoothNormals);
  const double perStored = isSmoothed ? terms.smoothed.scale : terms.voxels.scale;
  terms.gradientScale = asFloats(perStored * terms.lengthMm / (2.0 * grid.spacingMm));
  terms.flatModulus = asFloat(std::ldexp(scale.largest / unitPerMm, -20));
  terms.perReference = scale.reference > 0.0 ? asFloat(unitPerMm / scale.reference) : 0.0f;
  const GradientCurve& curve = terms.light.curve;
  // So near 0 a logarithmic curve is a line, and so small a number no 0 yet.
  terms.curve =
      asFloat(curve.type == GradientCurve::Type::log ? std::max(curve.parameter, 1e-30) : curve.parameter);
  const glm::dvec3 light = lightTravels(terms.light, scene.camera).value_or(glm::dvec3(0.0, 0.0, -1.0));
  terms.towardsLight = towardsLightAlongAxes(light, grid);
  terms.cut = cutPlanes(grid, scene.crop);
}

} // namespace

// Those on the far side of the brick are met by pre-integrated steps, and by surfaces that lie before a
// sample; one block more knows its neighbours.
BlockBox blocksMet(const Grid& grid, const IndexBox& brick, double stepVoxels) {
  const glm::ivec3 blocks = blocksOf(grid.dims);
  const glm::dvec3 reach = glm::dvec3(2.0 + stepVoxels);
  const glm::dvec3 last(grid.dims);
  const glm::dvec3 lower = glm::clamp(brick.lower + centreIndex(grid) - reach, glm::dvec3(0.0), last);
  const glm::dvec3 upper = glm::clamp(brick.upper + centreIndex(grid) + reach, glm::dvec3(0.0), last);
  const glm::ivec3 first = glm::clamp(glm::ivec3(lower) / blockSize - 1, glm::ivec3(0), blocks - 1);
  const glm::ivec3 end = glm::clamp(glm::ivec3(upper) / blockSize + 2, first + 1, blocks);
  return {first, end};
}

void SceneData::update(const Scene& scene, const std::function<bool()>& isCancelled) {
  requireDrawable(scene);
  const Effort effort{m_threads, isCancelled, {}};
  updateVolume(scene, effort);
  if (m_functionKept != scene.transferFunction) {
    m_function = tableOf(scene.transferFunction, m_volume->range());
    m_segments = fewSegments(m_function);
    m_functionKept = scene.transferFunction;
  }
  const GradientOpacity curve = scene.gradientOpacity.value_or(GradientOpacity{});
  if (m_gradientOpacityKept != curve) {
    const double unitPerMm = rangeUnit(m_volume->range()) / smallestSpacingMm(m_volume->grid());
    m_gradientCurve = tableOf(curve, unitPerMm);
    m_gradientOpacityKept = curve;
  }
  m_region.update(scene.keep, m_voxels->part(), m_volume->room(), effort);
  m_looks.update(scene, m_voxels->part(), effort);
  updateEmptySpace(scene, effort);
}

void SceneData::makeReady(const Scene& scene, const Effort& effort) {
  requireDrawable(scene);
  const bool smooths = smoothsNormals(scene);
  const Effort all{m_threads, effort.isCancelled, effort.report};
  updateVolume(scene, smooths ? limn::partOf(all, 0.0, 0.5) : all);
  m_gradients.update(scene.volume, smoothingAskedFor(scene), limn::partOf(all, 0.5, 1.0));
}

BlockBox SceneData::partOf(const Scene& scene) const {
  const Grid& grid = scene.volume->grid();
  return m_brick ? blocksMet(grid, *m_brick, scene.quality.stepVoxels)
                 : BlockBox{glm::ivec3(0), blocksOf(grid.dims)};
}

void SceneData::updateVolume(const Scene& scene, const Effort& effort) {
  const BlockBox part = partOf(scene);
  if (m_volume == scene.volume && m_voxels->part() == part)
    return;
  if (m_volume == scene.volume) {
    m_emptySpaceKept.reset();
    m_pathsKept.reset();
    m_volume.reset(); // should it be cancelled
    m_voxels.reset();
    m_voxels.emplace(scene.volume, part, effort, m_roundsPlaces);
    m_volume = scene.volume;
    return;
  }
  m_voxels.reset();
  m_volume.reset(); // should the new one be refused
  m_empty = {};
  m_gradients = GradientField();
  m_gradientScale = {};
  m_light = {}; // keeps its volume
  m_voxels.emplace(scene.volume, part, effort, m_roundsPlaces);
  m_volume = scene.volume;
  m_steepness.reset();
  m_functionKept.reset();
  m_gradientOpacityKept.reset();
  m_emptySpaceKept.reset();
  m_pathsKept.reset();
  m_empty.distances = BlockDistances(m_volume->room());
}

void SceneData::updateEmptySpace(const Scene& scene, const Effort& effort) {
  if (classifiesOnce(scene.projection))
    return;
  const bool hasSurface = showsSurface(scene.projection);
  const EmptySpaceKey key{scene.transferFunction, scene.projection, hasSurface ? scene.isovalue : 0.0,
                          scene.keep};
  if (m_emptySpaceKept == key)
    return;
  Visibility visibility;
  if (scene.projection != Projection::isosurface)
    visibility.function = &m_function;
  if (hasSurface)
    visibility.isovalue = asFloat(normalisedValue(m_volume->range(), scene.isovalue));
  visibility.weights = &m_region.blocks();
  if (!m_looks.isEmpty()) {
    visibility.looks = &m_looks.tables();
    visibility.blockLooks = &m_looks.blocks();
  }
  m_emptySpaceKept.reset(); // should it be cancelled
  mapEmptySpace(m_voxels->blocks(), visibility, m_empty, effort);
  m_emptySpaceKept = key;
}

SceneFacts SceneData::facts(const Scene& scene) {
  SceneFacts facts;
  facts.canSkipEmptySpace = m_skipsEmptySpace;
  facts.emptyShare = m_empty.emptyShare;
  facts.hasDenseFunctions = m_function.loopSteps > 0 || m_gradientCurve.loopSteps > 0;
  if (readsSteepness(scene))
    facts.steepestPerMm = steepestPerMm();
  return facts;
}

double SceneData::steepestPerMm() {
  if (m_whole)
    return m_whole->steepestPerMm;
  if (!m_steepness)
    m_steepness = steepness(*m_volume);
  return *m_steepness;
}

// A block's faces are voxel centres; the outermost blocks also own the half voxel before the volume's end.
IndexBox SceneData::visibleBox(const Scene& scene) const {
  const Grid& grid = scene.volume->grid();
  const IndexBox whole = croppedBox(grid, CropBox{});
  if (glm::any(glm::lessThanEqual(m_empty.visible.upper, m_empty.visible.lower)))
    return {};
  const double margin = 1.0 / 64.0;
  IndexBox box = whole;
  for (int axis = 0; axis < 3; ++axis) {
    const int lower = m_voxels->part().lower[axis] + m_empty.visible.lower[axis];
    const int upper = m_voxels->part().lower[axis] + m_empty.visible.upper[axis];
    if (lower > 0)
      box.lower[axis] = lower * blockSize - margin - centreIndex(grid)[axis];
    if (upper < blocksOf(grid.dims)[axis])
      box.upper[axis] = upper * blockSize + margin - centreIndex(grid)[axis];
  }
  return box;
}

namespace {

// Whether a tolerance can be kept by equal steps first. What they miss of a function is told by its segments,
// so that it must have few. Without gradients cells are exact and cheap; samples of looks cost more than
// cells save.
bool mayBeSampledFirst(const PictureTerms& terms) {
  return terms.fineness && *terms.fineness <= mostSampledFineness && !terms.brick &&
         terms.function->segmentCount <= FewSegments::most && terms.effects.has(Effect::gradient) &&
         !terms.effects.has(Effect::xray) && !terms.effects.has(Effect::labelLooks);
}

// Equal steps of a ray whose light travels, where a tolerance is to be kept. At rest its paths take so much
// longer than samples that all steps may be fine: these take a fiftieth of the time, at any fineness.
double litStep(const Quality& quality) {
  const double fineness = *finenessOf(quality);
  return quality.light == LightDetail::moving ? sampledStep(fineness) : std::exp2(-fineness) / 4.0;
}

// Of rays of 1,000 lengths at the finest.
constexpr int mostLitSamples = 1 << 20;

// Whether scalars that show lie between such as do not: a step may run over all of them.
bool showsBand(const PiecewiseTable& table) {
  bool hasShown = false;
  for (int segment = 0; segment < table.segmentCount; ++segment) {
    const glm::vec4* texels = &table.segments[4 * static_cast<std::size_t>(segment)];
    const bool shows = texels[0].a > 0.0f || texels[1].a != 0.0f;
    if (hasShown && !shows)
      return true;
    hasShown = hasShown || shows;
  }
  return false;
}

} // namespace

PictureTerms SceneData::terms(const Scene& scene, const glm::ivec2& size, EffectSet effects,
                              const std::function<bool()>& isCancelled, const LightVolumes* light) {
  const Grid& grid = scene.volume->grid();
  PictureTerms terms;
  const auto unitsPer = [&grid](double unitDistanceMm) {
    const double length = smallestSpacingMm(grid);
    return asFloat(std::min(length / unitDistanceMm, beyondAll / (boxDiagonalMm(grid) / length)));
  };
  terms.effects = effects;
  terms.voxels = m_voxels->source();
  terms.region = m_region.source();
  terms.function = &m_function;
  terms.segments = &m_segments;
  if (effects.has(Effect::labelLooks)) {
    terms.looks = m_looks.terms(unitsPer);
    terms.function = terms.looks.together;
    terms.segments = terms.looks.segmentsTogether;
  }
  terms.gradientCurve = &m_gradientCurve;
  terms.light = lightingTerms(scene.shading);
  const bool isInFineSteps = effects.has(Effect::localSteps) && effects.hasAny(travellingLight);
  if (effects.has(Effect::localSteps) && !isInFineSteps)
    terms.fineness = finenessOf(scene.quality);
  terms.isExact = scene.quality.toleranceLevels.has_value();
  terms.voxels.roundsPlaces = m_roundsPlaces && !terms.isExact;
  terms.frame = rayFrame(scene.camera, grid, size);
  terms.size = size;
  terms.box = terms.visibleBox = croppedBox(grid, scene.crop);
  const bool skips = m_skipsEmptySpace && !classifiesOnce(scene.projection) &&
                     (effects.has(Effect::emptySpaceSkipping) || effects.has(Effect::localSteps));
  if (skips) {
    terms.empty = {m_empty.distances.data(), m_voxels->blocks().blocks(), m_voxels->part().lower};
    if (!m_region.whole().empty())
      terms.whole = {m_region.whole().data(), terms.empty.blocks, terms.empty.first};
    // A surface may be met before the first sample or behind the last, where another brick shows it.
    if (!m_brick || !showsSurface(scene.projection))
      terms.visibleBox = visibleBox(scene);
  }
  terms.brick = m_brick;
  if (m_brick)
    terms.visibleBox = withinBrick(terms.visibleBox, *m_brick);
  terms.centre = centreIndex(grid);
  terms.lengthMm = smallestSpacingMm(grid);
  terms.stepLengths = scene.quality.stepVoxels;
  if (isInFineSteps) {
    terms.stepLengths = litStep(scene.quality);
    terms.mostSamples = mostLitSamples;
  }
  terms.samplesFirst = m_samplesFirst && mayBeSampledFirst(terms);
  if (terms.samplesFirst) {
    terms.stepLengths = sampledStep(*terms.fineness);
    terms.looksAtLeaps = showsBand(*terms.function);
  }
  terms.spacing = grid.spacingMm / terms.lengthMm;
  if (!effects.has(Effect::labelLooks))
    terms.perUnitDistance = unitsPer(scene.transferFunction.unitDistanceMm);
  terms.lastTransmittance = asFloat(lastTransmittance(scene.quality.earlyTermination));
  if (effects.has(Effect::gradient)) {
    m_gradients.update(scene.volume, smoothingAskedFor(scene), {m_threads, isCancelled, {}});
    if (m_whole)
      m_gradients.know(m_whole->moduli, m_whole->percent);
    m_gradientScale = m_gradients.scale(scene.shading, usesRatio(effects), {m_threads, isCancelled, {}});
  }
  if (effects.has(Effect::smoothNormals))
    terms.smoothed = sourceOf(std::get<StoredVoxels<float>>(m_gradients.smoothed()->stored()).data(),
                              VoxelSource::Kind::single, grid.dims);
  terms.smoothed.roundsPlaces = terms.voxels.roundsPlaces;
  setGradient(scene, m_gradientScale, terms);
  setFog(scene, terms);
  terms.isovalue = asFloat(normalisedValue(m_volume->range(), scene.isovalue));
  terms.isoColor = asFloats(classify(scene.transferFunction, scene.isovalue).color);
  if (effects.hasAny(travellingLight)) {
    // Whether rays step over what is empty must not move the nodes.
    const IndexBox shows = visibleBox(scene);
    const IndexBox lit{glm::max(terms.box.lower, shows.lower), glm::min(terms.box.upper, shows.upper)};
    terms.travel = light ? travelIn(*light, scene, terms)
                         : m_light.update(scene, terms, lit, {m_threads, isCancelled, {}});
  }
  return terms;
}

PathTerms SceneData::pathTerms(const Scene& scene, const PictureTerms& terms,
                               const std::function<bool()>& isCancelled) {
  m_pathLooks = labelLooks(scene);
  PathsKey key{{m_pathLooks.functions, 1.0, terms.lengthMm, m_volume->range()}, scene.keep};
  PathTerms paths = limn::cpu::pathTerms(scene, terms);
  if (paths.gradientCurve) {
    key.majorants.mostFactor = 0.0;
    for (const GradientOpacityPoint& point : scene.gradientOpacity->points)
      key.majorants.mostFactor = std::max(key.majorants.mostFactor, point.opacity);
  }
  if (m_pathsKept != key) {
    m_pathsKept.reset(); // should it be cancelled
    m_majorants.find(key.majorants, m_voxels->blocks(), m_looks.blocks(), m_region.blocks(), m_volume->room(),
                     {m_threads, isCancelled, {}});
    m_pathsKept = key;
  }
  paths.majorants = {m_majorants.data(), m_voxels->blocks().blocks(), terms.empty.distances};
  if (m_pathLooks.areAny()) {
    paths.looks = &m_pathLooks;
    paths.keep = &scene.keep;
    for (const TransferFunction& function : m_pathLooks.functions)
      paths.perUnitOfLooks.push_back(asFloat(terms.lengthMm / function.unitDistanceMm));
  }
  return paths;
}

double SceneData::memoryMb() const {
  if (!m_voxels || m_volume->room())
    return 0.0;
  return static_cast<double>(m_voxels->ownBytes() + m_region.ownBytes() + m_looks.ownBytes() +
                             m_light.ownBytes() + m_gradients.ownBytes() + m_empty.distances.size() +
                             m_majorants.bytes()) /
         1e6;
}

} // namespace limn::cpu
