// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/LightStore.h"

#include "cpu/rays/Threads.h"
#include "cpu/simd/FindLight.h"
#include "scene/light/LightDirections.h"
#include "scene/steps/BlockRanges.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace limn::cpu {
namespace {

// Of the voxels' bytes, for the nodes of a grid.
constexpr std::size_t shareOfVoxels = 8;

// So many nodes of a light are found while a hand moves, and within seconds of its rest. The shadow of a
// small lamp has an edge, and where that falls shows to half a voxel: more nodes in fewer directions.
constexpr std::size_t mostCoarseNodes = 60'000;
constexpr std::size_t mostFineNodes = 450'000;
constexpr std::size_t mostFineOfSmallLamp = 1'200'000;
constexpr double smallLampDeg = 10.0; // behind what samples look at its edges are softer than nodes lie apart

constexpr std::size_t directBytes = 1, ambientBytes = 4;

// Directions of a sequence, any number of which are spread evenly, or of a lattice, which all together are
// spread more evenly than as many of the sequence.
enum class Spread { sequence, lattice };

// How many directions are tried, how far apart a path is looked at, lengths, and how directions are spread
// over a lamp.
struct Thoroughness {
  int directions;
  float step;
  Spread overLight = Spread::sequence;
};
constexpr Thoroughness ofSpread{96, 0.5f};
constexpr Thoroughness ofMotion{16, 0.75f};
constexpr Thoroughness ofSamples{1024, 0.25f};
constexpr Thoroughness ofFineNodes{64, 1.0f};
constexpr Thoroughness ofSmallLamp{24, 1.0f, Spread::lattice};
constexpr Thoroughness ofCoarseNodes{12, 1.5f};

constexpr std::size_t mostKept = 4;

using Directions = std::shared_ptr<const std::vector<glm::vec3>>;

template <class Of>
Directions directionsOf(int count, const Of& of) {
  std::vector<glm::vec3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n)
    directions.push_back(glm::vec3(of(n)));
  return std::make_shared<const std::vector<glm::vec3>>(std::move(directions));
}

Directions overLight(const PictureTerms& terms, const Thoroughness& with) {
  const double angle = terms.light.shadow.softnessDeg;
  const glm::dmat3 axes = axesAround(terms.towardsLight);
  const int count = angle > 0.0 ? with.directions : 1;
  return directionsOf(count, [&](int n) {
    const glm::dvec2 point = with.overLight == Spread::lattice ? latticePoint(n, count) : spreadPoint(n);
    return axes * directionInCone(point, angle);
  });
}

bool isSmallLamp(const PictureTerms& terms) {
  return terms.light.shadow.softnessDeg <= smallLampDeg;
}

std::size_t bytesOfVoxels(const Volume& volume) {
  return visitVoxels(volume,
                     [&]<class T>(const StoredVoxels<T>&) { return volume.voxelCount() * sizeof(T); });
}

// δ, lengths.
float lightOffset(const Scene& scene, const PictureTerms& terms) {
  return static_cast<float>(lightOffsetMm(scene.volume->grid()) / terms.lengthMm);
}

// Of paths that are followed from a ray's samples. Half the error, which each fineness asks for, takes about
// twice as many, looked at √2 times as often.
Thoroughness ofPaths(const Quality& quality) {
  if (quality.light == LightDetail::moving)
    return ofMotion;
  if (const std::optional<double> fineness = finenessOf(quality)) {
    const double finer = std::exp2(std::min(*fineness, mostLitFineness) - usualFineness(1.0));
    return {static_cast<int>(std::lround(ofSamples.directions * finer)),
            std::min(ofSamples.step / static_cast<float>(std::sqrt(finer)), 2.0f * ofSamples.step)};
  }
  return quality.light == LightDetail::sampled ? ofSamples : ofSpread;
}

TravelTerms travelOf(const Scene& scene, const PictureTerms& terms, const Thoroughness& with) {
  TravelTerms travel;
  travel.from = lightOffset(scene, terms);
  travel.reach = static_cast<float>(std::min(terms.light.occlusion.reachMm / terms.lengthMm, 1e6));
  travel.step = with.step;
  // A surface is there or not: whoever steps over it sees no part of it.
  travel.farStep = terms.effects.has(Effect::isosurface)
                       ? with.step
                       : std::max(with.step, std::min(2.0f * with.step, 1.0f));
  if (terms.effects.has(Effect::shadow))
    travel.towardsLight = overLight(terms, with);
  if (terms.effects.has(Effect::occlusion)) {
    travel.byCosine = directionsOf(with.directions, [](int n) { return directionByCosine(spreadPoint(n)); });
    travel.onSphere = directionsOf(with.directions, [](int n) { return directionOnSphere(spreadPoint(n)); });
  }
  return travel;
}

TravelTerms::ToNodes toNodes(const LightNodes& nodes, const PictureTerms& terms) {
  if (nodes.count.x == 0)
    return {};
  return {glm::vec3(1.0 / nodes.stride), glm::vec3(-(terms.centre + nodes.first) / nodes.stride)};
}

// From one node to the next, lengths; of the axes the shortest way.
float distanceOf(const LightNodes& nodes, const PictureTerms& terms) {
  const glm::dvec3 distance = nodes.stride * terms.spacing;
  return static_cast<float>(std::min({distance.x, distance.y, distance.z}));
}

// The terms of a search for what comes to nodes from `from` lengths on.
PictureTerms termsOfNodes(const Scene& scene, const PictureTerms& terms, const Thoroughness& with,
                          const LightNodes& nodes, bool isCoarse, float from) {
  PictureTerms looking = terms;
  looking.travel = travelOf(scene, terms, with);
  looking.travel.from = from;
  if (isCoarse) // what lies between nodes is not told anyway
    looking.travel.step = looking.travel.farStep =
        std::max(looking.travel.step, 0.5f * distanceOf(nodes, terms));
  return looking;
}

// What moves asks fine nodes as far behind a place, away from the light, as they leave out of what is near:
// so nodes go on behind all that shows.
LightNodes withAskedBehind(LightNodes nodes, const PictureTerms& terms) {
  if (nodes.count.x == 0)
    return nodes;
  const glm::dvec3 behind =
      (LightLook::farthest - LightLook::awayMoving) * terms.towardsLight / terms.spacing / nodes.stride;
  const glm::dvec3 below = glm::ceil(glm::max(behind, glm::dvec3(0.0)));
  const glm::dvec3 above = glm::ceil(glm::max(-behind, glm::dvec3(0.0)));
  nodes.first -= below * nodes.stride;
  nodes.count += glm::ivec3(below + above);
  return nodes;
}

// The nodes that `nodesOf` so many bytes makes with those behind them, which take `mostBytes` at most
// together; none behind where there is room for nothing.
template <class NodesOf>
LightNodes fineDirectNodes(const PictureTerms& terms, std::size_t mostBytes, const NodesOf& nodesOf) {
  constexpr std::size_t fewest = 64;
  for (std::size_t bytes = mostBytes; bytes >= fewest; bytes -= bytes / 32)
    if (const LightNodes nodes = withAskedBehind(nodesOf(bytes), terms);
        directBytes * nodes.size() <= mostBytes)
      return nodes;
  return nodesOf(mostBytes);
}

// The numbers of the nodes in a plane z = `plane` that places which show can be next to.
std::vector<std::int32_t> nodesToFind(const PictureTerms& terms, const LightNodes& nodes, int plane) {
  std::vector<std::int32_t> numbers;
  const BlocksAlike& empty = terms.empty;
  // Places ask for nodes around where light that comes to them has been.
  const double stride = std::max({nodes.stride.x, nodes.stride.y, nodes.stride.z});
  const double reach = stride + std::max(LightLook::farthest, 0.5 * stride);
  const double farthest = reach / blockSize + 1.0;
  const glm::dvec3 first = terms.centre + nodes.first;
  const glm::ivec3 last = empty.first + empty.blocks - 1;
  for (int y = 0; y < nodes.count.y; ++y)
    for (int x = 0; x < nodes.count.x; ++x) {
      if (empty.distances) {
        const glm::dvec3 index = first + glm::dvec3(x, y, plane) * nodes.stride;
        const glm::ivec3 block =
            glm::clamp(glm::ivec3(glm::floor(index / double(blockSize))), empty.first, last) - empty.first;
        if (empty.distances[voxelOffset(empty.blocks, block.x, block.y, block.z)] > farthest)
          continue;
      }
      numbers.push_back((plane * nodes.count.y + y) * nodes.count.x + x);
    }
  return numbers;
}

template <class Light, class FindSome>
std::shared_ptr<const Light> found(const PictureTerms& terms, const LightNodes& nodes, const Effort& effort,
                                   const FindSome& findSome) {
  constexpr std::size_t atOnce = 256;
  std::vector<std::int32_t> numbers;
  for (int plane = 0; plane < nodes.count.z; ++plane) {
    const std::vector<std::int32_t> some = nodesToFind(terms, nodes, plane);
    numbers.insert(numbers.end(), some.begin(), some.end());
  }
  auto light = std::make_shared<Light>(nodes.size());
  const std::size_t pieces = (numbers.size() + atOnce - 1) / atOnce;
  forEach(
      static_cast<int>(pieces), effort.threads,
      [&](int piece) {
        const std::size_t begin = static_cast<std::size_t>(piece) * atOnce;
        findSome(std::span(numbers).subspan(begin, std::min(atOnce, numbers.size() - begin)), light->data());
      },
      effort.isCancelled);
  complete(nodes, *light);
  return light;
}

} // namespace

TransferFunction withoutColors(TransferFunction function) {
  for (ControlPoint& point : function.points)
    point.color = glm::dvec3(1.0);
  return function;
}

Region withoutColors(Region keep) {
  for (TransferFunction& look : keep.looks)
    look = withoutColors(look);
  for (Cut& cut : keep.cuts)
    cut.name.clear();
  return keep;
}

bool looksUpLight(const Scene& scene) {
  const Quality& quality = scene.quality;
  const bool isOnDisk = scene.volume && scene.volume->room();
  switch (quality.light) {
  case LightDetail::coarse:
    return true;
  case LightDetail::moving:
    return isOnDisk;
  case LightDetail::fine:
    return !quality.toleranceLevels;
  case LightDetail::spread:
    return !quality.toleranceLevels && isOnDisk;
  case LightDetail::sampled:
    break;
  }
  return false;
}

TravelTerms travelIn(const LightVolumes& light, const Scene& scene, const PictureTerms& terms) {
  if (!light.areKnown()) {
    const Thoroughness with = ofPaths(scene.quality);
    TravelTerms travel = travelOf(scene, terms, with);
    travel.spread = with.directions;
    return travel;
  }
  TravelTerms travel = travelOf(scene, terms, light.isFine ? ofFineNodes : ofCoarseNodes);
  travel.found = light;
  travel.look = lightLook(light, scene.volume->grid(), asksFineLight(scene.quality));
  travel.layers = layerLengths(travel.from);
  travel.toDirect = toNodes(light.directNodes, terms);
  travel.toAmbient = toNodes(light.ambientNodes, terms);
  return travel;
}

template <class Light, class Find>
std::shared_ptr<const Light> LightStore::of(Kept<Light>& kept, const Key& key, const Find& find) {
  const auto there = std::ranges::find(kept, key, &Found<Light>::key);
  const Found<Light> wanted = there != kept.end() ? *there : Found<Light>{key, find()};
  if (there != kept.end())
    kept.erase(there);
  kept.push_front(wanted);
  if (kept.size() > mostKept)
    kept.pop_back();
  return wanted.light;
}

LightStore::Keys LightStore::keysOf(const Scene& scene, const PictureTerms& terms, const IndexBox& shows,
                                    bool isCoarse) {
  // Fine nodes of both lights share the bytes, coarse ones are as many.
  const std::size_t mostBytes = bytesOfVoxels(*scene.volume) / shareOfVoxels;
  const bool areBoth = terms.effects.has(Effect::shadow) && terms.effects.has(Effect::occlusion);
  const std::size_t ofDirect = !areBoth   ? mostBytes
                               : isCoarse ? mostBytes * directBytes / (directBytes + ambientBytes)
                                          : mostBytes / 2;
  const std::size_t most = isCoarse ? mostCoarseNodes : mostFineNodes;
  const auto nodesOf = [&](std::size_t bytesEach, std::size_t mostNodes, std::size_t bytes) {
    return lightNodes(scene.volume->grid(), shows.lower, shows.upper, bytesEach,
                      std::min(bytes, bytesEach * mostNodes));
  };
  const LightNodes direct =
      isCoarse ? nodesOf(directBytes, most, ofDirect)
               : fineDirectNodes(terms, areBoth ? mostBytes * 5 / 8 : mostBytes, [&](std::size_t bytes) {
                   return nodesOf(directBytes, isSmallLamp(terms) ? mostFineOfSmallLamp : most,
                                  std::min(bytes, ofDirect));
                 });
  // Of fine nodes the rest of what direct light may have at most: where the light stands moves none of these.
  const std::size_t ofAmbient = !areBoth   ? mostBytes
                                : isCoarse ? mostBytes - ofDirect
                                           : mostBytes - mostBytes * 5 / 8;
  Keys keys;
  keys.direct = {scene.volume,
                 withoutColors(scene.transferFunction),
                 scene.gradientOpacity,
                 terms.light.opacity,
                 terms.effects.has(Effect::opacityMap) ? terms.light.curve : GradientCurve(),
                 terms.effects.has(Effect::opacityMap) ? terms.perReference : 0.0f,
                 terms.effects.has(Effect::smoothNormals) ? scene.shading.gradientSmoothing : 0.0,
                 withoutColors(scene.keep),
                 scene.crop,
                 scene.projection,
                 scene.isovalue,
                 isCoarse,
                 direct};
  keys.ambient = keys.direct;
  keys.ambient.nodes = nodesOf(ambientBytes, most, ofAmbient);
  keys.ambient.size = terms.light.occlusion.reachMm;
  keys.direct.towardsLight = terms.towardsLight;
  keys.direct.size = terms.light.shadow.softnessDeg;
  return keys;
}

bool LightStore::hasAll(const Keys& keys, EffectSet effects) const {
  return (!effects.has(Effect::shadow) ||
          std::ranges::find(m_direct, keys.direct, &Found<DirectLight>::key) != m_direct.end()) &&
         (!effects.has(Effect::occlusion) ||
          std::ranges::find(m_ambient, keys.ambient, &Found<AmbientLight>::key) != m_ambient.end());
}

TravelTerms LightStore::update(const Scene& scene, const PictureTerms& terms, const IndexBox& shows,
                               const Effort& effort) {
  const bool isMoving = scene.quality.light == LightDetail::moving;
  const bool mayFollow = !looksUpLight(scene);
  if (mayFollow && !isMoving)
    return travelIn({}, scene, terms);
  Keys keys = keysOf(scene, terms, shows, false);
  const bool isCoarse = !asksFineLight(scene.quality) && !hasAll(keys, terms.effects);
  if (isCoarse && mayFollow)
    return travelIn({}, scene, terms);
  if (isCoarse)
    keys = keysOf(scene, terms, shows, true);
  const Thoroughness& ofAmbient = isCoarse ? ofCoarseNodes : ofFineNodes;
  const Thoroughness& ofDirect = !isCoarse && isSmallLamp(terms) ? ofSmallLamp : ofAmbient;
  LightVolumes light;
  light.isFine = !isCoarse;
  if (terms.effects.has(Effect::shadow)) {
    light.directNodes = keys.direct.nodes;
    light.direct = of(m_direct, keys.direct, [&] {
      const PictureTerms looking = termsOfNodes(scene, terms, ofDirect, light.directNodes, isCoarse,
                                                static_cast<float>(light.directFrom()));
      return found<DirectLight>(looking, light.directNodes, effort,
                                [&](std::span<const std::int32_t> some, auto* out) {
                                  findDirect(looking, light.directNodes, some, out);
                                });
    });
  }
  if (terms.effects.has(Effect::occlusion)) {
    light.ambientNodes = keys.ambient.nodes;
    light.ambient = of(m_ambient, keys.ambient, [&] {
      const PictureTerms looking = termsOfNodes(scene, terms, ofAmbient, light.ambientNodes, isCoarse, 0.0f);
      return found<AmbientLight>(looking, light.ambientNodes, effort,
                                 [&](std::span<const std::int32_t> some, auto* out) {
                                   findAmbient(looking, light.ambientNodes, some, out);
                                 });
    });
  }
  return travelIn(light, scene, terms);
}

std::size_t LightStore::ownBytes() const {
  std::size_t bytes = 0;
  for (const auto& one : m_direct)
    bytes += one.light->size();
  for (const auto& one : m_ambient)
    bytes += 4 * one.light->size();
  return bytes;
}

} // namespace limn::cpu
