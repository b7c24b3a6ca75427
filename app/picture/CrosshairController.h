// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/Gradient.h"
#include "widgets/properties/CropFaces.h"

#include <QObject>

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

/// Whether half of what the ray to a place gives is gathered before it comes there, a voxel's diagonal aside:
/// what is seen lies in front of the place. False of projections in which nothing hides anything, and where
/// nothing is seen. `scale` as in profileAlong.
bool isHidden(const Scene& scene, const GradientScale& scale, const glm::dvec3& placeMm);

/// The crosshair of the slices in the picture: its mark, which is dashed where it is hidden, and the cut that
/// opens the volume to it. That cut is the crop box with one face at the crosshair, one undo step until it is
/// closed, and goes with the crosshair meanwhile. Any other edit of the crop makes it one like every other.
class CrosshairController : public QObject {
  Q_OBJECT

public:
  explicit CrosshairController(WindowContext& context);

  /// Puts the crop back as it was before; false where the volume is not cut open.
  bool close();

private:
  // The volume cut open.
  struct Opening {
    std::shared_ptr<const Volume> volume;
    CropBox before;
    CropFace face;
    CropBox crop; ///< that it has made
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
  std::optional<Opening> m_opening;
  Looked m_looked;
};

} // namespace limn
