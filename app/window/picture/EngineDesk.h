// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engines/EngineChoice.h"
#include "scene/Scene.h"
#include "widgets/view/SurfaceFormat.h"
#include "widgets/view/pictures/PictureState.h"

#include <QObject>
#include <QThreadPool>

#include <atomic>

class QActionGroup;

namespace limn {

class CompareView;
class Settings;
struct MakingOptions;

/// The engine that draws at first. Throws Error (usage) as makeCpuEngine does.
EngineChoice firstEngine(Settings& settings, const OpenGlOffer& openGl);

/// Pictures for files are drawn by whoever draws the window.
MakingOptions drawnLike(const CompareView& view);

/// Which engine draws the window: the one chosen in the menu or, where that is left open, the faster. Which
/// that is is tried once for each driver and processor, beside the event loop, when the first picture rests.
class EngineDesk : public QObject {
  Q_OBJECT

public:
  struct Parts {
    CompareView& view;
    Settings& settings;
    QActionGroup& engines; ///< data: EngineSetting as int
    OpenGlOffer openGl;
  };
  EngineDesk(Parts parts, QObject* parent);
  ~EngineDesk() override;

  /// Lets an engine draw from now on, in this run and later ones.
  void choose(EngineSetting setting);

private:
  EngineFacts facts() const;
  void apply();
  void showInMenu();
  void lookAt(const PictureState& state);
  void tryBoth();
  void noteTrial(const std::string& renderer, const EngineTimes& times);

  Parts m_parts;
  EngineSetting m_setting;
  bool m_isTried = false;
  std::atomic<bool> m_isCancelled = false;
  QThreadPool m_pool;
};

} // namespace limn
