// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QInputDialog>

#include <functional>

class QLineEdit;

namespace limn {

/// Asks for a text, at first selected, and stays with what was typed as long as that is refused: its field
/// has a red edge then, and says why.
class NameDialog : public QInputDialog {
  Q_OBJECT

public:
  /// Why a text, without spaces around it, is refused; empty: it is not.
  using Refusal = std::function<QString(const QString& text)>;

  NameDialog(const QString& title, const QString& label, const QString& text, Refusal refusal,
             QWidget* parent);

  /// Why what was typed was refused; empty: it was not, or something else has been typed since.
  QString said() const;

  void done(int result) override;

private:
  void showRefusal(const QString& sentence);

  Refusal m_refusal;
  QLineEdit* m_field;
};

} // namespace limn
