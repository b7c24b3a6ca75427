// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace limn::test {

/// What random cameras showed on the CPU (hard case H47).
struct CameraFuzzReport {
  int cameras = 0;
  std::size_t rays = 0;
  std::size_t hits = 0; ///< rays that meet their box
  int mostSamples = 0;  ///< of one ray: at most 60000
  double seconds = 0.0;
  std::string firstFailure; ///< a sentence; empty where every ray is finite and bounded
};

/// Builds rays of `cameras` random cameras about random grids, clips them and counts their samples with
/// random steps: every number must be finite and every count within 1..60000, so that no loop can be endless.
CameraFuzzReport fuzzCameras(int cameras, std::uint64_t firstSeed);

} // namespace limn::test
