// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CpuCosts.h"

#include <chrono>

namespace limn {

double CpuCosts::measureMs(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace limn
