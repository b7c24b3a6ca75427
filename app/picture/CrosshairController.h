// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"
#include "scene/Scene.h"
#include "scene/light/Gradient.h"
#include "widgets/Gesture.h"
#include "widgets/properties/CropFaces.h"

#include <QObject>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class QAction;

namespace limn {

struct WindowContext;

/// The face of the crop box that faces the eye most where a place is looked at; `placeMm` is of the world.
CropFace faceTowards(const Camera& camera, const Grid& grid, const glm::dvec3& placeMm);

/// The box with that face at a place, so that nothing of the volume lies before it on that side; never larger
/// than it was, and at least a voxel thick. Of a place that is cut off already: the box itself.
CropBox openedAt(const CropBox& crop, const Grid& grid, CropFace face, const glm::dvec3& placeMm);

/// The corner of the volume that faces the eye most where a place is looked at: of each axis of the grid
/// whether its upper end lies on the eye's side.
std::array<bool, 3> cornerTowards(const Camera& camera, const Grid& grid, const glm::dvec3& placeMm);

/// The cut that takes away the corner of the volume up to a place: what lies on the eye's side of it along
/// each of the three axes, but for the voxels that the place lies in.
Scissors cornerAt(const Grid& grid, const std::array<bool, 3>& corner, const glm::dvec3& placeMm);

/// Whether half of what the ray to a place gives is gathered before it comes there, a voxel's diagonal aside:
/// what is seen lies in front of the place. False of projections in which nothing hides anything, and where
/// nothing is seen. `scale` as in profileAlong.
bool isHidden(const Scene& scene, const GradientScale& scale, const glm::dvec3& placeMm);

/// The crosshair of the slices in the picture: its mark, which is dashed where it is hidden, and the cuts
/// that open the volume to it. One is the crop box with one face at the crosshair; the other takes the corner
/// that faces the eye, as a cut by hand behind all others. Each is one undo step until it is closed, goes
/// with the crosshair meanwhile, and is still open in a session that is opened again. Any other edit of the
/// crop, or of the cuts, makes it one like every other.
class CrosshairController : public QObject {
  Q_OBJECT

public:
  explicit CrosshairController(WindowContext& context);

  /// Puts back what was before; false where the volume is not cut open.
  bool close();

  /// Whether the volume is cut open, in a session file. Restored once scene and slices are.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

signals:
  /// The list of cuts shall be this.
  void cutsWanted(const std::vector<limn::Cut>& cuts, const limn::Gesture& gesture);

private:
  // The volume cut open by a face of the crop.
  struct Opening {
    std::shared_ptr<const Volume> volume;
    CropBox before;
    CropFace face;
    CropBox crop; ///< that it has made
    std::uint64_t gesture = 0;
  };
  // The volume cut open at a corner.
  struct OpenCorner {
    std::shared_ptr<const Volume> volume;
    std::array<bool, 3> corner{};
    std::vector<Cut> made;  ///< the list as the scene has it: before, or with the corner of a moment ago
    std::vector<Cut> asked; ///< with the corner as it is wanted, the last
    std::uint64_t gesture = 0;
  };
  // What decides whether the mark is hidden.
  struct Looked {
    std::optional<glm::dvec3> placeMm;
    std::vector<Scene> sides;
    std::vector<GradientScale> scales;
    bool operator==(const Looked&) const = default;
  };

  void ask();
  void askForCorner();
  void openCorner(const std::array<bool, 3>& corner);
  void cutCorner();
  bool closeFace();
  bool closeCorner();
  void openFrom(CropFace face);
  void follow();
  void showScene(const Scene& scene);
  void showAction();
  void look();
  bool hasSlices() const;
  glm::dvec3 crosshair() const;
  CropBox openedNow(const CropBox& before, CropFace face) const;

  WindowContext& m_context;
  QAction* m_action;
  QAction* m_cornerAction;
  std::optional<Opening> m_opening;
  std::optional<OpenCorner> m_corner;
  Looked m_looked;
};

} // namespace limn
