// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Files.h"

#include "app/document/DocumentText.h"
#include "app/files/exports/DicomDialog.h"
#include "app/files/exports/TurntableDialog.h"
#include "app/window/WindowContext.h"

namespace limn {

Files::Files(WindowContext& context, FileSources sources)
    : QObject(&context.window), m_context(context), m_sources(std::move(sources)), m_pictures(context),
      m_saving(context, m_sources.session), m_safety(context, m_sources.session),
      m_opening(context, [this] { return m_safety.savingOfNow(); }), m_remarks(context, m_opening),
      m_drops(context.window) {
  const QAction* close = context.actions.add(QStringLiteral("closeVolume"), {.text = tr("&Close volume"),
                                                                             .place = {Menu::file, 3, 1},
                                                                             .shortcut = QKeySequence::Close,
                                                                             .needsVolume = true});
  offerExport<FigureDialog>(context, QStringLiteral("saveFigure"), FigureDialog::look(), m_sources.looks,
                            &m_saving);
  offerExport<TurntableDialog>(context, QStringLiteral("saveTurntable"), TurntableDialog::look(), &m_saving);
  offerExport<SurfaceDialog>(context, QStringLiteral("exportSurface"), SurfaceDialog::look(),
                             m_sources.curve);
  offerExport<DicomDialog>(context, QStringLiteral("saveDicom"), DicomDialog::look());
  connect(close, &QAction::triggered, this, &Files::closeRequested);
  connect(&m_pictures, &PictureSaving::complete, &m_saving, &SavingController::writePicture);
  connect(&m_safety, &SessionSafety::saveRequested, &m_saving, &SavingController::saveSession);
  connect(&m_safety, &SessionSafety::restoreRequested, &m_opening, &OpeningController::restore);
  connect(&m_saving, &SavingController::sessionSaved, &m_safety, &SessionSafety::noteChange);
}

void Files::noteOpened(const LoadedScene& loaded, const Request& request) {
  const OpenDocument& document = m_context.document;
  m_remarks.show(loaded.notes);
  if (request.isUnsavedSession) {
    m_safety.takeOver(request.source);
  } else {
    m_context.document.settle(m_sources.session());
    m_safety.noteChange();
  }
  m_opening.remember(document.request().source, labelOf(document), document.volumePath());
}

} // namespace limn
