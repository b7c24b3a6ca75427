// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/SlicePictures.h"

#include "app/asking/FileDialogs.h"
#include "app/document/DocumentText.h"
#include "app/window/WindowContext.h"
#include "io/ImageFile.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"

#include <QApplication>
#include <QClipboard>
#include <QObject>
#include <QStandardPaths>
#include <QStatusBar>

namespace limn {
namespace {

constexpr int copiedToldForMs = 4000;

BytePicture bytesOf(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  BytePicture bytes;
  bytes.size = {rgb.width(), rgb.height()};
  for (int y = 0; y < rgb.height(); ++y) // rows of an image may have bytes to spare
    bytes.bytes.insert(bytes.bytes.end(), rgb.constScanLine(y),
                       rgb.constScanLine(y) + static_cast<std::ptrdiff_t>(3) * rgb.width());
  return bytes;
}

} // namespace

void copySlice(WindowContext& context, PatientPlane plane) {
  const QImage picture = context.planes.view(plane)->picture();
  QApplication::clipboard()->setImage(picture);
  context.window.statusBar()->showMessage(
      QObject::tr("Copied the slice, %1 × %2 pixels.").arg(picture.width()).arg(picture.height()),
      copiedToldForMs);
}

void saveSlice(WindowContext& context, PatientPlane plane) {
  const QImage picture = context.planes.view(plane)->picture(); // of this moment
  const QString path = askWhereToSave(
      &context.window,
      {QObject::tr("Save the slice"),
       QStringLiteral("%1-%2.png").arg(suggestedName(context.document), QLatin1String(nameOf(plane))),
       {QObject::tr("Pictures (*.png *.tif)")},
       QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)},
      context.settings);
  if (!path.isEmpty())
    context.notes.attempt([&] { writeBytes(path.toStdString(), bytesOf(picture), {}); }, path);
}

} // namespace limn
