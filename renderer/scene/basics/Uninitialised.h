// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace limn {

/// Leaves elements that are made without a value as the memory is.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = UninitialisedAllocator<Other>;
  };

  template <class Other>
  void construct(Other*) noexcept {}
  template <class Other, class... Arguments>
  void construct(Other* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

/// For large arrays of plain values that are written in pieces of work: filling them beforehand would take
/// longer than anybody may wait who cancels.
template <class T>
using UninitialisedVector = std::vector<T, UninitialisedAllocator<T>>;

} // namespace limn
