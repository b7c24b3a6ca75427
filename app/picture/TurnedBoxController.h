// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/properties/CropFaces.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace limn {

struct WindowContext;

/// A box around the volume that lies as a camera looks, with its part that holds what the crop (or, where
/// nothing is cropped, the body) leaves: it takes nothing away yet.
TurnedBox boxTurnedTo(const Camera& camera, const Scene& scene);

/// The scissors that leave what lies in the box; none where it takes nothing away. A scene has no key for a
/// box that is turned, so it is kept as lines: a rectangle seen along its second axis, and where that cuts,
/// too, one seen along the third.
std::vector<Cut> cutsOf(const TurnedBox& box);

/// The crop box turned as the picture is seen: its faces are dragged as those of the crop box, and what they
/// take away are cuts at the end of the list, which go on until the list is edited otherwise.
class TurnedBoxController : public QObject {
  Q_OBJECT

public:
  /// The crop box's action must have been registered once the window is shown.
  explicit TurnedBoxController(WindowContext& context);

signals:
  /// The list of cuts shall be this.
  void cutsWanted(const std::vector<limn::Cut>& cuts, const limn::Gesture& gesture);

private:
  // The box while its faces can be dragged.
  struct Turned {
    std::shared_ptr<const Volume> volume;
    TurnedBox box;
    std::vector<Cut> before; ///< the list without its cuts
    std::vector<Cut> made;   ///< the list as the scene has it
    std::vector<Cut> asked;  ///< as it is wanted
  };

  void turn();
  void cropTo(const CropBox& crop, const Gesture& gesture);
  void end();
  void showScene(const Scene& scene);

  WindowContext& m_context;
  std::optional<Turned> m_turned;
  QMetaObject::Connection m_putAway; ///< the box, while there is one
};

} // namespace limn
