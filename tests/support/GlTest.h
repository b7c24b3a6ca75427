// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/HeadlessContext.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <optional>

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

private:
  std::optional<HeadlessContext> m_context;
};

} // namespace limn::test
