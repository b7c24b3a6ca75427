// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/picture/CameraController.h"
#include "app/picture/ComparisonController.h"
#include "app/picture/CrosshairController.h"
#include "app/picture/CutController.h"
#include "app/picture/EngineController.h"
#include "app/picture/MeasureController.h"
#include "app/picture/OrientationController.h"
#include "app/picture/PictureMenu.h"
#include "app/picture/PlaneController.h"
#include "app/picture/RegionController.h"
#include "app/picture/TurnedBoxController.h"
#include "app/picture/ViewsController.h"
#include "widgets/view/gestures/ViewDrag.h"

#include <optional>

class QLabel;
class QStatusBar;

namespace limn {

class PictureStatus;
struct PictureState;
struct Probe;

/// What the status bar says of volume, pointer and picture.
class StatusTexts {
public:
  explicit StatusTexts(QStatusBar& bar);

  /// Also whether its voxels stay on the disk. Null: none.
  void showVolume(const Volume* volume);
  void showProbe(const std::optional<Probe>& probe, const Scene& scene);
  void showPicture(const PictureState& state, const Scene& scene);

private:
  QLabel* m_volume;
  QLabel* m_probe;
  PictureStatus* m_picture;
};

/// The middle of the window and what is done in it: tools and camera, comparison, slices, what is kept of the
/// volume and how it lies, the engine, and the status bar's words on all of that.
class PictureArea : public QObject {
  Q_OBJECT

public:
  explicit PictureArea(WindowContext& context);

  ComparisonController& comparison() { return m_comparison; }
  RegionController& regions() { return m_regions; }
  const RegionController& regions() const { return m_regions; }
  PlaneController& planes() { return m_planes; }
  MeasureController& measures() { return m_measures; }
  CrosshairController& crosshair() { return m_crosshair; }
  TurnedBoxController& turnedBox() { return m_turnedBox; }

  /// What another volume, or none, is called in the status bar.
  void showVolume(const Volume* volume) { m_status.showVolume(volume); }

  /// Whether parts of the volume are being found or cut, or something is begun that would be lost: a
  /// measurement that lacks places, a line to cut along, a piece that is lit and not cut yet.
  bool isBusy() const { return m_regions.isBusy() || m_cuts.isBusy() || isDrawing(); }

  /// What a session file says of it.
  void describe(SessionDocument& session) const;
  void restore(const SessionDocument& session);

  /// What it knows beside that, for a window that takes this one's place.
  struct Memory {
    CameraController::Memory camera;
    ComparisonController::Memory comparison;
    ViewTool tool = ViewTool::rotate;
    bool offersBody = false; ///< it is asked, or being found, whether to hide what lies beside the body
  };
  Memory memory() const;
  /// Of the same volume, which is shown already.
  void takeOver(const Memory& memory);

signals:
  /// The label at this place in the list shall be in hand.
  void labelChosen(std::size_t place);
  /// The slice in a plane shall be a picture, on the clipboard or in a file.
  void sliceCopyChosen(limn::PatientPlane plane);
  void sliceSaveChosen(limn::PatientPlane plane);

private:
  bool isDrawing() const;
  void addTools();
  void shareTools();
  void addCopying();
  void copyPicture();
  void showScene(const Scene& scene);
  void showState(const PictureState& state);

  WindowContext& m_context;
  QActionGroup* m_tools; ///< data: ViewTool as int
  StatusTexts m_status;
  CameraController m_camera;
  ComparisonController m_comparison;
  EngineController m_engines;
  RegionController m_regions;
  CutController m_cuts;
  OrientationController m_orientation;
  ViewsController m_views;
  CrosshairController m_crosshair;
  TurnedBoxController m_turnedBox;
  PlaneController m_planes;
  MeasureController m_measures;
  PictureMenu m_menu; ///< of what those before it offer
};

} // namespace limn
