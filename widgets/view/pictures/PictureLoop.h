// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/effects/EffectTimes.h"
#include "widgets/view/pictures/InteractionQuality.h"
#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/pictures/Pictures.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace limn {

/// The pictures to draw, and what is seen of them.
struct PictureRequest {
  std::vector<Scene> scenes;   ///< one or two
  glm::ivec2 size{0};          ///< of each picture, pixels; nothing is drawn where it is 0
  std::array<Columns, 2> seen; ///< of each picture, while something moves
  double seenShare = 1.0;      ///< of all pixels, then
  QString lastName;            ///< what the last picture is called
};

using MakePictures = std::function<std::unique_ptr<Pictures>()>;

/// What the pictures need of those who own their thread, and the OpenGL context current there, if any.
struct PictureContext {
  using Work = std::function<void()>;
  std::function<bool()> canDraw; ///< seen, something to show, and nothing has failed
  std::function<void()> makeCurrent;
  std::function<void()> doneCurrent;
  std::function<void(const Work&)> guard; ///< does the work; where it fails, that is theirs to mend
  std::function<bool()> isCancelled;      ///< asked while a volume is got ready; may be empty
};

/// How pictures share the turns of their event loop with others.
struct PicturePace {
  int idleMs = 150;           ///< from the last coarse picture to the first strip
  double budgetMs = 30.0;     ///< of drawing in one turn
  double restBudgetMs = 20.0; ///< of drawing what nobody waits for
  int tellMs = 500;           ///< from the beginning of work that is told of, if it is not done before
};

/// Brings pictures from coarse to exact, a piece in each turn of the event loop: a coarse picture at once,
/// strips once nothing moves, and at rest what makes the next movement quick, estimates of the error and
/// smaller steps. Any change starts it anew.
class PictureLoop : public QObject {
  Q_OBJECT

public:
  PictureLoop(MakePictures makePictures, PictureContext context, PicturePace pace = {},
              QObject* parent = nullptr);

  /// Something else is to be shown: what was drawn is stale. Until `drawIfStale` nothing is drawn.
  void restart();
  /// Draws coarsely where that is due, making the pictures first where there are none. Called inside
  /// `guard`, with the context current. A large volume is first got ready, a piece a turn. Throws Error.
  void drawIfStale(const PictureRequest& request);
  /// Goes on with what is done at rest, after it paused unseen.
  void resume() { m_restTimer.start(0); }
  /// Does nothing more until the next picture is drawn.
  void stop();
  /// Drops the pictures; an OpenGL context that they live in is current; where it `isLost`, they died with
  /// it.
  void release(bool isLost);
  /// There is nothing to tell the effects of.
  void forgetEffects();
  /// Another volume: nothing that was told holds any more.
  void forget();
  /// Another kind of picture: what was measured of the last tells nothing.
  void forgetSpeed() { m_quality.forget(); }
  /// Notes that what is drawn was shown.
  void noteShown() { m_sinceShown.start(); }

  /// Measures at rest what the effects of the last picture cost.
  void measureEffects();

  void setRefines(bool refines);
  bool refines() const { return m_refines; }
  /// The drawing time of a frame aimed at while something moves, ms, > 0.
  void setMovingMs(double ms) { m_quality.setTargetMs(ms); }
  double movingMs() const { return m_quality.targetMs(); }

  /// A volume is being got ready: what pictures there are show another one.
  bool isPreparing() const { return m_sincePreparing.isValid(); }

  Pictures* pictures() { return m_pictures.get(); } ///< null while there is nothing to show
  const PictureState& state() const { return m_state; }
  const SidePicture* resting(int side) const; ///< null before it is complete
  /// The gradient moduli with which a side was lit; empty before it was drawn.
  GradientScale gradientScaleOf(int side) const;
  /// Whether the pictures rest and all that is done at rest is done.
  bool isIdle() const { return m_state.resting && !m_restTimer.isActive() && !m_probeTimer.isActive(); }

signals:
  void stateChanged(const limn::PictureState& state);
  /// What the last picture, called `picture`, calls for.
  void effectsChanged(const std::vector<limn::EffectRow>& rows, const QString& picture);
  void timesChanged(const limn::EffectTimes& times);
  /// How far a volume is got ready, 0..1, where that takes long; 1 once it is or something else is wanted.
  void preparing(double fraction);
  void showNeeded();
  /// Every picture is complete at its scene's step.
  void completed();
  /// Something that is done at rest failed; the pictures stay.
  void restFailed(const QString& sentence);

private:
  bool makeReady(const Scene& scene);
  void tellPreparing(double fraction);
  void endPreparing();
  void drawCoarsely(const PictureRequest& request);
  void requireVolume() const;
  void refine();
  void updateState();
  void probeError();
  void workAtRest();
  RestTurn restTurn();
  bool isDriverLost();
  void tellEffects(const std::vector<EffectRow>& rows, const QString& picture);
  void showTimes(const EffectTimes& times);

  MakePictures m_makePictures;
  PictureContext m_context;
  PicturePace m_pace;
  std::unique_ptr<Pictures> m_pictures;
  std::weak_ptr<const Volume> m_volume; ///< that is drawn
  InteractionQuality m_quality;
  bool m_isStale = true; ///< something changed since the last coarse picture
  bool m_refines = true;
  QTimer m_idleTimer; ///< from the last coarse picture to the first strip
  QTimer m_refineTimer;
  QTimer m_restTimer;
  QTimer m_probeTimer; ///< from a coarse picture to the measure of its error
  QElapsedTimer m_sinceShown;
  QElapsedTimer m_sincePreparing; ///< valid while a volume is being got ready
  QElapsedTimer m_sinceTold;      ///< how far that is; valid once it was
  PictureState m_state;
  std::vector<EffectRow> m_effects; ///< as told last
  QString m_effectsPicture;
  EffectTimes m_times;
};

} // namespace limn
