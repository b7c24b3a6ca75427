// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/CostModel.h"
#include "app/lab/bench/Bench.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace limn {

/// Writes the built-in phantom with `edge` voxels of 8 bits along each axis and a little noise, which lets no
/// two blocks be alike, as an NRRD file. Throws Error (other) where it cannot be written.
void writeScaleVolume(const std::filesystem::path& path, int edge);

/// The edges that are measured: 128, 256, … up to `largest`.
std::vector<int> scaleEdges(int largest);

/// What was measured of one size, or of several.
struct ScaleFigures {
  std::vector<ScaleRow> rows;   ///< one for each renderer
  std::vector<BrickRow> bricks; ///< of 1, 2, 4 and 8 ranks
};

/// How often `advance` of scaleFigures is called.
int scaleSteps(const BenchEntries& entries, int frames);

/// Opens a volume of `edge` voxels along each axis, from a file that is gone afterwards, and draws it in
/// 512×512 pixels with steps of one voxel as `benchRows` does; then in bricks. `advance` is called after the
/// file was written, after it was opened and after every picture. Throws Error.
ScaleFigures scaleFigures(int edge, const BenchEntries& entries, int frames,
                          const std::function<void()>& advance);

/// Rows as a table for the terminal: behind each figure how many times that of the size before it is, of the
/// same renderer.
std::string scaleTable(const std::string& machine, const std::vector<ScaleRow>& rows);

/// What each rank would do, likewise.
std::string brickTable(const std::vector<BrickRow>& rows);

} // namespace limn
