// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <chrono>
#include <functional>
#include <utility>

namespace limn {

/// Two reports that say the same lie at least as far apart: each has the whole window painted, and work
/// reports thousands of times a second.
inline constexpr std::chrono::milliseconds betweenReports{50};

/// Passes on what is said first, what says something else, and the rest no more often than `betweenReports`.
/// For one thread.
class SparseReports {
public:
  using Report = std::function<void(double fraction, const Message& what)>;

  explicit SparseReports(Report report) : m_report(std::move(report)) {}

  void operator()(double fraction, const Message& what) {
    const auto now = std::chrono::steady_clock::now();
    if (what == m_what && now - m_last < betweenReports)
      return;
    m_what = what;
    m_last = now;
    m_report(fraction, what);
  }

private:
  Report m_report;
  Message m_what;
  std::chrono::steady_clock::time_point m_last{};
};

} // namespace limn
