// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QProcess>

class QLabel;
class QProgressBar;
class QPushButton;

namespace limn {

/// Runs `limn stability` on this computer and tells what it found. It runs in a process of its own: a driver
/// that crashes in a check takes nothing along, and the window goes on.
class StabilityDialog : public QDialog {
  Q_OBJECT

public:
  /// `program` is Limn's own executable; the report goes into `folder`.
  StabilityDialog(const QString& program, const QString& folder, QWidget* parent);
  ~StabilityDialog() override;

private:
  void start();
  void showEnd(int exitCode, QProcess::ExitStatus status);
  void showRunning(bool runs);

  QString m_program;
  QString m_folder;
  QProcess m_process;
  QLabel* m_text;
  QProgressBar* m_bar;
  QPushButton* m_start;
  QPushButton* m_stop;
  QPushButton* m_open;
};

} // namespace limn
