// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

class QAbstractItemView;
class QModelIndex;

namespace limn {

/// Tells on which preset of a list the pointer rests, or to which one the keyboard has gone: what a preview
/// shows. It ends where pointer or keyboard leave the list, or something is pressed that chooses.
class PresetPointer : public QObject {
  Q_OBJECT

public:
  /// Becomes a child of `list`, whose items have presetRole and are named by Qt::DisplayRole.
  explicit PresetPointer(QAbstractItemView& list);

signals:
  /// Empty: none any more.
  void pointedAt(const QString& preset);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void pointSoon(const QModelIndex& index);
  void point(const QString& preset);
  void noteKey(int key);

  QAbstractItemView& m_list;
  const QWidget* m_viewport; ///< of the list, which is asked for it no more once it goes
  QString m_next;            ///< what the pointer is on
  QString m_pointedAt;
  QTimer m_wait;
};

} // namespace limn
