// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/pictures/Pictures.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <vector>

namespace limn {

using MakePictures = std::function<std::unique_ptr<Pictures>()>;

/// What the pictures need of those who own their thread, and the OpenGL context current there, if any.
struct PictureContext {
  using Work = std::function<void()>;
  std::function<void()> makeCurrent;
  std::function<void()> doneCurrent;
  /// Does the work; where it fails, that is theirs to mend, and what is to be drawn is no longer seen.
  std::function<void(const Work&)> guard;
  std::function<bool()> isCancelled; ///< asked while a volume is got ready; may be empty
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

  /// What is to be drawn from now on; an equal order changes nothing. What was drawn of another one is stale,
  /// but until `drawIfStale` nothing is drawn.
  void show(const PictureOrder& order);
  const PictureOrder& order() const { return m_order; }
  /// Draws coarsely where that is due, making the pictures first where there are none. Called inside
  /// `guard`, with the context current. A large volume is first got ready, a piece a turn. Throws Error.
  void drawIfStale();
  /// Does nothing more until another order.
  void stop();
  /// Drops the pictures; an OpenGL context that they live in is current; where it `isLost`, they died with
  /// it.
  void release(bool isLost);
  /// Another kind of picture: what was measured of the last tells nothing.
  void forgetSpeed() { m_quality.forget(); }
  /// Notes that what is drawn was shown.
  void noteShown() { m_sinceShown.start(); }

  /// Measures at rest what the effects of the last picture cost, or no longer.
  void measureEffects(bool measures = true);

  /// A volume is being got ready: what pictures there are show another one.
  bool isPreparing() const { return m_sincePreparing.isValid(); }

  Pictures* pictures() { return m_pictures.get(); } ///< null while there is nothing to show
  const ViewNews& news() const { return m_news; }
  const PictureState& state() const { return m_news.state; }
  const SidePicture* resting(int side) const; ///< null before it is complete
  /// The gradient moduli with which a side was lit; empty before it was drawn.
  GradientScale gradientScaleOf(int side) const;
  /// Whether the pictures rest and all that is done at rest is done.
  bool isIdle() const { return state().resting && !m_restTimer.isActive() && !m_probeTimer.isActive(); }

signals:
  void told(const limn::ViewNews& news); ///< whenever anything in it changes; perhaps while painting
  void showNeeded();

private:
  template <class T>
  void tell(T& news, T value);
  void restart();
  bool makeReady(const Scene& scene);
  void tellPreparing(double fraction);
  void endPreparing();
  void drawCoarsely();
  void awaitLight();
  void requireVolume() const;
  void refine();
  void updateState();
  void probeError();
  void workAtRest();
  RestTurn restTurn();
  void judgeWhatIsShown();
  bool isDriverLost();
  void tellEffects(std::vector<EffectRow> rows);

  MakePictures m_makePictures;
  PictureContext m_context;
  PicturePace m_pace;
  PictureOrder m_order;
  ViewNews m_news;
  std::unique_ptr<Pictures> m_pictures;
  std::weak_ptr<const Volume> m_volume; ///< that is drawn
  InteractionQuality m_quality;
  bool m_isStale = true; ///< something changed since the last coarse picture
  QTimer m_idleTimer;    ///< from the last coarse picture to the first strip
  QTimer m_refineTimer;
  QTimer m_restTimer;
  QTimer m_lightTimer; ///< until the light of a coarse picture is found
  QTimer m_probeTimer; ///< from a coarse picture to the measure of its error
  QElapsedTimer m_sinceShown;
  QElapsedTimer m_sinceJudged;    ///< a picture that gets more paths; valid once one was
  double m_judgedInMs = 0.0;      ///< what that took
  QElapsedTimer m_sincePreparing; ///< valid while a volume is being got ready
  QElapsedTimer m_sinceTold;      ///< how far that is; valid once it was
};

} // namespace limn
