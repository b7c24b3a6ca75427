// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace limn {

/// Stands below the pictures where the graphics driver failed and the processor draws: why, with a way to try
/// again and to copy what a report needs.
class FailureBar : public QFrame {
  Q_OBJECT

public:
  explicit FailureBar(QWidget* parent);

  /// `details`: what the driver wrote, for the clipboard.
  void setReason(const QString& sentence, const QString& details);
  bool hasReason() const { return !m_sentence.isEmpty(); }

signals:
  void retryRequested();

private:
  void copyDetails() const;

  QLabel* m_text = nullptr;
  QString m_sentence;
  QString m_details;
};

} // namespace limn
