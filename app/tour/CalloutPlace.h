// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QRect>
#include <QSize>

namespace limn {

/// On which side of what it speaks of a call-out stands.
enum class CalloutSide { right, left, above, below, within };

/// Where a call-out stands, in the window's coordinates.
struct CalloutPlace {
  QRect box;
  CalloutSide side = CalloutSide::within;
  QPoint tip; ///< the point of its arrow, on the edge of what it speaks of; within: in the middle of the box
};

/// Beside `target` where there is room within `window`, at the side with the most, which for what is lower
/// than the box is above or below; otherwise over it, in its middle. `size` is that of the box, to which
/// `gap` pixels are added for the arrow. The box lies within the window wherever it is not larger.
CalloutPlace calloutPlace(const QRect& target, const QSize& size, const QRect& window, int gap);

} // namespace limn
