// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/MainWindow.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>

namespace limn {

/// The program's window in the language of its user. Once another is chosen, a window in that language takes
/// the place of the one that is there, with all that is open: nothing is read again, and nobody is asked. It
/// comes once nothing is under way or in the user's hand; what is being typed counts as entered.
class SpokenWindow : public QObject {
  Q_OBJECT

public:
  /// The window, not shown yet. `language` is what the program speaks already, as useLanguage was asked for
  /// it; the rest is as for MainWindow.
  SpokenWindow(UserFolders folders, const std::optional<MemoryBudget>& memory, const QString& language);

  /// The one of now: another after `replaced`.
  MainWindow& window() { return *m_window; }

signals:
  void replaced();

private:
  void follow();
  void speak(const QString& language);
  bool mayReplace() const;
  void replace();

  UserFolders m_folders;
  std::optional<MemoryBudget> m_memory;
  QString m_language; ///< as asked for
  QTimer m_again;     ///< while the window is busy
  std::unique_ptr<MainWindow> m_window;
};

} // namespace limn
