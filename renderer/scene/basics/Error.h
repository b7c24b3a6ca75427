// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <memory>
#include <stdexcept>
#include <string>

namespace limn {

/// The world failed: a file, a driver, an argument. It says one sentence a clinician can act on: what failed,
/// on what, and what to try; `what()` says it in English. The kind selects the exit status of the command
/// line.
class Error : public std::runtime_error {
public:
  enum class Kind { usage, input, openGl, other };

  Error(Kind kind, const Message& sentence)
      : std::runtime_error(sentence.english()), m_kind(kind),
        m_sentence(std::make_shared<const Message>(sentence)) {}

  Kind kind() const { return m_kind; }
  const Message& sentence() const { return *m_sentence; }

private:
  Kind m_kind;
  std::shared_ptr<const Message> m_sentence; // what is thrown must copy without failing
};

/// Thrown by long work when its caller asked it to stop; never shown as a failure.
class Cancelled : public std::runtime_error {
public:
  Cancelled() : std::runtime_error("cancelled") {}
};

} // namespace limn
