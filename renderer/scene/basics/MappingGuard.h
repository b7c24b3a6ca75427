// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>

namespace limn {

/// Watches mapped memory whose file may lose pages (it shrinks, its disk fails): from then on zeros are read
/// there and `isDamaged` is true, where the system otherwise ends the process with SIGBUS. Elsewhere that
/// signal does what it did before.
class MappingGuard {
public:
  /// `isDamaged` must live until `forget`. Safe on several threads. Throws Error (other) where too many
  /// mappings are watched.
  static void watch(void* begin, std::size_t bytes, std::atomic<bool>& isDamaged);
  /// Before the memory is unmapped.
  static void forget(void* begin) noexcept;
};

} // namespace limn
