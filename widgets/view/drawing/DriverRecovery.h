// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QSurfaceFormat>

#include <functional>

namespace limn {

/// The OpenGL surface the views ask for: 3.1 with the deprecated functions, which drivers answer with a
/// compatibility profile (asking for 3.0 gives Mesa's core profile, which need not accept GLSL 1.30); no
/// depth buffer, no multisampling. The program may also make it the default format before its first window.
QSurfaceFormat limnSurfaceFormat();

/// What this computer offers the windows of the program.
struct OpenGlOffer {
  QString problem;  ///< one sentence where there is no OpenGL 3.0; empty where there is
  QString renderer; ///< the driver's name of what draws
};

/// Tries, on the thread of the windows. Ask before making a view that draws with OpenGL: a window with a
/// QOpenGLWidget crashes inside Qt where no context can be made.
OpenGlOffer openGlOffer();

/// What happens when drawing fails. Where the graphics driver is to blame, everything in it is made anew;
/// when that has failed too often in a row, it is given up. Anything else is said.
/// Knows no window: what is to be done there it asks for through its signals, which but for `stopped` come in
/// turns of the event loop of their own.
class DriverRecovery : public QObject {
  Q_OBJECT

public:
  /// Failures of the driver in a row before it is given up.
  static constexpr int mostFailures = 3;

  using QObject::QObject;

  /// Does work with the OpenGL context current, lost or not; catches what it throws and asks the driver
  /// whether it is well.
  void guard(const std::function<void()>& work);

  /// The driver cannot be used at all.
  void giveUp(const QString& sentence);

  /// Drawing failed, and trying again would help nothing.
  void fail(const QString& sentence);

  /// Why nothing can be drawn; empty while drawing works.
  const QString& sentence() const { return m_sentence; }
  const QString& details() const { return m_details; } ///< what the driver wrote
  bool hasFailed() const { return !m_sentence.isEmpty(); }

  /// Drawing may be tried again; failures go on being counted.
  void retry() { m_sentence.clear(); }
  /// The same, as if nothing had ever failed.
  void forget();
  /// Pictures are complete: what failed before works.
  void noteSuccess();

signals:
  void stopped();                  ///< nothing must be drawn until it is told to
  void rebuildNeeded(bool isLost); ///< of the pictures, and of the context where that `isLost`
  void givenUp();                  ///< the driver, for the reason in `sentence`
  /// The driver cannot draw the scene, as `sentence` says; `isVolume`: nor any other of its volume.
  void beyondDriver(bool isVolume);
  void failed(const QString& sentence);
  void restored(const QString& sentence);

private:
  void failDriver(const QString& sentence, const QString& details);

  QString m_sentence;
  QString m_details;
  int m_failures = 0; ///< of the driver, in a row
};

} // namespace limn
