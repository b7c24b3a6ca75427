// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/Places.h"

// The only source that knows where it was built: every other object is the same in any checkout.
namespace limn::test {

std::filesystem::path sourceFolder() {
  return LIMN_SOURCE_DIR;
}

std::filesystem::path buildFolder() {
  return LIMN_BINARY_DIR;
}

std::string programPath() {
  return (buildFolder() / "limn").string();
}

} // namespace limn::test
