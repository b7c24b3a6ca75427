// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/saving/WorkDialog.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace limn {

class NumberField;

/// Asks how an isosurface is made into a mesh, and says what comes of it. It makes nothing.
class SurfaceDialog : public WorkDialog {
  Q_OBJECT

public:
  explicit SurfaceDialog(QWidget* parent);

  /// The value that is begun with, in the volume's `unit`, and a sentence about where it comes from.
  void setValue(double value, const QString& unit, const QString& origin);
  void setTolerance(double mm);

  double value() const;
  bool isClosed() const;
  double smallestPartMm3() const;
  double toleranceMm() const; ///< 0: all triangles stay
  int cells() const;          ///< along each axis from a voxel to the next

  /// What the order would come to, or why it cannot be made; then nothing can be exported.
  void showEstimate(const QString& sentence);
  void showRefusal(const QString& sentence);

signals:
  /// Another surface is wished for than the one that was estimated.
  void orderEdited();
  void exportRequested();

private:
  QString doing(double fraction) const override;
  void layOut();
  void name();

  NumberField* m_value;
  QLabel* m_unit;
  QLabel* m_origin;
  QCheckBox* m_isClosed;
  NumberField* m_smallest;
  NumberField* m_tolerance;
  QComboBox* m_cells;
};

} // namespace limn
