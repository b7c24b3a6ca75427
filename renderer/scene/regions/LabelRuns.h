// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>

namespace limn {

/// Where the run of equal places in a row of labels that begins at `first` ends, at most `length`. Reads
/// several at a time, as runs are long.
template <class Place>
int endOfRun(const Place* row, int first, int length) {
  constexpr int atOnce = sizeof(std::uint64_t) / sizeof(Place);
  std::uint64_t equal = 0;
  for (int n = 0; n < atOnce; ++n)
    equal |= static_cast<std::uint64_t>(row[first]) << n * 8 * static_cast<int>(sizeof(Place));
  int end = first + 1;
  for (std::uint64_t next = 0; end + atOnce <= length; end += atOnce) {
    std::memcpy(&next, row + end, sizeof(next));
    if (next != equal)
      break;
  }
  while (end < length && row[end] == row[first])
    ++end;
  return end;
}

} // namespace limn
