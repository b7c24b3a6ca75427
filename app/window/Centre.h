// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"
#include "widgets/view/SurfaceFormat.h"
#include "widgets/view/pictures/PictureState.h"

class QMainWindow;

namespace limn {

class CompareView;
class MessageBar;
class PlaneDeck;

/// What stands in the middle of the window: the picture below what there is to say.
struct Centre {
  /// The view draws with `engine` at first, never with OpenGL that the computer does not offer. The
  /// CPU engine keeps to `memory` (default: MemoryBudget's).
  Centre(QMainWindow& window, const OpenGlOffer& openGl, ViewEngine engine,
         const std::optional<MemoryBudget>& memory);

  MessageBar* recovery; ///< offers what an earlier window left behind
  MessageBar* unsafe;   ///< says so as long as the session cannot be kept
  MessageBar* patient;  ///< asks once whether a patient may be named
  MessageBar* tour;     ///< offers a tour of the window, once
  MessageBar* messages;
  CompareView* view;
  PlaneDeck* planes; ///< around the view
};

} // namespace limn
