// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/Places.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace limn::test {

/// The folder of real volumes shared beside the checkout (environment variable LIMN_SHARED, by
/// default ../shared); it may not exist.
inline std::filesystem::path sharedFolder() {
  if (const char* given = std::getenv("LIMN_SHARED"))
    return given;
  return sourceFolder() / ".." / "shared";
}

} // namespace limn::test

/// Ends a test with its reason where a file of the shared folder is missing.
#define LIMN_NEEDS_SHARED(relativePath)                                                                      \
  if (!std::filesystem::exists(limn::test::sharedFolder() / (relativePath)))                                 \
  GTEST_SKIP() << "needs the shared test data file "                                                         \
               << (limn::test::sharedFolder() / (relativePath)).string()                                     \
               << ", which this machine does not have"
