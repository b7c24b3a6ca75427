// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/HeadlessContext.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace limn::test {

/// A test that draws: it has a context without a display, or skips with the driver's reason.
class GlTest : public ::testing::Test {
protected:
  void SetUp() override {
    try {
      m_context.emplace();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  // Whether another driver draws than GALLIUM_DRIVER asks for: Mesa is silent about one that it has not.
  static bool isAnotherRasteriser() {
    const char* const asked = std::getenv("GALLIUM_DRIVER");
    return asked != nullptr && rendererName().find(asked) == std::string::npos;
  }

private:
  std::optional<HeadlessContext> m_context;
};

} // namespace limn::test
