// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QObject>

#include <functional>

class QWidget;

namespace limn {

class CompareView;
class OpenDocument;
class SaveNotes;
class Settings;

/// Writes what is open as session, scene and picture.
class SavingDesk : public QObject {
  Q_OBJECT

public:
  /// `session` tells the session of the moment. Dialogs stand over `window`.
  SavingDesk(OpenDocument& document, CompareView& view, Settings& settings, SaveNotes& notes,
             std::function<SessionDocument()> session, QWidget& window);

  /// Saves to the session's file, or asks for one where there is none yet.
  void saveSession();
  void saveSessionAs();
  void saveScene();

  /// What the above do once a name is chosen. The picture is the one at rest.
  void writeSession(const QString& path);
  void writeScene(const QString& path);
  void writePicture(const QString& path);

  /// How a picture that may travel calls the volume and the label map: without folders.
  std::string volumeInPicture() const;
  std::string labelsInPicture() const;

signals:
  void sessionSaved();

private:
  std::string seenFrom(const std::filesystem::path& file, const std::filesystem::path& named,
                       const std::string& kind) const;
  std::string volumeSeenFrom(const std::filesystem::path& file) const;
  std::string labelsSeenFrom(const std::filesystem::path& file) const; ///< empty where there are none

  OpenDocument& m_document;
  CompareView& m_view;
  Settings& m_settings;
  SaveNotes& m_notes;
  std::function<SessionDocument()> m_session;
  QWidget& m_window;
};

} // namespace limn
