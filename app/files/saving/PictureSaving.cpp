// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/PictureSaving.h"

#include "app/asking/FileDialogs.h"
#include "app/document/DocumentText.h"
#include "app/window/WindowContext.h"
#include "widgets/view/CompareView.h"

#include <QFileInfo>
#include <QLabel>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

namespace limn {

PictureSaving::PictureSaving(WindowContext& context)
    : QObject(&context.window), m_context(context), m_text(new QLabel(context.window.statusBar())),
      m_stop(new QToolButton(context.window.statusBar())) {
  const QAction* save = context.actions.add(
      QStringLiteral("savePicture"),
      {.text = tr("Save &picture…"),
       .place = {Menu::file, 2, 4},
       .shortcut = tr("Ctrl+Shift+S"),
       .toolTip = tr("Saves the picture on screen at full quality, with its scene inside."),
       .icon = QStringLiteral("snapshot"),
       .iconText = tr("Snapshot"),
       .tool = {ToolPlace::atTheEnd, 1},
       .needsVolume = true});
  connect(save, &QAction::triggered, this, &PictureSaving::ask);
  m_stop->setObjectName(QStringLiteral("stopWaiting"));
  m_stop->setText(tr("Cancel"));
  m_stop->setAccessibleName(tr("Cancel: saving the picture"));
  m_stop->setMaximumHeight(m_text->sizeHint().height());
  m_stop->setStyleSheet(QStringLiteral("padding: 0px 4px; margin: 0px; text-decoration: underline;"));
  context.window.statusBar()->insertPermanentWidget(2, m_text);
  context.window.statusBar()->insertPermanentWidget(3, m_stop);
  // Once the event loop is back: the view may be drawing.
  connect(&context.view, &CompareView::told, this, [this] {
    if (!m_awaited.path().isEmpty())
      QTimer::singleShot(0, this, &PictureSaving::look);
  });
  connect(m_stop, &QToolButton::clicked, this, &PictureSaving::forget);
  forget();
}

PictureContent PictureSaving::content() const {
  return {m_context.view.scenesOfSides(), m_context.view.compareLayout()};
}

void PictureSaving::ask() {
  const PictureContent asked = content();
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString path = askWhereToSave(&m_context.window,
                                      {tr("Save the picture"),
                                       suggestedName(m_context.document) + QStringLiteral(".png"),
                                       {tr("Pictures (*.png *.tif *.jpg *.exr)")},
                                       folder},
                                      m_context.settings);
  if (path.isEmpty())
    return;
  m_awaited.await(path, asked);
  look();
}

void PictureSaving::look() {
  const QString path = m_awaited.path();
  if (path.isEmpty())
    return;
  switch (m_awaited.look(content(), [this] { return m_context.view.restingImage(0).has_value(); })) {
  case AwaitedPicture::Outcome::waits:
    m_text->setText(tr("Saving %1 once the picture is complete").arg(QFileInfo(path).fileName()));
    m_text->show();
    m_stop->show();
    break;
  case AwaitedPicture::Outcome::complete:
    forget();
    emit complete(path);
    break;
  case AwaitedPicture::Outcome::changed:
    forget();
    m_context.notes.sayFailure(
        tr("The picture changed before it was complete, so it is not saved; save it again."));
    break;
  }
}

void PictureSaving::forget() {
  m_awaited.forget();
  m_text->hide();
  m_stop->hide();
}

} // namespace limn
