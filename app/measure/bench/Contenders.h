// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/measure/bench/Contender.h"

#include <string>
#include <vector>

namespace limn {

/// Which renderers take part.
struct BenchEntries {
  std::vector<std::string> engines{"gl"}; ///< gl, cpu, slices, reference
  int threads = 0;                        ///< of the CPU engine and the reference, 0: every core
  bool allEffects = false;                ///< beside gl, the program with all effects compiled in
  bool rivals = false;                    ///< VTK's mappers, in processes of their own
  std::vector<std::string> readOptions;   ///< how they are to read the volume, as on the command line
};

/// The renderers for one scene, whose volume is at `volumePath`. Throws Error, also where renderers draw on
/// different drivers: their times must not be compared.
std::vector<std::unique_ptr<Contender>> contendersFor(const BenchEntries& entries,
                                                      const std::string& volumePath);

} // namespace limn
