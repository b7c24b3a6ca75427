// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

/// What one turn of the event loop brought while the pictures rest.
enum class RestTurn {
  nothing, ///< there is nothing left to do
  waiting, ///< for another thread
  worked,
  finished ///< a picture that was shown is replaced by a better one
};

} // namespace limn
