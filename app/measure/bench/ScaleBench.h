// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/ScaleRow.h"
#include "app/measure/bench/Bench.h"

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

/// Opens a volume of `edge` voxels along each axis, from a file that is gone afterwards, and draws it in
/// 512×512 pixels with steps of one voxel as `benchRows` does, a row for each renderer. `advance` is called
/// after the file was written, after it was opened and after every picture. Throws Error.
std::vector<ScaleRow> scaleRows(int edge, const BenchEntries& entries, int frames,
                                const std::function<void()>& advance);

/// Rows as a table for the terminal: behind each figure how many times that of the size before it is, of the
/// same renderer.
std::string scaleTable(const std::string& machine, const std::vector<ScaleRow>& rows);

} // namespace limn
