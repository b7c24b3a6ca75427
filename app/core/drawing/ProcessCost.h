// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/Timing.h"

#include <chrono>
#include <optional>
#include <string>

namespace limn {

/// Milliseconds of processor time that all threads of this process have used.
double processorMs();

/// What a piece of work takes on the clock and of the processor.
template <class Work>
FrameCost costOf(const Work& work) {
  const double processorBefore = processorMs();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  return {ms.count(), processorMs() - processorBefore};
}

/// Memory of this process that is resident now, MB; 0 where the system does not tell.
double residentMb();

/// The most that was resident since the program started or since the last call of `forgetPeak`, MB.
double peakResidentMb();

/// Gives free memory back to the system and starts a new peak.
void forgetPeak();

/// The processor's name and the number of processors, for the reader of a figure.
std::string machineName();

} // namespace limn
