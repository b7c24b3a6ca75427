// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/ActionList.h"

#include <QDialog>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QProcess>
#include <QString>

#include <optional>

class QAction;
class QActionGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QWidget;

namespace limn {

class GuideWindow;
struct WindowContext;

/// Says what Limn is, in a box that blocks nothing.
void showAbout(QWidget* parent);

/// Runs `limn stability` on this computer and tells what it found. It runs in a process of its own: a driver
/// that crashes in a check takes nothing along, and the window goes on.
class StabilityDialog : public QDialog {
  Q_OBJECT

public:
  /// `program` is Limn's own executable; the report goes into `folder`.
  StabilityDialog(const QString& program, const QString& folder, QWidget* parent);
  ~StabilityDialog() override;

  bool isChecking() const { return m_process.state() != QProcess::NotRunning; }

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

/// What stays from run to run, whatever is open: its only place. It shows and triggers the actions that were
/// registered as settings.
class SettingsDialog : public QDialog {
  Q_OBJECT

public:
  SettingsDialog(const ActionList& actions, QWidget* parent);

  /// Which of its fields has the keyboard, for a dialog that takes its place; -1: none.
  int fieldInHand() const;
  void takeInHand(int field);

private:
  QComboBox* choiceOf(QActionGroup& group, const QString& name);
  QCheckBox* switchOf(QAction& action);
  QLabel* consequenceOf(const ActionList::Setting& setting);
  QPushButton* buttonOf(QAction& action);
};

/// The dialogs that are about the program and not about what is shown: settings, guide, keys, stability
/// checks, about. None blocks the window.
class DialogController : public QObject {
  Q_OBJECT

public:
  explicit DialogController(WindowContext& context);

  /// Whether stability is being checked, or a dialog asks or tells something that would be lost with it.
  bool isBusy() const;

  /// Which of them are shown, for a window that takes this one's place.
  struct Memory {
    std::optional<int> settingsField;  ///< as takeInHand takes it; absent: the settings are not shown
    std::optional<QString> guidePlace; ///< absent: the guide is not shown
  };
  Memory memory() const;
  void takeOver(const Memory& memory);

private:
  void addHelp();
  void showSettings();
  void showStability();
  void showGuide(const QString& place);

  WindowContext& m_context;
  QPointer<SettingsDialog> m_settings;
  QPointer<StabilityDialog> m_stability;
  QPointer<GuideWindow> m_guide;
};

} // namespace limn
