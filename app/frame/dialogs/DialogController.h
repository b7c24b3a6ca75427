// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

namespace limn {

class GuideWindow;
class SettingsDialog;
class StabilityDialog;
struct WindowContext;

/// The dialogs that are about the program and not about what is shown: settings, guide, keys, stability
/// checks, about. None blocks the window.
class DialogController : public QObject {
  Q_OBJECT

public:
  explicit DialogController(WindowContext& context);

private:
  void addHelp();
  void showSettings();
  void showStability();
  void showGuide();

  WindowContext& m_context;
  QPointer<SettingsDialog> m_settings;
  QPointer<StabilityDialog> m_stability;
  QPointer<GuideWindow> m_guide;
};

} // namespace limn
