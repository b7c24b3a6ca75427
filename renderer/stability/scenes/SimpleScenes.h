// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <functional>
#include <memory>
#include <vector>

/// Scenes so simple that their pictures have closed forms.
namespace limn {

/// Linear colours.
inline const glm::dvec3 white(1.0), black(0.0);

/// A grid whose box is centred on the world's origin.
Grid centredGrid(const glm::ivec3& dims, const glm::dvec3& spacingMm);

/// A volume of doubles from a function of the voxel's index.
std::shared_ptr<const Volume> volumeOf(const Grid& grid,
                                       const std::function<double(int i, int j, int k)>& value);

/// A volume from values along y, one voxel wide, centred on the origin.
std::shared_ptr<const Volume> columnOf(const std::vector<double>& values, double spacingMm);

/// A homogeneous box of one voxel centred on the origin.
std::shared_ptr<const Volume> boxOf(const glm::dvec3& sizeMm, double value = 1.0);

/// An unlit scene seen orthographically along `direction` through the box's centre, as high as the smallest
/// spacing, without early termination: meant for pictures of one pixel.
Scene rayThrough(std::shared_ptr<const Volume> volume, const glm::dvec3& direction = {0.0, 1.0, 0.0});

/// A slice of one voxel along y in `rows` rows along z, seen along y by a pixel per voxel, the first row at
/// the bottom: meant for pictures of its size. In steps of its thickness each pixel takes one sample at a
/// voxel's centre.
Scene pixelPerVoxel(std::shared_ptr<const Volume> volume);

/// The isosurface -1/2 of f = -r, a ball of radius 1/2 mm around the origin, along the ray at distance b in x
/// that runs along y from y = -1: columns of 4 x n x 4 voxels between y = -0.6 and 0.1, whose lattice is
/// shifted by a part (0..1) of a voxel.
Scene ballSurface(double b, double voxelMm, const glm::dvec3& shift = glm::dvec3(0.0));

/// Fog that turns black into the share of the way from `startMm` to `endMm`, both from the eye.
Fog distanceFog(double startMm, double endMm);

/// The step in voxels that gives `samples` samples over `lengthMm`.
double stepFor(const Scene& scene, double lengthMm, double samples);

/// A function of one point: the same colour and opacity everywhere.
TransferFunction constantFunction(double opacity, const glm::dvec3& color, double unitDistanceMm = 1.0);

/// The unit distance of the scenes whose extinction is linear between control points: over it an opacity
/// a = κ·u is an extinction κ up to a relative κ·u/2.
inline constexpr double smallUnitMm = 1e-9;

/// A control point of an extinction per mm, for functions over smallUnitMm.
ControlPoint extinctionPoint(double scalar, double extinction, const glm::dvec3& color);

/// Skin faint, muscle fuller, bone dense: the transfer function of comparisons, HU.
TransferFunction skinMuscleBone();

/// A volume seen by the default camera under skinMuscleBone, step 0.25, without early termination.
Scene headScene(std::shared_ptr<const Volume> volume, ShadingModel model);

/// Cubes of `edge` voxels whose labels take turns, one weight (0..1) for each label: neighbours differ.
Region cubesRegion(const glm::ivec3& dims, int edge, const std::vector<double>& weights);

/// The region with looks of their own for all labels but the first: `function` moved along the values, in
/// other colours and over other unit distances, no two alike.
Region withVariedLooks(const Region& region, const TransferFunction& function);

/// One change of a scene.
struct Variation {
  const char* what;
  void (*apply)(Scene&);
};

/// Every parameter of a scene changed in turn: each must show in a lit picture of the robust model.
const std::vector<Variation>& everyParameter();

} // namespace limn
