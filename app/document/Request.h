// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/SceneSource.h"

#include <QString>

namespace limn {

/// A source as it was asked for, to read it again with other options.
struct Request {
  QString source;
  SourceOptions options;
  bool isUnsavedSession = false; ///< one that Limn kept, not a file of the user's
};

} // namespace limn
