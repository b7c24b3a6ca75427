// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/WindowContext.h"

#include "app/core/drawing/PictureMaker.h"
#include "cpu/CpuEngine.h"
#include "raycaster/RayCasterEngine.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/HintBar.h"
#include "widgets/view/panels/ViewPanels.h"

#include <QFileInfo>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

QVBoxLayout& columnIn(QMainWindow& window) {
  auto* centre = new QWidget(&window);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  window.setCentralWidget(centre);
  return *column;
}

// The view never draws with OpenGL that the computer does not offer.
DrawingEngines enginesOf(const OpenGlOffer& openGl, const std::optional<MemoryBudget>& memory) {
  return {openGl.problem.isEmpty() ? MakeEngine(makeRayCasterEngine) : MakeEngine(),
          [memory] { return makeCpuEngine(0, memory.value_or(MemoryBudget())); },
          // Beside the picture: one thread, however many there are.
          [](std::function<bool()> isCancelled) { return preciselyBy(1, std::move(isCancelled)); }};
}

} // namespace

bool SaveNotes::attempt(const std::function<void()>& write, const QString& path) {
  try {
    write();
  } catch (const Error& error) {
    sayFailure(translated(error.sentence()));
    return false;
  }
  if (!path.isEmpty())
    m_status.showMessage(QObject::tr("Saved %1").arg(QFileInfo(path).fileName()), 4000);
  if (!m_failure.isEmpty() && m_messages.sentence() == m_failure)
    m_messages.hide();
  m_failure.clear();
  return true;
}

void SaveNotes::sayFailure(const QString& sentence) {
  m_failure = sentence;
  m_messages.show(MessageBar::Kind::error, sentence);
}

WindowContext::WindowContext(QMainWindow& itsWindow, UserFolders itsFolders,
                             const std::optional<MemoryBudget>& itsMemory, std::unique_ptr<OpenWork> open)
    : m_open(open ? std::move(open) : std::make_unique<OpenWork>()), window(itsWindow),
      folders(std::move(itsFolders)), memory(itsMemory), settings(folders.settings), session(m_open->session),
      document(m_open->document), actions(window), docks(window), m_column(columnIn(window)),
      recovery(addBar("recoveryBar")), unsafe(addBar("unsafeBar")), kept(addBar("keptBar")),
      patient(addBar("patientBar")), tour(addBar("tourBar")), messages(addBar("messageBar")),
      unwritten(addBar("unwrittenBar")),
      view(*new CompareView(enginesOf(openGl, memory), chosenEngine(engineFacts(settings.engine())).engine,
                            window.centralWidget())),
      planes(*new PlaneDeck(view, window.centralWidget())), notes(*window.statusBar(), messages) {
  session.setParent(&window);
  m_column.addWidget(&planes, 1);
  // What is said of that which was just opened goes before what was left for it.
  new MessageOrder({&unsafe, &recovery, &messages, &kept, &unwritten, &patient, &tour}, &window);
  for (MessageBar* bar : {&patient, &tour})
    bar->setBriefWhenLate(true);
  placeBars();
  settings.setOnProblem([this](const QString& sentence) { showError(sentence); });
  QObject::connect(&session, &Session::sceneChanged, &window,
                   [this](const Scene& scene) { followers.tell(scene); });
  QObject::connect(&session.undoStack(), &QUndoStack::indexChanged, &window, [this] { leaveUndone(); });
}

// Widgets that go say a last time what they show.
std::unique_ptr<OpenWork> WindowContext::giveOpen() {
  for (const QObject* child : window.findChildren<QObject*>())
    QObject::disconnect(child, nullptr, &session, nullptr);
  session.disconnect();
  session.undoStack().disconnect();
  session.setParent(nullptr);
  return std::move(m_open);
}

MessageBar& WindowContext::addBar(const char* name) {
  auto* bar = new MessageBar(window.centralWidget());
  bar->setObjectName(QLatin1String(name));
  return *bar;
}

EngineFacts WindowContext::engineFacts(std::optional<Engine> setting) {
  EngineFacts facts{setting, openGl.problem.toStdString(), openGl.renderer.toStdString(), std::nullopt};
  if (facts.problem.empty() && !setting)
    facts.times = settings.engineMemory().recall(machineWith(facts.renderer));
  return facts;
}

MakingOptions WindowContext::drawnLikeTheView() const {
  MakingOptions order;
  order.engine = view.engine();
  return order;
}

// Slices stay free, and the cube: a click on it turns the picture, also while something is said of it. The
// page without a volume makes room.
void WindowContext::placeBars() {
  const auto cubePlace = [&seen = view, middle = window.centralWidget()] {
    const OverlaySource source{seen.order(), seen.pictureState()};
    const auto cube = source.comparison.scene.volume ? orientationCubeOf(source) : std::nullopt;
    return cube ? cube->plate.toAlignedRect().translated(seen.mapTo(middle, QPoint())) : QRect();
  };
  for (MessageBar* bar : {&recovery, &unsafe, &kept, &patient, &tour, &messages, &unwritten}) {
    bar->setPart(view);
    bar->setKeptFree(cubePlace);
    view.emptyPanel().keepClearOf(*bar);
    QObject::connect(&view, &CompareView::told, bar, &MessageBar::lookAgain);
  }
}

void WindowContext::keepClear(HintBar& bar) const {
  const auto written = [&seen = view] {
    OverlaySource source{seen.order(), seen.pictureState()};
    source.comparison.measures.clear(); // keep clear of it, and not the other way round
    source.cutLine.reset();
    if (!source.comparison.scene.volume)
      return std::vector<QRectF>();
    std::vector<QRectF> places = writtenPlaces(overlayOf(source));
    if (source.lowest() < seen.height()) // a panel, such as one that tells how far loading is
      places.emplace_back(0.0, source.lowest(), seen.width(), seen.height() - source.lowest());
    return places;
  };
  bar.setWritten(written, [](const QRectF& wished, const QRectF& lane, const std::vector<QRectF>& places) {
    return clearPlace(wished, lane, Qt::Horizontal, places);
  });
  const std::array<MessageBar*, 7> bars{&recovery, &unsafe, &kept, &patient, &tour, &messages, &unwritten};
  bar.setCoveredBelow([&seen = view, bars] {
    std::vector<QRect> covered;
    for (const MessageBar* message : bars)
      if (message->isVisible())
        covered.emplace_back(seen.mapFromGlobal(message->mapToGlobal(QPoint())), message->size());
    return covered;
  });
  for (MessageBar* message : bars)
    bar.followCover(*message);
}

void WindowContext::showError(const QString& sentence) const {
  messages.show(MessageBar::Kind::error, sentence);
}

void WindowContext::messageGoesWithLastStep() {
  m_saidOfStep = messages.sentence();
  m_stepSaid.emplace(session.undoStack());
}

WindowContext::Said WindowContext::said() const {
  return {messages.said(), m_saidOfStep, m_stepSaid, notes.failure()};
}

void WindowContext::takeOver(const Said& said) {
  notes.takeOver(said.failure);
  if (!said.message || messages.isWanted())
    return;
  messages.show(*said.message);
  m_saidOfStep = said.ofStep;
  m_stepSaid = said.step;
}

// With another volume all steps go.
void WindowContext::leaveUndone() {
  if (m_stepSaid)
    m_stepSaid->follow();
  if (!m_stepSaid || m_stepSaid->isDone())
    return;
  if (messages.sentence() == m_saidOfStep)
    messages.hide();
  m_stepSaid.reset();
}

} // namespace limn
