// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QVBoxLayout;

namespace limn {

/// A window for a chart that has too little room in its panel. It takes no keyboard when it opens.
class ChartWindow : public QDialog {
  Q_OBJECT

public:
  explicit ChartWindow(QWidget* parent);

  /// Takes the chart in and opens beside the column of its window in which `panel` stands.
  void openBeside(QWidget& chart, const QWidget& panel);

  QSize sizeHint() const override { return {640, 440}; }

private:
  QVBoxLayout* m_room;
};

} // namespace limn
