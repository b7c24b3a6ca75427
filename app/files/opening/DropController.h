// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace limn {

/// Takes the files that are dropped on a window and says what each is: looks, however many, and one other
/// file, which is to be opened.
class DropController : public QObject {
  Q_OBJECT

public:
  /// The window accepts drops from now on.
  explicit DropController(QWidget& window);

signals:
  void looksDropped(const QStringList& paths);
  void sourceDropped(const QString& path);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void tell(const QStringList& paths);
};

} // namespace limn
