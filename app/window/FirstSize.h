// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

namespace limn {

/// How large the window is at its first start, in points: four fifths of a large screen, 1440 × 900 where it
/// has room for that, and on a small one all of it but for a title bar. `available` is what the screen leaves
/// beside its own bars.
QSize firstWindowSize(const QSize& available);

} // namespace limn
