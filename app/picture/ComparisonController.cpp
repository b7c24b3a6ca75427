// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/ComparisonController.h"

#include "app/picture/ModelMenus.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/view/CompareView.h"

#include <QEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QStatusBar>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace limn {
namespace {

// Narrower pictures show less of two models than one picture of both.
constexpr int leastOfTwo = 400; // pixels

constexpr int toldForMs = 6000;

} // namespace

ComparisonController::ComparisonController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_layouts(context.actions.addGroup()) {
  addLayouts();
  addModels();
  addSnapshot();
  context.view.installEventFilter(this);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { followModel(scene); });
  connect(&context.session, &Session::planesChanged, this, &ComparisonController::noteSlices);
}

void ComparisonController::addLayouts() {
  int row = 0;
  const auto add = [&](CompareLayout layout, const QString& text, const char* icon, const QString& tip) {
    ++row;
    m_context.actions.addChoice(*m_layouts, QStringLiteral("layout-") + QLatin1String(nameOf(layout)),
                                static_cast<int>(layout),
                                {.text = text,
                                 .place = {Menu::view, 1, row},
                                 .toolTip = tip,
                                 .icon = QLatin1String(icon),
                                 .tool = {4, row},
                                 .needsVolume = true});
  };
  add(CompareLayout::single, tr("Si&ngle"), "single",
      tr("One picture; of two models that of the side you worked in last."));
  add(CompareLayout::sideBySide, tr("Si&de by side"), "side-by-side", tr("Two models beside each other."));
  add(CompareLayout::wipe, tr("&Wipe"), "wipe", tr("Two models over each other with a border to drag."));
  add(CompareLayout::difference, tr("Di&fference"), "difference",
      tr("Where the two models differ, amplified."));
  connect(m_layouts, &QActionGroup::triggered, this, [this](QAction* chosen) {
    chooseLayout(static_cast<CompareLayout>(chosen->data().toInt()));
    emit layoutChosen();
  });
  m_swap = m_context.actions.add(
      QStringLiteral("swapSides"),
      {.text = tr("S&wap the sides"),
       .place = {Menu::preset, 3, 4},
       .toolTip = tr("From now on what is at the left stands at the right, and the other way round; of two "
                     "looks the right one is edited. Space shows the other side while it is held.")});
  m_swap->setEnabled(false);
  connect(m_swap, &QAction::triggered, this, &ComparisonController::swapSides);
  connect(&m_context.view, &CompareView::swapAsked, this, &ComparisonController::swapSides);
}

void ComparisonController::addModels() {
  const auto choose = [this](int side, ShadingModel model) { setSideModel(side, model); };
  const auto fill = [this](QMenu* menu, int side) { emit presetMenuAsked(menu, side); };
  const auto* menus = new ModelMenus(m_context.actions, choose, fill, this);
  connect(this, &ComparisonController::modelsShown, menus, &ModelMenus::show);
  connect(&m_context.view, &CompareView::modelChosen, this, &ComparisonController::setSideModel);
}

void ComparisonController::addSnapshot() {
  const QAction* take = m_context.actions.add(
      QStringLiteral("takeSnapshot"), {.text = tr("&Remember this look as \"before\""),
                                       .place = {Menu::preset, 3, 1},
                                       .shortcut = tr("Ctrl+B"),
                                       .toolTip = tr("Keeps curve and light of this moment to compare with "
                                                     "what becomes of them."),
                                       .needsVolume = true});
  m_compareSnapshot =
      m_context.actions.add(QStringLiteral("compareSnapshot"),
                            {.text = tr("Compare &before and now"),
                             .place = {Menu::preset, 3, 2},
                             .shortcut = tr("Ctrl+Shift+B"),
                             .toolTip = tr("Shows the remembered look at the left, the present one at the "
                                           "right."),
                             .isCheckable = true});
  m_compareModels = m_context.actions.add(QStringLiteral("compareModels"),
                                          {.text = tr("Compare &models again"),
                                           .place = {Menu::preset, 3, 3},
                                           .toolTip = tr("Ends the comparison of two looks.")});
  connect(take, &QAction::triggered, this, &ComparisonController::takeSnapshot);
  connect(m_compareSnapshot, &QAction::triggered, this,
          [this](bool isChosen) { isChosen ? compareWith(*m_snapshot) : compareModels(); });
  connect(m_compareModels, &QAction::triggered, this, &ComparisonController::compareModels);
}

void ComparisonController::begin() {
  m_compared.wanted = CompareLayout::sideBySide;
  m_compared.isAsked = false;
  fitLayout();
}

void ComparisonController::setLayout(CompareLayout layout) {
  m_beforeOpened.reset();
  m_compared.wanted = layout;
  m_compared.isAsked = true;
  fitLayout();
}

void ComparisonController::chooseLayout(CompareLayout layout) {
  const bool wereTwo = m_context.view.compareLayout() != CompareLayout::single;
  const std::optional<int> workedIn = m_compared.look ? m_context.view.ownSide() : m_workedIn;
  if (layout != CompareLayout::single || !wereTwo || !workedIn)
    return setLayout(layout);
  const int side = *workedIn;
  const ShadingModel model = m_context.view.sceneOfSide(side).shading.model;
  const Scene& scene = m_context.session.scene();
  const bool isOther = scene.volume && model != scene.shading.model;
  if (isOther)
    showOneOfBoth(model);
  else
    setLayout(layout);
}

// The scene's physical light takes the right of the pair along (followModel). What was compared is therefore
// shown last: by a step that undo comes to last, and by one that redo comes to last.
void ComparisonController::showOneOfBoth(ShadingModel model) {
  m_beforeOpened.reset();
  const ComparisonState before = m_compared;
  ComparisonState after = before;
  after.wanted = CompareLayout::single;
  after.isAsked = true;
  Shading shading = m_context.session.scene().shading;
  shading.model = model;
  const QString text = tr("one picture: %1", "a model").arg(modelName(model));
  const auto nothing = [] {};
  QUndoStack& steps = m_context.session.undoStack();
  steps.beginMacro(text);
  steps.push(new ComparisonEdit(
      text, [shower = m_shower, before, after] { (*shower)->showCompared(before, after); }, nothing));
  m_context.session.setShading(shading, {nextGestureId(), text});
  showCompared(after, before);
  steps.push(new ComparisonEdit(
      text, nothing, [shower = m_shower, before, after] { (*shower)->showCompared(after, before); }));
  steps.endMacro();
}

// Two looks are compared because somebody asked for that.
CompareLayout ComparisonController::layoutWithRoom() const {
  const bool isTight = m_hasSlices || m_context.view.width() < 2 * leastOfTwo;
  const bool mayGiveWay =
      m_compared.wanted == CompareLayout::sideBySide && !m_compared.isAsked && !m_compared.look;
  return mayGiveWay && isTight && m_context.session.scene().volume ? CompareLayout::single
                                                                   : m_compared.wanted;
}

void ComparisonController::fitLayout() {
  const CompareLayout layout = layoutWithRoom();
  m_context.view.setCompareLayout(layout);
  checkOnly(*m_layouts, static_cast<int>(layout));
  show();
}

// With slices beside it there is one picture until somebody asks for both.
void ComparisonController::noteSlices() {
  const bool has = m_context.session.planes().layout != PlaneLayout::pictureOnly;
  if (has == m_hasSlices)
    return;
  m_hasSlices = has;
  if (m_compared.wanted == CompareLayout::sideBySide)
    m_compared.isAsked = false;
  fitLayout();
}

bool ComparisonController::eventFilter(QObject* watched, QEvent* event) {
  const ViewOrder& order = m_context.view.order();
  const CompareLayout layout = order.comparison.layout;
  const bool hasSides = layout == CompareLayout::sideBySide || layout == CompareLayout::wipe;
  if (watched == &m_context.view && event->type() == QEvent::MouseButtonPress && hasSides)
    m_workedIn = sideAt(order, static_cast<QMouseEvent*>(event)->position());
  if (watched == &m_context.view && event->type() == QEvent::Resize && !m_compared.isAsked &&
      layoutWithRoom() != m_context.view.compareLayout())
    QMetaObject::invokeMethod(this, &ComparisonController::fitLayout,
                              Qt::QueuedConnection); // once it has its size
  return QObject::eventFilter(watched, event);
}

void ComparisonController::setSideModel(int side, ShadingModel model) {
  const bool isSingle = m_context.view.compareLayout() == CompareLayout::single;
  const bool isOfOwnLook = m_compared.look && side == 1;
  if (isSingle || (isOfOwnLook && !m_compared.ownModel)) {
    Shading shading = m_context.session.scene().shading;
    const Gesture gesture = choiceGesture(tr("Model"), modelName(shading.model), modelName(model));
    shading.model = model;
    m_context.session.setShading(shading, gesture);
    return;
  }
  const ComparisonState before = m_compared;
  m_compared.setSideModel(side, model);
  if (!isOfOwnLook)
    m_workedIn = side;
  show();
  note(before, (side == 0 ? tr("Left: %1") : tr("Right: %1")).arg(modelName(model)));
}

void ComparisonController::note(const ComparisonState& before, const QString& text) {
  const ComparisonState after = m_compared;
  if (after != before)
    m_context.session.undoStack().push(new ComparisonEdit(
        text, [shower = m_shower, before, after] { (*shower)->showCompared(before, after); },
        [shower = m_shower, before, after] { (*shower)->showCompared(after, before); }));
}

void ComparisonController::showCompared(const ComparisonState& wanted, const ComparisonState& other) {
  const std::pair layoutNow{m_compared.wanted, m_compared.isAsked};
  m_compared = wanted;
  if (wanted.wanted == other.wanted && wanted.isAsked == other.isAsked) {
    std::tie(m_compared.wanted, m_compared.isAsked) = layoutNow;
    return show();
  }
  fitLayout();
}

// Of a volume that is opened a comparison has models of its own. What changed shows once the view has the
// scene.
void ComparisonController::followModel(const Scene& scene) {
  const bool had = std::exchange(m_hasPhysical, scene.shading.model == ShadingModel::physical);
  if (had == m_hasPhysical || !haveSameVoxels(m_volume, scene.volume))
    return;
  m_compared.setRightPhysical(m_hasPhysical);
}

void ComparisonController::followLight(LightPreset light) {
  m_compared.setRightPhysical(light == LightPreset::physical);
  if (light == LightPreset::physical)
    m_workedIn = 1;
  show();
}

void ComparisonController::compareOwn() {
  const OpenDocument::PresetInUse own = m_context.document.presetInUse();
  Preset look = presetOf(m_context.session.scene(), own.name.empty() ? tr("Before").toStdString() : own.name);
  look.isWhole = true;
  compare(look, own.isModified ? std::optional(m_context.session.preset()) : std::nullopt);
}

// What was remembered is compared with what became of it, by the model of the right.
void ComparisonController::compare(const Preset& look, const std::optional<Preset>& from, int likeSide) {
  const bool isSingle = m_context.view.compareLayout() == CompareLayout::single;
  const bool isRemembered = isSnapshot(look);
  const ComparisonState before = m_compared;
  const ShadingModel model = m_context.view.sceneOfSide(isSingle ? 0 : likeSide).shading.model;
  if (!m_compared.look || isSingle)
    m_compared.ownModel = isSingle ? std::nullopt : std::optional(m_compared.right);
  m_compared.look = look;
  m_compared.lookFrom = from;
  if (!m_compared.look->shading)
    m_compared.look->shading = m_context.session.scene().shading;
  m_compared.look->shading->model =
      isRemembered ? m_compared.shownOwnModel().value_or(m_compared.look->shading->model) : model;
  if (isSingle)
    setLayout(CompareLayout::sideBySide);
  else
    show();
  if (!isRemembered) // that comes and goes by one key, like a way of looking
    note(before, tr("Left: %1").arg(QString::fromStdString(comparedLook()->names[0])));
}

void ComparisonController::compareModels() {
  const ComparisonState before = m_compared;
  const bool wasSnapshot = m_compared.isWithSnapshot();
  m_compared.endLook();
  show();
  if (!wasSnapshot)
    note(before, tr("compare models"));
}

// Of two looks that at the left becomes the scene's own, because the right one is edited; names go along.
void ComparisonController::swapSides() {
  if (!m_swap->isEnabled())
    return;
  const ComparisonState before = m_compared;
  const QString text = tr("swap the sides");
  if (!m_compared.look) {
    const ShadingModel left = std::exchange(m_compared.left, m_compared.right.shown);
    m_compared.right.choose(left);
    turnWorkedIn();
    show();
    if (const ComparisonState after = m_compared; after != before)
      m_context.session.undoStack().push(new ComparisonEdit(
          text, [shower = m_shower, before, after] { (*shower)->showSwapped(before, after); },
          [shower = m_shower, before, after] { (*shower)->showSwapped(after, before); }));
    return;
  }
  const ComparedLook both = *comparedLook();
  const Scene scene = m_context.session.scene();
  const OpenDocument::PresetInUse named = m_context.document.presetInUse();
  Preset left = presetOf(scene, named.name.empty() ? both.names[1] : named.name);
  left.isWhole = true;
  left.shading->model = m_compared.shownOwnModel().value_or(scene.shading.model);
  Preset own = both.shown;
  own.name = m_compared.isWithSnapshot() ? both.names[0] : m_compared.look->name;
  Scene next = withPreset(scene, own);
  if (m_compared.ownModel)
    next.shading.model = scene.shading.model;
  QUndoStack& steps = m_context.session.undoStack();
  const Gesture gesture{nextGestureId(), text, true};
  const std::optional<Preset> leftFrom =
      named.isModified ? std::optional(m_context.session.preset()) : std::nullopt;
  steps.beginMacro(text);
  m_context.session.edit(next, m_compared.lookFrom.value_or(own), gesture);
  m_compared.look = left;
  m_compared.lookFrom = leftFrom;
  if (m_compared.ownModel)
    m_compared.ownModel->choose(own.shading->model);
  show();
  note(before, text);
  steps.endMacro();
}

// What was worked in goes along with its model, also on the way back.
void ComparisonController::showSwapped(const ComparisonState& wanted, const ComparisonState& other) {
  turnWorkedIn();
  showCompared(wanted, other);
}

void ComparisonController::turnWorkedIn() {
  if (m_workedIn)
    m_workedIn = 1 - *m_workedIn;
}

void ComparisonController::takeSnapshot() {
  const bool isCompared = m_compared.isWithSnapshot();
  m_snapshot = snapshotOf(m_context.session.scene(), ownName());
  if (isCompared) {
    m_compared.look = m_snapshot;
    m_compared.look->shading->model = m_compared.shownOwnModel().value_or(m_compared.look->shading->model);
  }
  const QString name = ownName();
  m_context.window.statusBar()->showMessage(
      name.isEmpty() ? tr("Remembered; Ctrl+Shift+B compares with this look.")
                     : tr("Remembered; Ctrl+Shift+B compares with \"%1\".", "a look").arg(name),
      toldForMs);
  show();
}

QString ComparisonController::ownName() const {
  const OpenDocument::PresetInUse own = m_context.document.presetInUse();
  const QString name = presetWords(QString::fromStdString(own.name));
  if (own.name.empty())
    return name;
  if (own.isModified)
    return tr("%1, modified", "a preset").arg(name);
  return m_isFitted(m_context.session.preset()) ? fittedWords(QString::fromStdString(own.name)) : name;
}

std::optional<ComparedLook> ComparisonController::comparedLook() const {
  return m_compared.comparedLook(ownName(), m_compared.look && m_isFitted(*m_compared.look));
}

void ComparisonController::showOpened(const std::optional<ShownSides>& sides) {
  const Scene& scene = m_context.session.scene();
  const bool isImage =
      scene.volume && imageNormalAxis(scene.volume->grid()) && scene.shading.model == ShadingModel::none;
  const bool bringsLayout = sides || isImage;
  if (bringsLayout && !m_beforeOpened)
    m_beforeOpened = {m_compared.wanted, m_compared.isAsked};
  if (sides && !isImage) {
    m_compared.take(*sides);
    if (pictureCount(sides->layout) == 2)
      m_context.view.setWipePosition(sides->wipe);
  } else if (isImage) {
    m_compared.wanted = CompareLayout::single;
  } else if (m_beforeOpened) {
    std::tie(m_compared.wanted, m_compared.isAsked) = *m_beforeOpened;
    m_beforeOpened.reset();
  }
  fitLayout();
}

void ComparisonController::show() {
  const Scene& scene = m_context.session.scene();
  if (!haveSameVoxels(m_volume, scene.volume)) {
    m_snapshot.reset();
    m_compared.endLook();
    m_workedIn.reset();
  }
  m_volume = scene.volume;
  const bool isSingle = m_context.view.compareLayout() == CompareLayout::single;
  const std::optional<ComparedLook> look = comparedLook();
  m_context.view.setSides({m_compared.left, m_compared.right.shown}, look);
  m_compareSnapshot->setEnabled(m_snapshot.has_value());
  m_compareSnapshot->setChecked(m_compared.isWithSnapshot() && !isSingle);
  m_compareModels->setEnabled(m_compared.look && !isSingle);
  m_swap->setEnabled(scene.volume && !isSingle);
  emit modelsShown(m_compared.models(isSingle, scene.shading.model),
                   look && !isSingle ? QString::fromStdString(look->names.front()) : QString());
  emit shown();
}

ComparisonController::Memory ComparisonController::memory() const {
  return {m_compared,     m_snapshot, m_context.view.wipePosition(), m_workedIn,
          m_beforeOpened, m_shower,   m_context.view.compareLayout()};
}

// Where the words of the window are longer its panels are wider: two pictures that were seen stay two.
void ComparisonController::takeOver(const Memory& memory) {
  m_compared = memory.compared;
  m_compared.isAsked = m_compared.isAsked || (m_volume && memory.shown == CompareLayout::sideBySide);
  m_snapshot = memory.snapshot;
  m_workedIn = memory.workedIn;
  m_beforeOpened = memory.beforeOpened;
  m_shower = memory.shower;
  *m_shower = this;
  m_context.view.setWipePosition(memory.wipe);
  fitLayout();
}

void ComparisonController::describe(SessionDocument& session) const {
  m_compared.describe(session);
  session.wipe = m_context.view.wipePosition();
  session.snapshot = m_snapshot;
}

void ComparisonController::restore(const SessionDocument& session) {
  m_compared = comparisonOf(session, m_context.session.scene().shading);
  m_snapshot = session.snapshot;
  m_context.view.setWipePosition(session.wipe);
  m_beforeOpened.reset();
  fitLayout();
}

} // namespace limn
