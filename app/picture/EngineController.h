// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/EngineChoice.h"
#include "scene/Scene.h"
#include "widgets/controls/BackgroundWork.h"
#include "widgets/view/pictures/PictureState.h"

#include <QObject>

class QActionGroup;

namespace limn {

struct WindowContext;

/// Which engine draws the window: the one chosen in the menu or, where that is left open, the faster. Which
/// that is is tried once for each driver and processor, beside the event loop, when the first picture rests.
class EngineController : public QObject {
  Q_OBJECT

public:
  explicit EngineController(WindowContext& context);

  /// Lets an engine draw from now on, in this run and later ones.
  void choose(std::optional<Engine> setting);

private:
  void addActions();
  void apply();
  void showInMenu();
  void lookAt(const PictureState& state);
  void tryBoth();
  void noteTrial(const std::string& renderer, const EngineTimes& times);

  WindowContext& m_context;
  QActionGroup* m_engines; ///< data: the engine's name, or "auto"
  std::optional<Engine> m_setting;
  bool m_isTried = false;
  BackgroundWork m_trial;
};

} // namespace limn
