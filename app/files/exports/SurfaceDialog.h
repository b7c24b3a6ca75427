// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/exports/ExportDialog.h"
#include "io/surfaces/SurfaceExport.h"
#include "io/surfaces/SurfaceMaker.h"

#include <QString>

class QCheckBox;
class QComboBox;
class QLabel;

namespace limn {

class NumberField;

/// Where the value of a surface comes from that nobody typed.
enum class ValueOrigin { isosurface, pin, point, range };

/// A value to begin with.
struct FirstValue {
  double value = 0.0;
  ValueOrigin origin = ValueOrigin::range;
  bool operator==(const FirstValue&) const = default;
};

/// The isovalue of a scene that shows an isosurface, else the pinned value, else that of the selected point
/// of the curve, else the scene's isovalue where the volume reaches it, else the middle of its range.
FirstValue firstValue(const Scene& scene, std::optional<double> pinned,
                      std::optional<std::size_t> selectedPoint);

/// One sentence each.
QString textOf(ValueOrigin origin);
/// How many triangles, how large the file, in which units and axes.
QString textOf(const SurfaceEstimate& estimate, bool willLoseTriangles);
/// What was made: triangles, whether it is watertight, how far it lies from the isosurface.
QString textOf(const MadeSurface& made, const QString& file);

/// What is in hand on the curve: a pinned value, the only point that is selected.
struct CurveChoice {
  std::optional<double> pinnedValue;
  std::optional<std::size_t> point;
};

/// Asks how an isosurface of what is open is made into a mesh, says what would come of it, and exports it.
class SurfaceDialog : public ExportDialog {
  Q_OBJECT

public:
  /// `curve` tells what is in hand there: the value is begun with it.
  SurfaceDialog(WindowContext& context, std::function<CurveChoice()> curve);

  static ActionLook look();
  static bool suits(const Scene& scene) { return scene.volume != nullptr; }

private:
  QString doing(double fraction) const override;
  void begin(bool isNew) override;
  void showScene(const Scene& scene) override;
  SurfaceOrder order() const;
  void estimate();
  void exportSurface();
  /// What the order would come to, or why it cannot be made; then nothing can be exported.
  void showEstimate(const QString& sentence, bool canBeMade);
  void layOut();
  void name();

  std::function<CurveChoice()> m_curve;
  Scene m_estimated; ///< of which the last estimate was made
  BackgroundWork m_estimate;
  NumberField* m_value;
  QLabel* m_unit;
  QLabel* m_origin;
  QCheckBox* m_isClosed;
  NumberField* m_smallest;
  NumberField* m_tolerance;
  QComboBox* m_cells;
};

} // namespace limn
