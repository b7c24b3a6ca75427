// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QStringList>

#include <functional>

class QLabel;
class QToolButton;

namespace limn {

/// One sentence above the picture: an error or a warning, with an optional action and further lines on
/// demand. Never modal.
class MessageBar : public QFrame {
  Q_OBJECT

public:
  explicit MessageBar(QWidget* parent = nullptr);

  enum class Kind { error, warning, question };

  /// A button beside the sentence: what it says and does. Empty: no button.
  struct Action {
    QString text;
    std::function<void()> run;
  };

  /// Shows a sentence; `details` (may be empty) unfold on demand. `dismissal` is what its last button says
  /// and does before the bar hides.
  void show(Kind kind, const QString& sentence, const QStringList& details = {}, const Action& action = {},
            const Action& dismissal = {});

  QString sentence() const;

private:
  QLabel* m_sentence;
  QLabel* m_details;
  QToolButton* m_more;
  QToolButton* m_action;
  QToolButton* m_close;
  std::function<void()> m_run;
  std::function<void()> m_dismiss;
};

} // namespace limn
