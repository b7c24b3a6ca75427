// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/saving/PictureDialog.h"
#include "io/scenefile/SessionFile.h"
#include "scene/basics/Image.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/controls/TimeLeft.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace limn {

struct WindowContext;

/// Writes what is open as session, scene and picture.
class SavingController : public QObject {
  Q_OBJECT

public:
  /// `session` tells the session of the moment.
  SavingController(WindowContext& context, std::function<SessionDocument()> session);

  /// Saves to the session's file, or asks for one where there is none yet.
  void saveSession();
  void saveSessionAs();
  void saveScene();

  /// What the above do once a name is chosen. The picture is the one at rest.
  void writeSession(const QString& path);
  void writeScene(const QString& path);
  /// A larger one is drawn beside the event loop.
  void writePicture(const QString& path, const PictureOptions& options = {
                                             .ground = PictureOptions::Ground::shown, .marks = noMarks});
  /// Ends what is drawn for a file, unless the file is being written already.
  void cancelPicture();

  /// The names of pictures that were drawn and are in no file yet, the one that failed last first.
  QStringList unwritten() const;

  /// Of those the latest are kept whose pixels take so many bytes together, at first 1 GiB; the latest in any
  /// case.
  void setMostKept(std::size_t bytes) { m_mostKept = bytes; }

  /// How a picture that may travel calls the volume and a file of labels: without folders.
  std::string volumeInPicture() const;
  std::string labelsInPicture(const std::string& labels) const;

signals:
  void sessionSaved();
  /// A picture is being drawn for a file; empty: no longer.
  void drawing(const QString& sentence);

private:
  void askForSession(const QString& suggested);
  struct Arrangement;
  struct PictureFile;
  struct Unwritten;
  void drawPicture(const PictureFile& file, const SceneDocument& document, const Arrangement& arrangement,
                   const std::vector<Scene>& scenes, const glm::ivec2& size);
  /// Writes a drawn picture, on the thread of work, and returns how that is told. One that is `offered` could
  /// not be written before.
  BackgroundWork::Deliver written(const PictureFile& file, const std::shared_ptr<const Image>& image,
                                  const std::shared_ptr<const Unwritten>& offered);
  /// Keeps no more of what could not be written than has room, and says what is lost.
  void giveUpOldest();
  /// Says of the picture that failed last that it could not be written, and offers to save it elsewhere.
  void offerElsewhere();
  void saveElsewhere(const std::shared_ptr<const Unwritten>& offered);
  void sayGround(const QString& path, const PictureOptions& options);
  std::string seenFrom(const std::filesystem::path& file, const std::filesystem::path& named,
                       const std::string& kind) const;
  std::string volumeSeenFrom(const std::filesystem::path& file) const;
  std::string labelsSeenFrom(const std::filesystem::path& file, const std::string& labels) const;

  WindowContext& m_context;
  std::function<SessionDocument()> m_session;
  std::atomic<bool> m_isWriting{false}; ///< the file of what was drawn, or will at once
  BackgroundWork m_drawing;             ///< of a picture that is larger than the one on screen
  QString m_drawn;                      ///< what is said of it
  TimeLeft m_left;                      ///< of it
  std::vector<std::shared_ptr<const Unwritten>> m_unwritten; ///< until saved or dismissed, the latest last
  std::size_t m_mostKept = std::size_t{1} << 30;             ///< of them, bytes
};

} // namespace limn
