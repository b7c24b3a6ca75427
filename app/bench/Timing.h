// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/FrameCost.h"
#include "app/bench/ProcessCost.h"

#include <chrono>

namespace limn {

template <class Work>
FrameCost costOf(const Work& work) {
  const double processorBefore = processorMs();
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  return {ms.count(), processorMs() - processorBefore};
}

} // namespace limn
