// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/volume/Volume.h"

#include <array>
#include <memory>
#include <vector>

namespace limn {

/// What a Gaussian of `sigmaMm` weighs voxels along an axis of `count` of them, `spacingMm` apart: the voxel
/// itself, then each of the two neighbours at a distance of 1, 2, … voxels. It is cut off at 3σ and all
/// weights together are 1. Farther neighbours than the axis has are its edge, as those at its ends are: what
/// they weigh is the last one's.
std::vector<double> smoothingWeights(double sigmaMm, double spacingMm, int count);

/// Whether smoothing reaches beyond a voxel along any axis. Where not, the smoothed field is the field.
bool smoothsAnything(double sigmaMm, const Grid& grid);

/// What takes the terraces of thick slices out of the light, mm: 0.7 of the distance between slices where
/// that is larger by a quarter at least than the next largest spacing of the grid, at most what may be asked
/// for; else, and of a single image, 0.
double smoothingOfSlices(const Grid& grid);

/// Smooths the scalars of a volume at its voxels by a Gaussian of σ mm along each axis, edges clamped, in
/// pieces of work. It takes one float for each voxel, in the volume's room, and keeps the volume.
class Smoothing {
public:
  /// All of the volume's voxels must be held.
  Smoothing(std::shared_ptr<const Volume> volume, double sigmaMm);

  const std::shared_ptr<const Volume>& volume() const { return m_volume; }
  double sigmaMm() const { return m_sigmaMm; }

  /// Goes on for some ten ms; how much is done, 1 once all is. Throws Cancelled, and then goes on from there.
  double more(const Effort& effort);

  /// Range, grid and validity are the volume's; scalars are floats, exact to 2⁻²² of the range. Null while
  /// any is missing.
  const std::shared_ptr<const Volume>& smoothed() const { return m_smoothed; }

private:
  void smoothAcross(int piece);
  void smoothAlongZ(int piece);

  std::shared_ptr<const Volume> m_volume;
  double m_sigmaMm;
  glm::ivec3 m_dims;
  std::array<std::vector<float>, 3> m_weights; // as smoothingWeights
  int m_rowsPerPiece, m_stripsPerSlice;        // of the slices, smoothed along x and y
  int m_columnsPerPiece, m_piecesPerRow;       // of the rows along x, smoothed along z
  int m_across, m_pieces;                      // how many of the former, and of both
  std::vector<char> m_isDone;                  // of each piece
  int m_done = 0;
  RoomVector<float> m_scalars; // normalised over the volume's range
  std::shared_ptr<const Volume> m_smoothed;
};

/// All of it at once. Throws Cancelled.
std::shared_ptr<const Volume> smoothedVolume(std::shared_ptr<const Volume> volume, double sigmaMm,
                                             const Effort& effort = {});

} // namespace limn
