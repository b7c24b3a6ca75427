// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/DicomFolder.h"

#include <QDialog>

#include <vector>

class QTreeWidget;

namespace limn {

/// Lets the user choose one of the series in a folder; at first the one of the number `chosen` is, or else
/// the largest.
class SeriesDialog : public QDialog {
  Q_OBJECT

public:
  SeriesDialog(const std::vector<SeriesSummary>& series, QWidget* parent, int chosen = 0);

signals:
  /// The number of the chosen series, as DicomFolder gives it.
  void seriesChosen(int number);

private:
  void makeTable();
  void choose();

  std::vector<SeriesSummary> m_series;
  QTreeWidget* m_list;
};

} // namespace limn
