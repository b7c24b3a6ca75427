// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/saving/SavingDesk.h"

#include "app/PrivateNames.h"
#include "app/Settings.h"
#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/saving/ComparedPicture.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "widgets/view/CompareView.h"

#include <QWidget>

namespace limn {

SavingDesk::SavingDesk(OpenDocument& document, CompareView& view, Settings& settings, SaveNotes& notes,
                       std::function<SessionDocument()> session, QWidget& window)
    : QObject(&window), m_document(document), m_view(view), m_settings(settings), m_notes(notes),
      m_session(std::move(session)), m_window(window) {}

void SavingDesk::saveSession() {
  m_document.sessionFile().isEmpty() ? saveSessionAs() : writeSession(m_document.sessionFile());
}

void SavingDesk::saveSessionAs() {
  const QString suggested = m_document.sessionFile().isEmpty()
                                ? suggestedName(m_document) + QStringLiteral("-session.limn.json")
                                : m_document.sessionFile();
  const QString path = askWhereToSave(
      &m_window,
      {tr("Save the session"), suggested, {tr("Limn session (*.limn.json)"), tr("Any JSON file (*.json)")}},
      m_settings);
  if (!path.isEmpty())
    writeSession(path);
}

void SavingDesk::saveScene() {
  const QString suggested = suggestedName(m_document) + QStringLiteral(".limn.json");
  const QString path = askWhereToSave(
      &m_window,
      {tr("Save look and camera"), suggested, {tr("Limn scene (*.limn.json)"), tr("Any JSON file (*.json)")}},
      m_settings);
  if (!path.isEmpty())
    writeScene(path);
}

void SavingDesk::writeSession(const QString& path) {
  SessionDocument session = m_session();
  const std::filesystem::path target(path.toStdString());
  session.scene.volume = volumeSeenFrom(target);
  session.scene.keep.labels = labelsSeenFrom(target);
  const auto write = [&] {
    writeFileAtomically(target, sessionToJson(session));
    m_document.settleIn(path, m_session());
    emit sessionSaved();
  };
  m_notes.attempt(write, path);
}

void SavingDesk::writeScene(const QString& path) {
  const std::filesystem::path target(path.toStdString());
  Scene scene = m_document.scene();
  scene.keep.source = labelsSeenFrom(target);
  m_notes.attempt([&] { writeFileAtomically(target, sceneToJson(scene, volumeSeenFrom(target))); }, path);
}

void SavingDesk::writePicture(const QString& path) {
  const std::optional<Image> left = m_view.restingImage(0);
  if (!left) {
    m_notes.sayFailure(tr("The picture is not complete yet; save it again once it is."));
    return;
  }
  const CompareLayout layout = m_view.compareLayout();
  const std::optional<Image> right = pictureCount(layout) == 2 ? m_view.restingImage(1) : std::nullopt;
  Scene scene = m_view.sceneOfRestingImage(m_view.ownSide());
  scene.keep.source = labelsInPicture();
  const auto write = [&] {
    const glm::dvec3& background = m_document.scene().image.background;
    writeImage(path.toStdString(),
               right ? comparedPicture(*left, *right, layout, m_view.wipePosition(), background) : *left,
               background, sceneToJson(scene, volumeInPicture()));
  };
  m_notes.attempt(write, path);
}

std::string SavingDesk::volumeInPicture() const {
  return volumeSeenFrom(std::filesystem::path(m_document.volumePath()).parent_path() / "picture");
}

std::string SavingDesk::labelsInPicture() const {
  return labelsSeenFrom(std::filesystem::path(m_document.volumePath()).parent_path() / "picture");
}

// How a file at this place names the volume and the label map. A relative path survives moving both together;
// one that may name the patient is kept in the settings, and the file gets a name that stands for it.
std::string SavingDesk::seenFrom(const std::filesystem::path& file, const std::filesystem::path& named,
                                 const std::string& kind) const {
  if (!named.is_absolute())
    return named.string();
  std::string relative = named.lexically_relative(std::filesystem::absolute(file).parent_path()).string();
  const Volume& shown = *m_document.scene().volume;
  if (!pathMayNameThePatient(QString::fromStdString(relative), shown.info().patient))
    return relative;
  return m_settings.referenceTo(named.string(), kind);
}

std::string SavingDesk::volumeSeenFrom(const std::filesystem::path& file) const {
  return seenFrom(file, m_document.volumePath(), plainFileName(*m_document.scene().volume).toStdString());
}

std::string SavingDesk::labelsSeenFrom(const std::filesystem::path& file) const {
  return seenFrom(file, m_document.scene().keep.source, "labels");
}

} // namespace limn
