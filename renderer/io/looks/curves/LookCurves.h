// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"
#include "io/looks/text/LookText.h"
#include "scene/function/TransferFunction.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Some of the points, first and last among them, such that the function through them stays within
/// `tolerance` (> 0) of every point in colour and opacity; steps stay where they are. `points` ascend in
/// value. A greedy walk that takes each piece as long as it gets.
std::vector<ControlPoint> simplified(const std::vector<ControlPoint>& points, double tolerance);

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

/// A look that is one list of points with colour and opacity, as its file has it.
struct PointLook {
  std::vector<ControlPoint> points; ///< in any order
  bool isRelative = false;          ///< values are fractions of a volume's range
  std::vector<Message> changes;     ///< so far
};

/// The look of Limn: points checked and sorted (`checkedCurve`), relative values stretched over the target;
/// it is called as the file is. Throws Error (input), naming `file`.
std::vector<ReadLook> finished(PointLook look, const std::string& file,
                               const std::optional<LookTarget>& target);

/// What a format of points alone holds of a preset: at least one point, opacities over 1 mm. What else the
/// preset has is told in `changes` as left out.
TransferFunction pointsAlone(const Preset& preset, std::vector<Message>& changes);

/// Points (ascending) that are transparent outside low..high, and as before inside; low < high, either of
/// which may be infinite.
std::vector<ControlPoint> maskedTo(const std::vector<ControlPoint>& points, double low, double high);

/// The most curves of a look that may be joined.
inline constexpr std::size_t mostJoinedCurves = 64;

/// Several curves as one function: opacity is 0 outside each, and where some overlap, the most opaque one
/// shows, exactly. `overlap`, if given, receives whether any do. Each curve ascends in value and has points;
/// there are at most mostJoinedCurves.
TransferFunction joined(const std::vector<std::vector<ControlPoint>>& curves, bool* overlap = nullptr);

/// Gradient opacity as VTK's programs have it, in value per mean voxel spacing, in Limn's value/mm. Without a
/// target, voxels of 1 mm are taken, and said. Absent where the curve is 1 throughout. `curve` ascends in
/// value, which is the gradient; only its opacity counts.
std::optional<GradientOpacity> gradientOpacityFromVtk(const std::vector<ControlPoint>& curve,
                                                      const std::optional<LookTarget>& target,
                                                      std::vector<Message>& changes);

/// The other way round: points of gradient and opacity; (0, 1) and (255, 1), as such programs write it, where
/// there is no gradient opacity.
std::vector<GradientOpacityPoint> gradientOpacityForVtk(const std::optional<GradientOpacity>& opacity,
                                                        const std::optional<LookTarget>& target,
                                                        std::vector<Message>& changes);

/// A function whose values are relative, 0 to 1, stretched over the range of the target, which is said.
/// Without one it stays as it is, which is said too.
TransferFunction stretchedOver(const TransferFunction& function, const std::optional<LookTarget>& target,
                               std::vector<Message>& changes);

/// The function with opacities over 1 mm, for formats that hold no length, within 0.01 between points; said
/// where that changes them.
TransferFunction overOneMillimetre(const TransferFunction& function, std::vector<Message>& changes);

/// A sentence for a shading model that only Limn's own files hold: enhanced, robust, physical.
void tellLostModel(const std::optional<Shading>& shading, std::vector<Message>& changes);

/// Sentences for what only Limn's own files hold of a preset beside curves and light: projection, landmarks.
void tellLostParts(const Preset& preset, std::vector<Message>& changes);

} // namespace limn
