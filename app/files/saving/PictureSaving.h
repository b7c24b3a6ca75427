// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/saving/PictureDialog.h"
#include "scene/Scene.h"
#include "scene/view/CompareLayout.h"

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QToolButton;

namespace limn {

struct PictureState;
struct WindowContext;

/// Asks where a picture of the window is to be saved; empty where nobody wants to.
QString askForPicturePlace(WindowContext& context);

/// Why no other picture is taken while one is drawn into its file.
QString anotherIsDrawn();

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

/// Asks how and where a view's picture is to be saved and waits until it is the one that stays on screen;
/// meanwhile a row of the status bar says so, and how far it is, and offers to cancel.
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
  bool isFinished(const PictureState& state) const;
  QString waitingText(const QString& file) const;
  PictureContent content() const;
  DrawingTold told(const std::vector<Scene>& asked);

  WindowContext& m_context;
  AwaitedPicture m_awaited;
  QLabel* m_text;
  QToolButton* m_stop;
  bool m_isDrawing = false;
};

} // namespace limn
