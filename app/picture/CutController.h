// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/PiecePick.h"
#include "scene/Scene.h"
#include "scene/regions/Cut.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace limn {

class CutBar;
struct PlaneLit;
struct WindowContext;
enum class PatientPlane;
enum class PlaneTool;

/// The tools that cut by hand: lines drawn on the picture, and connected pieces that are pointed at and light
/// up before they are hidden or kept alone. Slices beside the picture cut with the same tools. Asks for cuts;
/// RegionController makes them.
class CutController : public QObject {
  Q_OBJECT

public:
  explicit CutController(WindowContext& context);

  /// Whether a piece is lit in the picture.
  bool hasPiece() const { return m_shown.has_value(); }
  /// Whether depths or a piece are being found.
  bool isBusy() const { return m_work.isRunning(); }

  /// Lights up the connected piece that is seen along a ray of the picture of a side.
  void pick(const Ray& ray, int side);
  /// Lights up the connected piece that holds a place of the world, or is nearest to it within two voxels.
  void pickAt(const glm::dvec3& worldMm);

signals:
  /// One cut more is wanted; `gesture` is what undo calls it.
  void cutWanted(const limn::Cut& cut, const QString& gesture);
  /// This stands out in the slices from now on.
  void stoodOut(const limn::PlaneLit& lit);

private:
  // A piece as it is shown before it is cut.
  struct Shown {
    Region lit;
    SetFigures figures;
  };

  void showTool();
  void cutInSlice(PatientPlane plane, Scissors scissors);
  void cutAlong(const std::vector<glm::dvec2>& polygon, double aspect);
  void cut(const Scissors& scissors);
  void cutToSeen(Scissors scissors);
  void findPiece();
  void narrow(double notches, bool onlyAbove);
  void takeSimilar();
  void takeReach();
  void show(const Shown& shown);
  void showBar();
  void finish(ConnectedPiece::Fate fate);
  void putDown();
  void layDown();
  void takeInside(bool isInside);
  void showScene(const Scene& scene);
  void tellHowCornersEnd(bool areBegun) const;
  void say(const QString& sentence) const;

  WindowContext& m_context;
  CutBar* m_bar;
  std::shared_ptr<const Volume> m_volume; ///< the one that is open
  Region m_keep;                          ///< of the scene
  bool m_removesInside = true;
  bool m_onlySeen = false;
  std::optional<ConnectedPiece> m_piece; ///< that was pointed at
  glm::dvec3 m_pointedMm{0.0};           ///< where
  std::optional<Shown> m_shown;          ///< once it is found
  BackgroundWork m_work;
};

} // namespace limn
