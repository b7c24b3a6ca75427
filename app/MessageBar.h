// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace limn {

/// One sentence above the picture: an error or a warning, with an optional action and further lines on
/// demand. Never modal.
class MessageBar : public QFrame {
  Q_OBJECT

public:
  explicit MessageBar(QWidget* parent = nullptr);

  enum class Kind { error, warning };

  /// Shows a sentence; `details` (may be empty) unfold on demand. `action` (may be empty) labels a button.
  void show(Kind kind, const QString& sentence, const QStringList& details = {}, const QString& action = {});

  QString sentence() const;

signals:
  void actionRequested();

private:
  void setDetailsShown(bool shown);

  QLabel* m_sentence;
  QLabel* m_details;
  QToolButton* m_more;
  QToolButton* m_action;
};

} // namespace limn
