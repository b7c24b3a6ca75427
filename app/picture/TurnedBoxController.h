// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/properties/CropFaces.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace limn {

struct WindowContext;

/// A box around the volume that lies as a camera looks, with its part that holds what is seen of the scene
/// and a voxel more: it takes nothing away yet. Of a volume on the disk, which is not read for it, the part
/// holds what the crop leaves or, where that leaves all, a body that is kept.
TurnedBox boxTurnedTo(const Camera& camera, const Scene& scene);

/// The scissors that leave what lies in the box; none where it takes nothing away. A scene has no key for a
/// box that is turned, so it is kept as lines: a rectangle seen along its second axis, and where that cuts,
/// too, one seen along the third.
std::vector<Cut> cutsOf(const TurnedBox& box);

/// A box found again, and how many of the last cuts are its lines.
struct FoundBox {
  TurnedBox box;
  std::size_t cuts = 0;
};

/// The box whose lines, as cutsOf makes them and all of them on, are the last of the cuts of this volume;
/// none where they are something else. Such lines stand nowhere else: a line drawn by hand is seen neither
/// from where these are nor through a picture of that height.
std::optional<FoundBox> boxAtTheEnd(const std::vector<Cut>& cuts, const Grid& volume);

/// The crop box turned as the picture is seen: its faces are dragged as those of the crop box, and what they
/// take away are cuts at the end of the list. As long as these are the last, the box that is shown is the
/// turned one, also after undo and redo and of a session that is opened again.
class TurnedBoxController : public QObject {
  Q_OBJECT

public:
  /// The crop box's action must have been registered once the window is shown.
  explicit TurnedBoxController(WindowContext& context);

  /// The crop box is put over the picture, or put away.
  void showBox(bool isShown);

  /// Says, once the box was put away by hand, that what its faces cut stays so, and offers to close that.
  void tellWhatStaysCut(bool isShown);

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
  void takeUp(const Scene& scene);
  CropBox fitOf(const Grid& box, const Scene& scene);
  void remember(const TurnedBox& box, const std::shared_ptr<const Volume>& volume);
  void cropTo(const CropBox& crop, const Gesture& gesture);
  void end();
  void showScene(const Scene& scene);
  void closeAll();

  WindowContext& m_context;
  std::vector<TurnedBox> m_fitted; ///< whose fit is known, of one volume
  std::weak_ptr<const Volume> m_fittedTo;
  std::optional<Turned> m_turned;
  std::vector<Cut> m_seen; ///< the list of the scene that was shown last
};

} // namespace limn
