// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/exports/ExportDialog.h"
#include "io/surfaces/SurfaceMaker.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace limn {

class NumberField;

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
