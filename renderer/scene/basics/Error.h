// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace limn {

/// The world failed: a file, a driver, an argument. The text is one sentence a clinician can act on:
/// what failed, on what, and what to try. The kind selects the exit status of the command line.
class Error : public std::runtime_error {
public:
  enum class Kind { usage, input, openGl, other };

  Error(Kind kind, const std::string& sentence) : std::runtime_error(sentence), m_kind(kind) {}

  Kind kind() const { return m_kind; }

private:
  Kind m_kind;
};

/// Thrown by long work when its caller asked it to stop; never shown as a failure.
class Cancelled : public std::runtime_error {
public:
  Cancelled() : std::runtime_error("cancelled") {}
};

} // namespace limn
