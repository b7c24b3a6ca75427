// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/OpenDocument.h"

#include "app/document/DocumentText.h"
#include "io/scenefile/SessionFile.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"

#include <QFileInfo>

namespace limn {
namespace {

// What was loaded shows the preset that it names, whatever that is called by now, unless it was changed.
Preset presetShownBy(const LoadedScene& loaded) {
  if (loaded.session && loaded.session->changedPreset)
    return *loaded.session->changedPreset;
  return presetOf(loaded.scene, loaded.session ? loaded.session->preset : loaded.preset);
}

} // namespace

void OpenDocument::open(const LoadedScene& loaded, const Request& request, const Histogram& histogram) {
  m_request = request;
  m_request.options.read = loaded.read;
  m_request.options.dicom = loaded.dicom;
  m_sessionFile.clear();
  m_sparedSession.clear();
  if (loaded.session) {
    const QString file =
        request.isUnsavedSession ? QString::fromStdString(loaded.session->savedAs) : request.source;
    (loaded.sparesSession() ? m_sparedSession : m_sessionFile) = file;
  }
  m_sessionDigest = loaded.sessionDigest;
  if (request.isUnsavedSession && loaded.session)
    m_sessionDigest = loaded.session->savedDigest;
  if (request.isUnsavedSession)
    m_request.source = QString::fromStdString(loaded.volumePath); // its own file goes
  m_histogram = histogram;
  m_settled = {};
  m_session.open(loaded, presetShownBy(loaded));
  if (request.isUnsavedSession && loaded.session && loaded.session->isUnsaved)
    m_session.undoStack().resetClean();
}

void OpenDocument::close() {
  m_sessionFile.clear();
  m_sparedSession.clear();
  m_sessionDigest.clear();
  m_request.options.dicom.reset();
  m_session.open({});
}

OpenDocument::PresetInUse OpenDocument::presetInUse() const {
  const Preset& preset = m_session.preset();
  if (!scene().volume || preset.name.empty())
    return {};
  return {preset.name, withPreset(scene(), preset, true) != scene()};
}

void OpenDocument::fitCamera(const Camera& camera) {
  if (Camera& settled = m_settled.scene.scene.camera; settled == scene().camera)
    settled = camera;
  m_session.setCamera(camera);
}

SessionDocument OpenDocument::described() const {
  SessionDocument session;
  session.scene.scene = scene();
  session.scene.scene.volume.reset();
  session.scene.scene.keep = {};
  session.scene.keep = keptPartOf(scene().keep);
  session.scene.volume = volumePath();
  session.scene.measurements = m_session.measurements();
  if (scene().volume)
    session.scene.orientation = scene().volume->info().orientationByHand;
  session.scene.views = m_session.views();
  session.scene.hasCamera = true;
  session.scene.hasTransferFunction = true;
  session.series = m_request.options.read.series;
  session.spacingMm = m_request.options.read.spacingMm;
  if (const auto& volume = scene().volume)
    session.traits = {volume->grid().dims, looksLikeHounsfield(*volume)};
  const PresetInUse preset = presetInUse();
  if (preset.isModified)
    session.changedPreset = m_session.preset();
  else
    session.preset = preset.name;
  return session;
}

bool OpenDocument::sessionFileWasChanged() const {
  if (m_sessionDigest.empty() || !QFileInfo::exists(m_sessionFile))
    return false;
  try {
    return digestOf(readTextFile(m_sessionFile.toStdString())) != m_sessionDigest;
  } catch (const Error&) {
    return true; // it could be read before
  }
}

void OpenDocument::settleIn(const QString& file, const SessionDocument& now, const std::string& digest) {
  m_sessionFile = QFileInfo(file).absoluteFilePath();
  m_sparedSession.clear();
  m_sessionDigest = digest;
  m_session.undoStack().setClean();
  m_settled = now;
}

std::optional<SessionDocument> OpenDocument::unsaved(SessionDocument now) const {
  if (!scene().volume)
    return std::nullopt;
  SessionDocument settled = m_settled;
  settled.panel = now.panel; // alone no loss
  settled.labelInHand = now.labelInHand;
  if (!m_session.isEdited() && now == settled)
    return std::nullopt;
  now.isUnsaved = m_session.isEdited();
  now.savedAs = m_sessionFile.toStdString();
  now.savedDigest = m_sessionDigest;
  now.label = (m_sessionFile.isEmpty() ? labelOfVolume(*this) : labelOf(*this, m_sessionFile)).toStdString();
  return now;
}

} // namespace limn
