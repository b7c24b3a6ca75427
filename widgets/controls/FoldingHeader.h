// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

class QLabel;

namespace limn {

/// The header of a FoldingSection: a button, checked while the section is open, with an arrow, the section's
/// name and a few words at the right. Enter presses it too. Assistive technology finds a button that is
/// expanded or collapsed rather than a check box, which would seem to switch on what the section is about.
class FoldingHeader : public QAbstractButton {
  Q_OBJECT

public:
  explicit FoldingHeader(const QString& title, QWidget* parent = nullptr);

  /// A few words at the right; empty for none.
  void setSummary(const QString& summary);

protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void showArrow();

  QLabel* m_arrow;
  QLabel* m_summary;
};

} // namespace limn
