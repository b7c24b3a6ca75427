// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/framing/Framing.h"
#include "widgets/view/gestures/ViewDrag.h"

#include <functional>
#include <optional>
#include <variant>

class QKeyEvent;

namespace limn {

/// Degrees by which an arrow key turns, and eighths of a degree of a notch of the wheel, as Qt counts.
inline constexpr double keyTurnDeg = 5.0;
inline constexpr int wheelNotch = 120;

/// What a key of the 3D view asks for.
namespace viewcommand {
struct LookFrom {
  StandardView view;
  bool operator==(const LookFrom&) const = default;
};
struct LookAlong { ///< from outside along a direction of the world, with another one upwards; unit length
  glm::dvec3 from;
  glm::dvec3 up;
  bool operator==(const LookAlong&) const = default;
};
struct LookFromNearest { ///< the standard view nearest to the present one
  bool operator==(const LookFromNearest&) const = default;
};
struct Reset { ///< the camera of a freshly opened volume
  bool operator==(const Reset&) const = default;
};
struct Rotate { ///< in steps, as if the pointer were dragged right and down
  int right = 0;
  int down = 0;
  bool operator==(const Rotate&) const = default;
};
struct Zoom { ///< in notches of the wheel
  int notches = 0;
  bool operator==(const Zoom&) const = default;
};
struct UseTool {
  ViewTool tool;
  bool operator==(const UseTool&) const = default;
};
struct WindowPreset { ///< 0 is the full dynamic range, 1..9 the presets
  int number = 0;
  bool operator==(const WindowPreset&) const = default;
};
struct Swap { ///< show the other side while held
  bool operator==(const Swap&) const = default;
};
struct CloseLine { ///< that is being drawn
  bool operator==(const CloseLine&) const = default;
};
struct ShortenLine { ///< by its last corner; what is being measured goes wholly
  bool operator==(const ShortenLine&) const = default;
};
struct Remove { ///< the measurement that is being drawn, or else the one in hand
  bool operator==(const Remove&) const = default;
};
struct Cancel {
  bool operator==(const Cancel&) const = default;
};
} // namespace viewcommand

using ViewCommand =
    std::variant<std::monostate, viewcommand::LookFrom, viewcommand::LookAlong, viewcommand::LookFromNearest,
                 viewcommand::Reset, viewcommand::Rotate, viewcommand::Zoom, viewcommand::UseTool,
                 viewcommand::WindowPreset, viewcommand::Swap, viewcommand::CloseLine,
                 viewcommand::ShortenLine, viewcommand::Remove, viewcommand::Cancel>;

/// The command of a key; monostate where the view does not use it. Slicer's keys choose the standard views
/// (End or keypad 1 anterior, with Shift posterior; PgDn or 3 left, right; Home or 7 superior, inferior;
/// Insert or 0 the nearest), and so do the letters A P L S I. R resets, as in VTK programs: the right side
/// is reached by Shift+PgDn.
ViewCommand commandOf(const QKeyEvent& event);

/// On what views are framed, asked only where one is wanted, and width over height of a picture.
struct ViewFrame {
  std::function<const VisibleVoxels&()> visible;
  double aspect = 1.0;
  std::optional<glm::dvec3> turnsAbout = {}; ///< world; absent: the target
};

/// The camera that a command asks for, of this volume; nothing where the command moves none.
std::optional<Camera> cameraAfter(const ViewCommand& command, const Camera& camera, const Volume& volume,
                                  const ViewFrame& frame);

/// Whether a command turns or zooms in small steps, of which many make one gesture; a standard view is one in
/// itself.
bool isRepeatable(const ViewCommand& command);

} // namespace limn
