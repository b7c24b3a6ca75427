// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/OpenDocument.h"

#include "app/document/DocumentText.h"

#include <QFileInfo>

namespace limn {

void OpenDocument::open(const LoadedScene& loaded, const Request& request, const Histogram& histogram) {
  m_request = request;
  m_request.options.read = loaded.read;
  m_sessionFile.clear();
  if (loaded.session)
    m_sessionFile =
        request.isUnsavedSession ? QString::fromStdString(loaded.session->savedAs) : request.source;
  if (request.isUnsavedSession)
    m_request.source = QString::fromStdString(loaded.volumePath); // its own file goes
  m_histogram = histogram;
  m_preset = {};
  m_preset.name = loaded.session ? loaded.session->preset : loaded.preset;
  m_preset.transferFunction = loaded.scene.transferFunction;
  m_preset.gradientOpacity = loaded.scene.gradientOpacity;
  m_settled = {};
  m_session.open(loaded);
  if (request.isUnsavedSession && loaded.session && loaded.session->isUnsaved)
    m_session.undoStack().resetClean();
}

void OpenDocument::close() {
  m_sessionFile.clear();
  m_session.open({});
}

std::string OpenDocument::presetShown() const {
  const bool isShown = scene().volume && scene().transferFunction == m_preset.transferFunction &&
                       scene().gradientOpacity == m_preset.gradientOpacity;
  return isShown ? m_preset.name : std::string();
}

SessionDocument OpenDocument::described() const {
  SessionDocument session;
  session.scene.scene = scene();
  session.scene.scene.volume.reset();
  session.scene.scene.keep = {};
  session.scene.keep = keptPartOf(scene().keep);
  session.scene.volume = volumePath();
  session.scene.hasCamera = true;
  session.scene.hasTransferFunction = true;
  session.series = m_request.options.read.series;
  session.spacingMm = m_request.options.read.spacingMm;
  session.preset = presetShown();
  return session;
}

void OpenDocument::settleIn(const QString& file, const SessionDocument& now) {
  m_sessionFile = QFileInfo(file).absoluteFilePath();
  m_session.undoStack().setClean();
  m_settled = now;
}

std::optional<SessionDocument> OpenDocument::unsaved(SessionDocument now) const {
  if (!scene().volume)
    return std::nullopt;
  SessionDocument settled = m_settled;
  settled.panel = now.panel; // alone no loss
  if (!m_session.isEdited() && now == settled)
    return std::nullopt;
  now.isUnsaved = m_session.isEdited();
  now.savedAs = m_sessionFile.toStdString();
  now.label = labelOf(*this).toStdString();
  return now;
}

} // namespace limn
