// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/saving/PictureDialog.h"
#include "io/scenefile/SessionFile.h"
#include "scene/basics/Image.h"
#include "scene/view/CompareLayout.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/controls/TimeLeft.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <vector>

class QLabel;
class QToolButton;

namespace limn {

struct WindowContext;

/// What a picture shows, from left to right.
struct PictureContent {
  std::vector<Scene> scenes;
  CompareLayout layout = CompareLayout::single;
  bool operator==(const PictureContent&) const = default;
};

/// A picture that is saved once it is complete, if it is still the one that was asked for.
class AwaitedPicture {
public:
  void await(const QString& path, const PictureContent& asked, const PictureOptions& options = {}) {
    m_path = path;
    m_asked = asked;
    m_options = options;
  }
  void forget() { m_path.clear(); }

  /// Where it is to be saved; empty while none is awaited.
  const QString& path() const { return m_path; }
  /// How it is to be saved.
  const PictureOptions& options() const { return m_options; }

  enum class Outcome { waits, complete, changed };

  /// What has become of it, while one is awaited; it is forgotten unless it waits on. `isComplete` is asked
  /// only of the picture that was asked for.
  Outcome look(const PictureContent& now, const std::function<bool()>& isComplete) {
    const Outcome outcome = now != m_asked ? Outcome::changed
                            : isComplete() ? Outcome::complete
                                           : Outcome::waits;
    if (outcome != Outcome::waits)
      forget();
    return outcome;
  }

private:
  QString m_path;
  PictureContent m_asked;
  PictureOptions m_options;
};

/// Asks how and where a view's picture is to be saved and waits until it is complete; meanwhile a row of the
/// status bar says so and offers to cancel.
class PictureSaving : public QObject {
  Q_OBJECT

public:
  /// The row stands in the status bar, where it takes nothing from the picture: that would begin anew in
  /// another size.
  explicit PictureSaving(WindowContext& context);

  /// Says in the status bar that a picture is drawn into its file, and takes no other meanwhile; empty: none
  /// is.
  void sayDrawing(const QString& text);

  /// What is waited for or being drawn, as the row says it; empty where nothing is.
  QString underWay() const;

signals:
  /// Somebody wants to set how far saved pictures of physical light are drawn.
  void pathsWanted();
  /// The picture at rest is the one that was asked for.
  void complete(const QString& path, const limn::PictureOptions& options);
  void cancelled();

private:
  void ask();
  void look();
  void forget();
  void say(const QString& text);
  PictureContent content() const;
  DrawingTold told(const std::vector<Scene>& asked);

  WindowContext& m_context;
  AwaitedPicture m_awaited;
  QLabel* m_text;
  QToolButton* m_stop;
  bool m_isDrawing = false;
};

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
  void cancelPicture();

  /// How a picture that may travel calls the volume and a file of labels: without folders.
  std::string volumeInPicture() const;
  std::string labelsInPicture(const std::string& labels) const;

signals:
  void sessionSaved();
  /// A picture is being drawn for a file; empty: no longer.
  void drawing(const QString& sentence);

private:
  struct PictureFile;
  void drawPicture(const PictureFile& file, const std::vector<Scene>& scenes, const glm::ivec2& size);
  /// Writes a drawn picture, on the thread of work, and returns how that is told. One that `isOffered` could
  /// not be written before.
  BackgroundWork::Deliver written(const PictureFile& file,
                                  const std::shared_ptr<const std::vector<Image>>& sides, bool isOffered);
  /// Says that a drawn picture could not be written, and saves it elsewhere where that is wanted.
  void offerElsewhere(const PictureFile& file, const std::shared_ptr<const std::vector<Image>>& sides,
                      const QString& sentence);
  void sayGround(const QString& path, const PictureOptions& options);
  std::string seenFrom(const std::filesystem::path& file, const std::filesystem::path& named,
                       const std::string& kind) const;
  std::string volumeSeenFrom(const std::filesystem::path& file) const;
  std::string labelsSeenFrom(const std::filesystem::path& file, const std::string& labels) const;

  WindowContext& m_context;
  std::function<SessionDocument()> m_session;
  std::atomic<bool> m_isWriting{false}; ///< the file of what was drawn
  BackgroundWork m_drawing;             ///< of a picture that is larger than the one on screen
  QString m_drawn;                      ///< what is said of it
  TimeLeft m_left;                      ///< of it
};

} // namespace limn
