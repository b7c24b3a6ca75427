// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/DropController.h"

#include "app/asking/LookFiles.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

namespace limn {
namespace {

QStringList filesIn(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile())
      paths << url.toLocalFile();
  return paths;
}

} // namespace

DropController::DropController(QWidget& window) : QObject(&window) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool DropController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
    return QObject::eventFilter(watched, event);
  auto& drop = static_cast<QDropEvent&>(*event); // a drag that enters is one, too
  const QStringList paths = filesIn(*drop.mimeData());
  if (paths.isEmpty())
    return false;
  drop.acceptProposedAction();
  if (event->type() == QEvent::Drop)
    tell(paths);
  return true;
}

void DropController::tell(const QStringList& paths) {
  QStringList looks, others;
  for (const QString& path : paths)
    (holdsLooks(path) ? looks : others) << path;
  if (!looks.isEmpty())
    emit looksDropped(looks);
  if (!others.isEmpty())
    emit sourceDropped(others.front());
}

} // namespace limn
