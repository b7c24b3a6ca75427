// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/panels/AccuracyMeasurer.h"
#include "scene/Scene.h"
#include "widgets/Gesture.h"

namespace limn {

class AccuracyPanel;
class ErrorMapOverlay;
struct PictureState;
struct WindowContext;
enum class AccuracyWork;

/// Measures on request how close the picture is to the exact one and what that costs, finds steps for a
/// tolerance, shows a map of errors, and saves what was measured. Of two pictures it is about the right one.
class AccuracyController : public QObject {
  Q_OBJECT

public:
  explicit AccuracyController(WindowContext& context);

  /// Shows the accuracy of the scene on screen; takes back the map of another one.
  void showScene();

  /// Writes what was measured: a chart (.png), a table (.csv) or a page with both (.html), by the name.
  void write(const QString& path);

private:
  void addRefinement();
  void connectPanel();
  void connectMeasurer();
  AccuracyMeasurer& measurer();
  void measure();
  void findSteps(const Quality& quality, const Gesture& gesture);
  void useSteps(const WithinTolerance& found);
  void showMap(bool shown);
  void takeMapBack();
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
  std::optional<AccuracyReport> m_measured; ///< as measured: what is saved
  Gesture m_toleranceGesture;               ///< for which steps are looked for
  Scene m_compared;                         ///< of which the map is shown or under way
};

} // namespace limn
