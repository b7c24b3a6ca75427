// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <atomic>
#include <cstdint>

namespace limn {

/// Names the user's act behind an edit. Edits of one drag share an id and become one undo step; `text` is
/// what undo shows, in the imperative: "move point to 310 HU".
struct Gesture {
  std::uint64_t id = 0;
  QString text;
  bool isWhole = false; ///< the text tells what became of it, so that no numbers follow
  QString unit = {};    ///< of the number that follows; empty where it has none
};

/// An id no other gesture of this program run has.
inline std::uint64_t nextGestureId() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace limn
