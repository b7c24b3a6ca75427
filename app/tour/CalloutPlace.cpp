// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/CalloutPlace.h"

#include <algorithm>
#include <array>

namespace limn {
namespace {

// Moved by no more than it takes.
QRect inside(QRect box, const QRect& window) {
  box.moveLeft(std::max(window.left(), std::min(box.left(), window.right() - box.width() + 1)));
  box.moveTop(std::max(window.top(), std::min(box.top(), window.bottom() - box.height() + 1)));
  return box;
}

struct Beside {
  CalloutSide side;
  int over; ///< pixels left once the box stands there
};

} // namespace

CalloutPlace calloutPlace(const QRect& target, const QSize& size, const QRect& window, int gap) {
  const QRect seen = target.intersected(window);
  const std::array<Beside, 4> rooms{{
      {CalloutSide::right, window.right() - seen.right() - size.width() - gap},
      {CalloutSide::left, seen.left() - window.left() - size.width() - gap},
      {CalloutSide::above, seen.top() - window.top() - size.height() - gap},
      {CalloutSide::below, window.bottom() - seen.bottom() - size.height() - gap},
  }};
  // What is lower than the box stands in a row with others, which a box beside it would hide.
  const bool isLow = seen.height() < size.height() && std::max(rooms[2].over, rooms[3].over) >= 0;
  const Beside best = *std::max_element(rooms.begin() + (isLow ? 2 : 0), rooms.end(),
                                        [](const Beside& a, const Beside& b) { return a.over < b.over; });
  const CalloutSide side = best.over < 0 ? CalloutSide::within : best.side;
  QRect box({}, size);
  box.moveCenter(seen.center());
  if (side == CalloutSide::right)
    box.moveLeft(seen.right() + 1 + gap);
  else if (side == CalloutSide::left)
    box.moveRight(seen.left() - 1 - gap);
  else if (side == CalloutSide::above)
    box.moveBottom(seen.top() - 1 - gap);
  else if (side == CalloutSide::below)
    box.moveTop(seen.bottom() + 1 + gap);
  box = inside(box, window);
  QPoint tip = box.center();
  if (side == CalloutSide::right || side == CalloutSide::left)
    tip = {side == CalloutSide::right ? seen.right() : seen.left(),
           std::clamp(seen.center().y(), box.top(), box.bottom())};
  else if (side != CalloutSide::within)
    tip = {std::clamp(seen.center().x(), box.left(), box.right()),
           side == CalloutSide::above ? seen.top() : seen.bottom()};
  return {box, side, tip};
}

} // namespace limn
