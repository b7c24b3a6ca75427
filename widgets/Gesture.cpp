// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Gesture.h"

#include <atomic>

namespace limn {

std::uint64_t nextGestureId() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace limn
