// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/EngineController.h"

#include "app/core/drawing/EngineChoice.h"
#include "app/window/WindowContext.h"
#include "widgets/Translated.h"
#include "widgets/view/CompareView.h"

#include <QActionGroup>

namespace limn {
namespace {

// A trial holds the volume once more, on the graphics card.
constexpr std::size_t mostVoxelsTried = std::size_t{1} << 27;

std::optional<Engine> engineOf(const QAction& action) {
  return engineNamed(action.data().toString().toStdString());
}

} // namespace

EngineController::EngineController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_engines(context.actions.addGroup()),
      m_setting(context.settings.engine()) {
  addActions();
  connect(&context.view, &CompareView::told, this, [this](const ViewNews& news) {
    lookAt(news.state);
    showInMenu();
  });
  apply();
}

void EngineController::addActions() {
  const auto add = [this](std::optional<Engine> setting, const QString& text, const QString& tip) {
    const QLatin1String name(nameOf(setting));
    QAction* action = m_context.actions.addChoice(*m_engines, QStringLiteral("engine-") + name, name,
                                                  {.text = text, .toolTip = tip});
    connect(action, &QAction::triggered, this, [this, setting] { choose(setting); });
  };
  add(std::nullopt, tr("&Automatic"), {});
  add(Engine::rayCaster, tr("&OpenGL"), {});
  add(Engine::cpu, tr("&Processor"),
      tr("Draws with the vector instructions of the processor; needs no graphics card."));
  m_context.actions.addSetting({.row = 3, .label = tr("Draw with"), .choice = m_engines});
}

void EngineController::choose(std::optional<Engine> setting) {
  m_setting = setting;
  m_context.settings.setEngine(setting);
  apply();
}

void EngineController::apply() {
  const EngineChoice choice = chosenEngine(m_context.engineFacts(m_setting));
  m_context.view.setEngine(choice.engine, translated(choice.reason));
  showInMenu();
}

// The entry that is chosen says what it came to, and why; one that cannot be had says why not.
void EngineController::showInMenu() {
  const PictureState state = m_context.view.pictureState();
  const bool hasOpenGl = m_context.openGl.problem.isEmpty();
  const QString inUse = drawsWithOpenGl(m_context.view.engine()) ? tr("OpenGL") : tr("processor");
  for (QAction* action : m_engines->actions()) {
    const std::optional<Engine> setting = engineOf(*action);
    action->setChecked(setting == m_setting);
    if (!setting) {
      action->setText(m_setting == setting ? tr("&Automatic: %1").arg(inUse) : tr("&Automatic"));
      action->setToolTip(m_setting == setting ? state.engineReason
                                              : tr("Draws with the engine that is faster on this computer."));
    }
    if (setting == Engine::rayCaster) {
      action->setEnabled(hasOpenGl);
      action->setText(hasOpenGl ? tr("&OpenGL") : tr("&OpenGL (not on this computer)"));
      action->setToolTip(hasOpenGl ? m_context.openGl.renderer : m_context.openGl.problem);
    }
  }
}

// The first picture does not wait.
void EngineController::lookAt(const PictureState& state) {
  const Scene& scene = m_context.view.scene();
  if (state.resting && !m_isTried && scene.volume && !scene.volume->room() &&
      scene.volume->voxelCount() <= mostVoxelsTried && chosenEngine(m_context.engineFacts(m_setting)).isGuess)
    tryBoth();
}

// Where it fails it stays a guess: whoever draws the window finds out what the driver cannot, and says so.
void EngineController::tryBoth() {
  m_isTried = true;
  m_trial.start([this, scene = m_context.view.scene()](const Effort& effort) -> BackgroundWork::Deliver {
    const EngineTrial trial = tryEngines(scene, effort.isCancelled);
    return [this, trial] { noteTrial(trial.renderer, trial.times); };
  });
}

// Another driver than the window's tells nothing of it.
void EngineController::noteTrial(const std::string& renderer, const EngineTimes& times) {
  if (QString::fromStdString(renderer) != m_context.openGl.renderer)
    return;
  m_context.settings.engineMemory().remember(machineWith(renderer), times);
  if (!m_context.view.pictureState().driverHasFailed)
    apply();
}

} // namespace limn
