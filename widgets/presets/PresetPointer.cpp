// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetPointer.h"

#include "widgets/presets/PresetModel.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QMouseEvent>

namespace limn {
namespace {

// Whoever crosses the list on the way to something else wants no pictures; one preset after the other is
// looked at more quickly.
constexpr int firstMs = 250;
constexpr int nextMs = 60;

} // namespace

PresetPointer::PresetPointer(QAbstractItemView& list)
    : QObject(&list), m_list(list), m_viewport(list.viewport()) {
  m_wait.setSingleShot(true);
  connect(&m_wait, &QTimer::timeout, this, [this] { point(m_next); });
  list.installEventFilter(this);
  list.viewport()->installEventFilter(this);
}

bool PresetPointer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_viewport) {
    if (event->type() == QEvent::MouseMove) {
      const auto& moved = static_cast<const QMouseEvent&>(*event);
      pointSoon(moved.buttons() ? QModelIndex() : m_list.indexAt(moved.position().toPoint()));
    } else if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel) {
      // Another preset may lie there now, under a pointer that has not moved.
      m_wait.stop();
      m_next = m_pointedAt;
    } else if (event->type() == QEvent::Leave || event->type() == QEvent::Hide) {
      point({});
    }
    return false;
  }
  if (event->type() == QEvent::FocusOut)
    point({});
  else if (event->type() == QEvent::KeyPress)
    noteKey(static_cast<QKeyEvent*>(event)->key());
  return false;
}

void PresetPointer::pointSoon(const QModelIndex& index) {
  const bool isPreset = index.isValid() && !index.data(presetRole::isGroup).toBool();
  const QString preset = isPreset ? index.data().toString() : QString();
  if (preset == m_next)
    return;
  m_next = preset;
  m_wait.start(m_pointedAt.isEmpty() ? firstMs : nextMs);
}

void PresetPointer::point(const QString& preset) {
  m_wait.stop();
  m_next = preset;
  if (preset == m_pointedAt)
    return;
  m_pointedAt = preset;
  emit pointedAt(preset);
}

// The list has not moved yet: it does so once it has the key.
void PresetPointer::noteKey(int key) {
  switch (key) {
  case Qt::Key_Up:
  case Qt::Key_Down:
  case Qt::Key_Left:
  case Qt::Key_Right:
  case Qt::Key_PageUp:
  case Qt::Key_PageDown:
  case Qt::Key_Home:
  case Qt::Key_End:
    QTimer::singleShot(0, this, [this] {
      const QModelIndex index = m_list.currentIndex();
      point(index.data(presetRole::isGroup).toBool() ? QString() : index.data().toString());
    });
    break;
  case Qt::Key_Escape:
    point({});
    break;
  default:
    break;
  }
}

} // namespace limn
