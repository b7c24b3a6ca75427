// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace limn {

/// A field for words that are looked for, with its lens and a button that empties it. Undo and redo belong to
/// the words while there are any, and to the program otherwise.
class SearchField : public QLineEdit {
  Q_OBJECT

public:
  /// `name` says what is looked for, in the empty field and to assistive technology.
  explicit SearchField(const QString& name, QWidget* parent = nullptr);

protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void showIcon();

  QAction* m_icon;
};

} // namespace limn
