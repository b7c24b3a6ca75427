// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn::test {

/// Whether this build runs under AddressSanitizer or ThreadSanitizer, which take time and memory of their
/// own: bounds of either are not judged then.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool isSanitised = true;
#else
inline constexpr bool isSanitised = false;
#endif

} // namespace limn::test

/// Ends a test, whose checks so far stand, before a bound of time that a sanitizer's own work would count in.
#define LIMN_NEEDS_ITS_OWN_TIME                                                                              \
  if (limn::test::isSanitised)                                                                               \
  GTEST_SKIP() << "checked all but its time, which a sanitizer's own work would be counted in"
