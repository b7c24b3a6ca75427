// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/saving/PictureSaving.h"

#include "app/saving/SaveDialog.h"
#include "widgets/view/CompareView.h"

#include <QFileInfo>
#include <QLabel>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

namespace limn {

PictureSaving::PictureSaving(CompareView& view, Settings& settings, QStatusBar& status, QObject* parent)
    : QObject(parent), m_view(view), m_settings(settings), m_text(new QLabel(&status)),
      m_stop(new QToolButton(&status)) {
  m_stop->setObjectName(QStringLiteral("stopWaiting"));
  m_stop->setText(tr("Cancel"));
  m_stop->setAccessibleName(tr("Cancel: saving the picture"));
  m_stop->setMaximumHeight(m_text->sizeHint().height());
  m_stop->setStyleSheet(QStringLiteral("padding: 0px 4px; margin: 0px; text-decoration: underline;"));
  status.addPermanentWidget(m_text);
  status.addPermanentWidget(m_stop);
  connect(m_stop, &QToolButton::clicked, this, &PictureSaving::forget);
  forget();
}

PictureContent PictureSaving::content() const {
  return {m_view.scenesOfSides(), m_view.compareLayout()};
}

void PictureSaving::ask(const QString& suggested) {
  const PictureContent asked = content();
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString path = askWhereToSave(m_view.window(),
                                      {tr("Save the picture"),
                                       suggested + QStringLiteral(".png"),
                                       {tr("Pictures (*.png *.tif *.jpg *.exr)")},
                                       folder},
                                      m_settings);
  if (path.isEmpty())
    return;
  m_awaited.await(path, asked);
  look();
}

void PictureSaving::lookSoon() {
  if (!m_awaited.path().isEmpty())
    QTimer::singleShot(0, this, &PictureSaving::look);
}

void PictureSaving::look() {
  const QString path = m_awaited.path();
  if (path.isEmpty())
    return;
  switch (m_awaited.look(content(), [this] { return m_view.restingImage(0).has_value(); })) {
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
    emit failed(tr("The picture changed before it was complete, so it is not saved; save it again."));
    break;
  }
}

void PictureSaving::forget() {
  m_awaited.forget();
  m_text->hide();
  m_stop->hide();
}

} // namespace limn
