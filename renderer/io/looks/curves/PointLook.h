// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"

namespace limn {

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

} // namespace limn
