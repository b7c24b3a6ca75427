// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture/EngineDesk.h"

#include "app/Settings.h"
#include "app/engines/EngineTrial.h"
#include "app/engines/PictureMaker.h"
#include "widgets/Translated.h"
#include "widgets/view/CompareView.h"

#include <QActionGroup>

namespace limn {
namespace {

// A trial holds the volume once more, on the graphics card.
constexpr std::size_t mostVoxelsTried = std::size_t{1} << 27;

EngineFacts factsOf(EngineSetting setting, Settings& settings, const OpenGlOffer& openGl) {
  EngineFacts facts{setting, openGl.problem.toStdString(), openGl.renderer.toStdString(), std::nullopt};
  const std::string machine = machineWith(facts.renderer);
  if (facts.problem.empty() && setting == EngineSetting::automatic)
    facts.times = settings.engineMemory().recall(machine);
  return facts;
}

ViewEngine engineOf(const EngineChoice& choice) {
  return choice.isProcessor ? ViewEngine::processor : ViewEngine::driver;
}

} // namespace

EngineChoice firstEngine(Settings& settings, const OpenGlOffer& openGl) {
  return chosenEngine(factsOf(settings.engine(), settings, openGl));
}

MakingOptions drawnLike(const CompareView& view) {
  MakingOptions order;
  order.engine = view.engine() == ViewEngine::processor ? PictureEngine::cpu : PictureEngine::gl;
  return order;
}

EngineDesk::EngineDesk(Parts parts, QObject* parent)
    : QObject(parent), m_parts(std::move(parts)), m_setting(m_parts.settings.engine()) {
  m_pool.setMaxThreadCount(1);
  for (QAction* action : m_parts.engines.actions())
    connect(action, &QAction::triggered, this,
            [this, action] { choose(static_cast<EngineSetting>(action->data().toInt())); });
  connect(&m_parts.view, &CompareView::pictureStateChanged, this, &EngineDesk::lookAt);
  connect(&m_parts.view, &CompareView::engineChanged, this, &EngineDesk::showInMenu);
  apply();
}

EngineDesk::~EngineDesk() {
  m_isCancelled = true;
  m_pool.waitForDone();
}

EngineFacts EngineDesk::facts() const {
  return factsOf(m_setting, m_parts.settings, m_parts.openGl);
}

void EngineDesk::choose(EngineSetting setting) {
  m_setting = setting;
  m_parts.settings.setEngine(setting);
  apply();
}

void EngineDesk::apply() {
  const EngineChoice choice = chosenEngine(facts());
  m_parts.view.setEngine(engineOf(choice), translated(choice.reason));
  showInMenu();
}

// The entry that is chosen says what it came to, and why; one that cannot be had says why not.
void EngineDesk::showInMenu() {
  const PictureState state = m_parts.view.pictureState();
  const bool hasOpenGl = m_parts.openGl.problem.isEmpty();
  const QString inUse = m_parts.view.engine() == ViewEngine::driver ? tr("OpenGL") : tr("processor");
  for (QAction* action : m_parts.engines.actions()) {
    const auto setting = static_cast<EngineSetting>(action->data().toInt());
    action->setChecked(setting == m_setting);
    if (setting == EngineSetting::automatic) {
      action->setText(m_setting == setting ? tr("&Automatic: %1").arg(inUse) : tr("&Automatic"));
      action->setToolTip(m_setting == setting ? state.engineReason
                                              : tr("Draws with the engine that is faster on this computer."));
    }
    if (setting == EngineSetting::openGl) {
      action->setEnabled(hasOpenGl);
      action->setText(hasOpenGl ? tr("&OpenGL") : tr("&OpenGL (not on this computer)"));
      action->setToolTip(hasOpenGl ? m_parts.openGl.renderer : m_parts.openGl.problem);
    }
  }
}

// The first picture does not wait.
void EngineDesk::lookAt(const PictureState& state) {
  const Scene& scene = m_parts.view.scene();
  if (state.resting && !m_isTried && scene.volume && !scene.volume->room() &&
      scene.volume->voxelCount() <= mostVoxelsTried && chosenEngine(facts()).isGuess)
    tryBoth();
}

void EngineDesk::tryBoth() {
  m_isTried = true;
  m_pool.start([this, scene = m_parts.view.scene()] {
    try {
      const EngineTrial trial = tryEngines(scene, [this] { return m_isCancelled.load(); });
      QMetaObject::invokeMethod(this, [this, trial] { noteTrial(trial.renderer, trial.times); });
    } catch (const std::exception&) {
      // Then it stays a guess: whoever draws the window finds out what the driver cannot, and says so.
    }
  });
}

// Another driver than the window's tells nothing of it.
void EngineDesk::noteTrial(const std::string& renderer, const EngineTimes& times) {
  if (QString::fromStdString(renderer) != m_parts.openGl.renderer)
    return;
  m_parts.settings.engineMemory().remember(machineWith(renderer), times);
  if (!m_parts.view.pictureState().driverHasFailed)
    apply();
}

} // namespace limn
