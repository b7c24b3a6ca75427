// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace limn {

/// Nodes over the part of a volume that shows, equally far apart in mm along all axes as far as whole numbers
/// of them allow: on the faces of that part, and where they are asked from farther off beyond them.
struct LightNodes {
  glm::ivec3 count{0};    ///< 2 or more along each axis; 0 where there are none
  glm::dvec3 first{0.0};  ///< where the first is, centred index
  glm::dvec3 stride{0.0}; ///< voxels from one to the next

  std::size_t size() const { return static_cast<std::size_t>(count.x) * count.y * count.z; }
  bool operator==(const LightNodes&) const = default;
};

/// The finest nodes of a box between two corners (centred index) that take `mostBytes` at most with
/// `bytesEach`, and are no closer than the volume's smallest spacing; none where it is empty.
LightNodes lightNodes(const Grid& grid, const glm::dvec3& lower, const glm::dvec3& upper,
                      std::size_t bytesEach, std::size_t mostBytes);

/// What comes of a light to the nodes, x fastest, past all that is in its way, from
/// `LightVolumes::directFrom` on: 1 + 254 M, rounded. 0 until it is known: nodes where nothing that shows is
/// near, or from which on light counts and which nobody could see, are told by their neighbours (`complete`).
using DirectLight = std::vector<std::uint8_t>;

/// What comes of ambient light to the nodes from all around: the mean of exp(-τ) over the sphere, from the
/// node itself on, then for each axis of the grid twice the mean of exp(-τ) times the direction's share of
/// that axis, -½..½, as 127 + 254 of it, rounded. M around a normal is the first plus the product of the
/// others with it: exact where what is open is a half space, or everything.
using AmbientLight = std::vector<std::array<std::uint8_t, 4>>;

/// What was found of the light that comes to a scene.
struct LightVolumes {
  LightNodes directNodes, ambientNodes;        ///< of either light; none: all of it is taken to come
  std::shared_ptr<const DirectLight> direct;   ///< null where no light casts shadows
  std::shared_ptr<const AmbientLight> ambient; ///< null where nothing dims ambient light
  bool isFine = false;                         ///< nodes were found for a picture at rest

  bool areKnown() const { return directNodes.count.x > 0 || ambientNodes.count.x > 0; }

  /// From where on what stands in the way of the direct light counts for a node, smallest spacings. Fine
  /// nodes leave what is near to samples, which look at it: so they change no faster than shadows from afar
  /// do, also where tissue begins, and a lamp's cone is as wide there as the sample's.
  double directFrom() const;

  bool operator==(const LightVolumes&) const = default;
};

/// How a sample asks nodes, which stand for what is some way off. Lengths are smallest spacings.
struct LightLook {
  /// The farthest that samples look towards the light.
  static constexpr double farthest = 6.5;

  /// While something moves fine nodes tell what stands farther than this towards the light, or than half the
  /// way between them: they tell of tissue, too, at whose edge light changes. Farther they would leave out
  /// more of what is near, nearer they would tell of the sample's own tissue.
  static constexpr double awayMoving = 1.5;

  /// So far above a sample it is looked at what dims ambient light, which is taken to lie in layers across
  /// the normal: a node tells nothing of what changes within a voxel.
  static constexpr double layersReach = 2.0;

  double directAway = 0.0;  ///< what stands farther towards the light is told by nodes
  double directAsked = 0.0; ///< so far towards the light, or away from it, nodes are asked
  double ambientAway = 0.0; ///< and so far along the normal
  bool looksNear = false;   ///< what stands nearer is looked at from the sample

  bool operator==(const LightLook&) const = default;
};

/// Of a picture of fine light, or of one whose light must be found quickly. Nodes hidden in tissue lie beside
/// open ones: asked nearer than they lie from each other they show as a pattern on every surface, asked
/// farther they tell of hollows less. Of the lengths that show none these are the nearest to light found for
/// each sample (`limn_cpu_tests --gtest_filter=CpuTravellingLight.lookedUp*`).
LightLook lightLook(const LightVolumes& light, const Grid& grid, bool isFine);

/// Of light from a half space past layers, of four of the same height up to `LightLook::layersReach` along
/// the normal: how long paths are in each that leave at one of six angles, smallest spacings; each angle
/// stands for as much of the light as another. `from`: from where on a path counts.
using LayerLengths = std::array<std::array<float, 4>, 6>;
LayerLengths layerLengths(double from);

/// Makes every node known: one that is not takes the mean of those that are among its 26 neighbours, so that
/// every cell with a known node has eight; where there is none, all light comes.
void complete(const LightNodes& nodes, DirectLight& light);
void complete(const LightNodes& nodes, AmbientLight& light);

/// The share that a code of a node stands for; `code` > 0.
inline double shareOfCode(std::uint8_t code) {
  return (code - 1) / 254.0;
}

/// The code of a share of 0..1.
inline std::uint8_t codeOfShare(double share) {
  return static_cast<std::uint8_t>(1.5 + 254.0 * share);
}

/// Likewise of a share of an axis.
inline double alongAxisOfCode(std::uint8_t code) {
  return (code - 127) / 254.0;
}
inline std::uint8_t codeOfAlongAxis(double share) {
  return static_cast<std::uint8_t>(127.5 + 254.0 * share);
}

} // namespace limn
