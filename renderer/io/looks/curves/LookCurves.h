// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"
#include "io/looks/text/LookChanges.h"

#include <string>
#include <vector>

namespace limn {

// Many formats keep opacity and colour in curves of their own. Here each is a list of control points of which
// only the opacity, or only the colour, counts.

/// The most points of a look; what has more is damage, or no curve that anyone drew.
inline constexpr std::size_t mostLookPoints = 100000;

/// What to do about a damaged look, as errors say it.
inline const Message saveLookAgain = Message::tr("save the look again in the program that made it");

/// Throws Error (input), naming `name`, where a curve has no points, or more than mostLookPoints.
void requirePointCount(std::size_t count, const std::string& name);

/// A point as read, limited to 0..1 with a sentence where that changes it. Throws Error (input), naming
/// `name`, where it is not finite.
ControlPoint checkedPoint(const ControlPoint& point, const std::string& name, std::vector<Message>& changes);

/// The points of a curve as read: sorted by value, those of one value in the order of the file, each
/// checked, their number too.
std::vector<ControlPoint> checkedCurve(std::vector<ControlPoint> points, const std::string& name,
                                       std::vector<Message>& changes);

/// The function with the opacity of one curve and the colour of the other, exactly: it has the points of
/// both. Each is constant beyond its own ends. Points at one value stay a step, of either. Both ascend in
/// value and have points.
TransferFunction merged(const std::vector<ControlPoint>& opacity, const std::vector<ControlPoint>& color);

/// The same with a sentence where the curves end at different values.
TransferFunction merged(const std::vector<ControlPoint>& opacity, const std::vector<ControlPoint>& color,
                        std::vector<Message>& changes);

} // namespace limn
