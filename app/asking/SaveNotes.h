// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

class QStatusBar;

namespace limn {

class MessageBar;

/// Says of whatever is saved that it was, or why not; what failed is forgotten once something is saved.
class SaveNotes {
public:
  SaveNotes(QStatusBar& status, MessageBar& messages) : m_status(status), m_messages(messages) {}

  /// Calls `write`, which throws Error where it fails; returns whether it did not. `path`, where there is
  /// one, is named in the status bar.
  bool attempt(const std::function<void()>& write, const QString& path = {});

  void sayFailure(const QString& sentence);

private:
  QStatusBar& m_status;
  MessageBar& m_messages;
  QString m_failure; ///< the last, until something was saved
};

} // namespace limn
