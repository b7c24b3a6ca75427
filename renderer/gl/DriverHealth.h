// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Error.h"

#include <string>

namespace limn {

/// What a bug report needs to know of the current context's driver.
struct DriverFacts {
  std::string renderer;
  std::string version;
  std::string shadingLanguage;
  int largest3dTexture = 0; ///< texels along an edge
  bool tellsOfResets = false;
};

/// Asks the current context.
DriverFacts driverFacts();

/// Throws Error (openGl) naming the version where the current context is older than OpenGL 3.0.
void requireOpenGl3();

/// The driver failed: the sentence is for people, the details are what the driver itself wrote (a compiler's
/// log), for a report; they may be empty.
class DriverError : public Error {
public:
  DriverError(const Message& sentence, std::string details)
      : Error(Kind::openGl, sentence), m_details(std::move(details)) {}

  const std::string& details() const { return m_details; }

private:
  std::string m_details;
};

/// Forgets the errors that the driver has noted so far. Returns also where a lost context reports one
/// forever.
void forgetDriverErrors();

/// Whether the driver was reset or its context lost since the context was made: nothing drawn with it counts,
/// and nothing made in it can be used again. False also where the driver cannot say.
bool contextIsLost();

/// Throws DriverError where the context was lost, or the driver ran out of memory or refused a command since
/// its errors were forgotten or asked for. `doing` completes "The graphics driver ran out of memory while …".
void requireHealthyDriver(const Message& doing);

} // namespace limn
