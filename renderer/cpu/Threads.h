// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace limn::cpu {

/// Calls `work(i)` for each i of 0 … count-1, on `threads` of the processor (0: all), the caller's among
/// them. `isCancelled`, which may be empty, is asked between two pieces of work on the caller's thread; once
/// it is true no piece is begun, and Cancelled is thrown. So is what `work` throws.
void forEach(int count, int threads, const std::function<void(int)>& work,
             const std::function<bool()>& isCancelled = {});

} // namespace limn::cpu
