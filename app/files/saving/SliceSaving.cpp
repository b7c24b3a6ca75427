// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/SliceSaving.h"

#include "app/asking/FileDialogs.h"
#include "app/document/DocumentText.h"
#include "app/files/saving/PictureDialog.h"
#include "app/window/WindowContext.h"
#include "io/ImageFile.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"

#include <QApplication>
#include <QClipboard>
#include <QStatusBar>

namespace limn {
namespace {

constexpr int copiedToldForMs = 4000;

BytePicture bytesOf(const QImage& picture, double dotsPerInch) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  BytePicture bytes;
  bytes.size = {rgb.width(), rgb.height()};
  bytes.dotsPerInch = dotsPerInch;
  for (int y = 0; y < rgb.height(); ++y) // rows of an image may have bytes to spare
    bytes.bytes.insert(bytes.bytes.end(), rgb.constScanLine(y),
                       rgb.constScanLine(y) + static_cast<std::ptrdiff_t>(3) * rgb.width());
  return bytes;
}

} // namespace

SliceSaving::SliceSaving(WindowContext& context) : QObject(&context.window), m_context(context) {
  connect(&m_writing, &BackgroundWork::failed, this,
          [this](const QString& sentence) { m_context.notes.sayFailure(sentence); });
}

SeenSlice SliceSaving::sliceIn(PatientPlane plane) const {
  const PlaneView& view = *m_context.planes.view(plane);
  return {view.content(), plane, view.frame(), view.size(), view.font()};
}

void SliceSaving::copy(PatientPlane plane) {
  const QImage picture = slicePicture(sliceIn(plane), {});
  QApplication::clipboard()->setImage(picture);
  m_context.window.statusBar()->showMessage(
      tr("Copied the slice, %1 × %2 pixels.").arg(picture.width()).arg(picture.height()), copiedToldForMs);
}

void SliceSaving::save(PatientPlane plane) {
  if (m_writing.isRunning())
    return m_context.notes.sayFailure(tr("Another slice is being written; save this one once it is there."));
  SeenSlice slice = sliceIn(plane); // of this moment
  const glm::ivec2 screen = slice.frame.grid.size;
  const std::optional<PictureOptions> options =
      askHowToSave({screen.x, screen.y}, m_context.settings, &m_context.window, PictureKind::slice);
  if (!options)
    return;
  const QString path = askWhereToSave(
      &m_context.window,
      {.title = tr("Save the slice"),
       .suggested =
           QStringLiteral("%1-%2.png").arg(suggestedName(m_context.document), QLatin1String(nameOf(plane))),
       .filters = {tr("Pictures (*.png *.tif)")},
       .isPicture = true},
      m_context.settings);
  if (path.isEmpty())
    return;
  if (hasOwnShape(*options)) {
    const QSize size = sizeInFile(*options, {screen.x, screen.y});
    slice.frame = shapedAs(slice.frame, {size.width(), size.height()});
    slice.size = QSizeF(size) / slice.frame.pixelRatio;
  } else {
    slice.frame = scaledBy(slice.frame, scaleOf(*options, {screen.x, screen.y}));
  }
  const double dots = options->size == PictureOptions::Size::print ? printDotsPerInch : 0.0;
  m_writing.start([this, slice = std::move(slice), marks = options->marks, path,
                   dots](const Effort&) -> BackgroundWork::Deliver {
    writeBytes(path.toStdString(), bytesOf(slicePicture(slice, marks), dots), {});
    return [this, path] { m_context.notes.attempt([] {}, path); };
  });
}

} // namespace limn
