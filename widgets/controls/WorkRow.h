// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/TimeLeft.h"

#include <QWidget>

#include <optional>

class QLabel;
class QProgressBar;

namespace limn {

/// How far long work is: a thin bar, what is being done, and a button to stop it. Hidden while nothing is.
class WorkRow : public QWidget {
  Q_OBJECT

public:
  /// `name` is the work as those are told who cannot see the bar.
  explicit WorkRow(const QString& name, QWidget* parent = nullptr);

  /// `fraction` 0..1; absent once nothing is done.
  void showProgress(std::optional<double> fraction, const QString& doing);

signals:
  void cancelled();

private:
  QProgressBar* m_bar;
  QLabel* m_doing;
  TimeLeft m_left;
};

} // namespace limn
