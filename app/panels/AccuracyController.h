// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/Tolerance.h"
#include "accuracy/sweep/ConvergedPicture.h"
#include "app/core/drawing/RealRenderers.h"
#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace limn {

class AccuracyPanel;
class ErrorMapOverlay;
struct PictureState;
struct WindowContext;

/// Measures error and time of scenes, where they differ from the exact picture and what steps keep a
/// tolerance, on a worker thread, with OpenGL in a context of its own or on the processor. One piece of work
/// at a time: new work ends what runs. Signals come on the thread the measurer lives in; of ended work
/// nothing more is told.
class AccuracyMeasurer : public QObject {
  Q_OBJECT

public:
  /// The exact picture that was drawn last: both kinds of work need it, and it takes the most time.
  struct Exact {
    Scene scene;
    glm::ivec2 size{0};
    ConvergedPicture picture;
  };

  explicit AccuracyMeasurer(QObject* parent = nullptr);

  /// Which engine draws in work that is begun from now on; OpenGL at first.
  void setRays(Engine rays) { m_rays = rays; }

  /// Measures the points that the window offers for a scene, which people call `name`.
  void measure(const QString& name, const Scene& scene, const glm::ivec2& size);

  /// Compares the picture of a scene with the exact one.
  void compare(const Scene& scene, const glm::ivec2& size);

  /// Finds the steps with which pictures of `size` keep the tolerance of their scenes (accuracy/Tolerance);
  /// the scenes differ in their light, and what is told is the one that needs the finest steps.
  void findSteps(const std::vector<Scene>& scenes, const glm::ivec2& size);

  void cancel() { m_work.cancel(); }
  bool isBusy() const { return m_work.isRunning(); }

  /// Lets go of what is kept of any other volume.
  void forgetOthersThan(const std::shared_ptr<const Volume>& volume);

  const std::shared_ptr<const Exact>& exact() const { return m_exact; }
  void setExact(const std::shared_ptr<const Exact>& exact) { m_exact = exact; }

signals:
  void progressed(double fraction, const QString& doing);
  void measured(const limn::MeasuredAccuracy& accuracy);
  void compared(const limn::ComparedPicture& picture);
  void stepsFound(const limn::WithinTolerance& found);
  void failed(const QString& sentence);

private:
  class Job;

  void start(std::function<BackgroundWork::Deliver(Job& job)> task);

  Engine m_rays = Engine::rayCaster;
  std::shared_ptr<const Exact> m_exact;
  BackgroundWork m_work;
};

enum class AccuracyWork;

/// Measures on request how close the picture is to the exact one and what that costs, finds steps for a
/// tolerance, shows a map of errors, and saves what was measured. Of two pictures it is about the right one.
class AccuracyController : public QObject {
  Q_OBJECT

public:
  explicit AccuracyController(WindowContext& context);

  /// Shows the accuracy of the scene on screen; takes back the map of another one.
  void showScene();

  /// Whether it measures, compares or looks for steps.
  bool isBusy() const { return m_measurer.isBusy(); }

  /// Writes what was measured: a chart (.png), a table (.csv) or a page with both (.html), by the name.
  void write(const QString& path);

  /// What was measured, for a window that takes this one's place. The map stays where the picture has the
  /// same size there.
  struct Memory {
    std::shared_ptr<const AccuracyMeasurer::Exact> exact;
    std::optional<MeasuredAccuracy> measured; ///< as measured
    Scene compared;
    glm::ivec2 comparedSize{0};
    std::optional<ComparedPicture> map;
  };
  Memory memory() const;
  /// Of the same scene, which is shown already.
  void takeOver(const Memory& memory);

private:
  void addRefinement();
  void connectPanel();
  void connectMeasurer();
  AccuracyMeasurer& measurer();
  void measure();
  void findSteps(const Quality& quality, const Gesture& gesture);
  void useSteps(const WithinTolerance& found);
  void showMeasured(const MeasuredAccuracy& measured);
  void showMap(bool shown);
  void takeMapBack();
  /// The same where nobody asked for that: what was under way is said to have ended.
  void endMap();
  void showCompared(const ComparedPicture& picture);
  void setWork(AccuracyWork work);
  void save();
  void showOnScreen(const PictureState& state);
  int measuredSide() const;
  glm::ivec2 shownSize() const;
  glm::ivec2 measuredSize() const;

  WindowContext& m_context;
  AccuracyPanel& m_panel;
  AccuracyMeasurer m_measurer;
  ErrorMapOverlay* m_map;
  bool m_pausesRefinement = false;          ///< something is measured
  std::optional<AccuracyReport> m_measured; ///< as measured: what is saved
  QString m_warned;                         ///< that a tolerance cannot be kept
  Gesture m_toleranceGesture;               ///< for which steps are looked for
  Scene m_compared;                         ///< of which the map is shown or under way
  glm::ivec2 m_comparedSize{0};             ///< pixels, of its picture
  std::optional<ComparedPicture> m_mapped;  ///< what the map shows
};

} // namespace limn
