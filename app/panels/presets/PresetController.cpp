// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/PresetController.h"

#include "app/window/WindowContext.h"
#include "scene/presets/PresetFit.h"
#include "widgets/ValueText.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QDockWidget>
#include <QMenu>
#include <QStatusBar>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int toldForMs = 6000;

// Whether a curve lets no voxel of a volume be seen.
bool showsNothing(const TransferFunction& function, const Histogram& histogram) {
  const double width =
      (histogram.range.highest - histogram.range.lowest) / std::max<std::size_t>(1, histogram.counts.size());
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double value = histogram.range.lowest + (static_cast<double>(bin) + 0.5) * width;
    if (histogram.counts[bin] > 0 && classify(function, value).opacity > 0.0)
      return false;
  }
  return true;
}

// Whether fitting has moved a curve by more than rounding does.
bool liesElsewhere(const TransferFunction& fitted, const TransferFunction& saved) {
  constexpr double least = 1e-3; // of what the saved one spans
  const auto &now = fitted.points, &then = saved.points;
  if (then.empty() || now.size() != then.size())
    return now.size() != then.size();
  const double tolerance = least * (then.back().value - then.front().value);
  return !std::ranges::equal(now, then, [tolerance](const ControlPoint& a, const ControlPoint& b) {
    return std::abs(a.value - b.value) <= tolerance;
  });
}

// The values that a curve is for, where nothing else tells: it begins in the background, becomes visible
// where the object begins, and ends at the brightest.
Preset withLandmarksOfPoints(Preset preset) {
  const auto& points = preset.transferFunction.points;
  if (preset.landmarks || points.size() < 2 || !(points.back().value > points.front().value))
    return preset;
  const auto visible =
      std::ranges::find_if(points, [](const ControlPoint& point) { return point.opacity > 0.0; });
  const double span = points.back().value - points.front().value;
  const double object = visible == points.end() ? points.front().value + span / 2.0 : visible->value;
  preset.landmarks = Landmarks{std::min(points.front().value, object - 0.1 * span), object,
                               std::max(points.back().value, object + 0.1 * span)};
  return preset;
}

} // namespace

PresetController::PresetController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_browser(*new PresetBrowser(&context.window)),
      m_own(context) {
  QDockWidget* dock = context.docks.add({tr("P&resets"), "presetDock", &m_browser, Qt::LeftDockWidgetArea});
  const QAction* find = context.actions.add(
      QStringLiteral("findPreset"),
      {.text = tr("&Find preset"), .place = {Menu::preset, 1, 1}, .shortcut = QKeySequence::Find});
  connect(find, &QAction::triggered, this, [this, dock] {
    dock->show();
    dock->raise();
    m_browser.focusSearch();
  });
  connect(&m_own, &OwnPresetController::listed, this, [this] {
    list();
    markShown();
    emit inUseNamed();
  });
  connect(&m_own, &OwnPresetController::kept, &m_browser, &PresetBrowser::reveal);
  connect(&context.view.input(), &ViewInput::windowPresetRequested, this, &PresetController::useNumber);
  addKeepingLight();
  connectBrowser();
}

void PresetController::addKeepingLight() {
  m_keepsLight = m_context.actions.add(
      QStringLiteral("keepLight"),
      {.text = tr("&Keep my light"),
       .place = {Menu::preset, 1, 5},
       .toolTip =
           tr("Presets leave light, highlights and boundaries as they are; the curve and what a ray shows "
              "are the preset's."),
       .isCheckable = true});
  m_keepsLight->setChecked(m_context.settings.presetsKeepLight());
  connect(m_keepsLight, &QAction::toggled, this, [this](bool isOn) {
    m_context.settings.setPresetsKeepLight(isOn);
    emit listed(); // each looks otherwise
  });
}

Preset PresetController::asUsed(Preset preset) const {
  if (m_keepsLight->isChecked())
    preset.shading.reset();
  return preset;
}

void PresetController::connectBrowser() {
  const PresetBrowser* browser = &m_browser;
  OwnPresetController* own = &m_own;
  connect(browser, &PresetBrowser::presetChosen, this, &PresetController::use);
  connect(browser, &PresetBrowser::previewRequested, this, &PresetController::preview);
  // What stays beside it is the picture that is meant: by one model both differ in their looks alone.
  connect(browser, &PresetBrowser::compareRequested, this, [this](const QString& name) { compare(name, 1); });
  connect(browser, &PresetBrowser::saveRequested, own, &OwnPresetController::askForName);
  connect(browser, &PresetBrowser::deleteRequested, own, &OwnPresetController::remove);
  connect(browser, &PresetBrowser::renameRequested, own, &OwnPresetController::rename);
  connect(browser, &PresetBrowser::favouriteRequested, this, &PresetController::setFavourite);
  connect(browser, &PresetBrowser::noteRequested, own, &OwnPresetController::editNote);
  connect(browser, &PresetBrowser::folderRequested, own, &OwnPresetController::moveTo);
  connect(browser, &PresetBrowser::newFolderRequested, own, &OwnPresetController::moveToNewFolder);
  connect(browser, &PresetBrowser::duplicateRequested, this, [this](const QString& name) {
    if (const std::optional<Preset> preset = fitted(name))
      m_own.duplicate(*preset);
  });
  connect(browser, &PresetBrowser::exportRequested, this, &PresetController::exportRequested);
  connect(browser, &PresetBrowser::searchEnded, this,
          [this] { m_context.view.setFocus(Qt::TabFocusReason); }); // by a key, too, so that it shows
  connect(browser, &PresetBrowser::galleryChosen, this,
          [this](bool isGallery) { m_context.settings.setPresetsAreGallery(isGallery); });
  m_browser.setGallery(m_context.settings.presetsAreGallery());
}

void PresetController::list() {
  showStanding();
  m_browser.setPresets(m_builtIn, m_own.presets());
  emit listed();
}

std::vector<Preset> PresetController::fittedPresets() const {
  std::vector<Preset> presets;
  for (const QString& name : m_browser.presets())
    presets.push_back(fitted(name).value());
  return presets;
}

void PresetController::showStanding() {
  PresetStanding standing;
  standing.favourites = m_context.settings.favourites();
  const std::shared_ptr<const Volume>& volume = m_context.session.scene().volume;
  if (volume && !haveSameVoxels(volume, m_volume))
    m_browser.endSearch(); // it was for another volume, and would hide what suits this one
  m_volume = volume;
  if (m_volume)
    standing.fit = {m_volume->info().modality, firstLook(*m_volume, m_context.document.histogram()),
                    looksLikeHounsfield(*m_volume)};
  m_browser.setStanding(standing);
}

// A camera that moves ends no preview; any other change does.
void PresetController::goOnWithPreview() {
  if (m_previewed.isEmpty())
    return;
  const Scene& scene = m_context.session.scene();
  m_previewedFrom.camera = scene.camera;
  if (m_previewedFrom == scene)
    return preview(m_previewed);
  m_previewed.clear();
  m_previewedFrom = {};
}

void PresetController::recognise() {
  const Scene& scene = m_context.session.scene();
  if (!scene.volume || !m_context.session.preset().name.empty())
    return;
  std::vector<Preset> presets;
  for (const Preset& preset : fittedPresets())
    presets.push_back(asUsed(preset));
  auto found = std::ranges::find_if(
      presets, [&](const Preset& preset) { return withPreset(scene, preset, true) == scene; });
  if (found == presets.end())
    found = std::ranges::find(presets, scene.transferFunction, &Preset::transferFunction);
  if (found == presets.end())
    return;
  m_context.session.adoptPreset(*found);
  markShown();
  emit inUseNamed();
}

void PresetController::markShown() {
  goOnWithPreview();
  if (m_context.session.scene().volume != m_volume)
    showStanding();
  if (m_said && m_said->of != curvesShown()) {
    if (m_context.messages.sentence() == m_said->sentence)
      m_context.messages.hide(); // it was about another preset, or about a curve that is another now
    m_said.reset();
  }
  const OpenDocument::PresetInUse preset = m_context.document.presetInUse();
  m_browser.setCurrent(QString::fromStdString(preset.name), preset.isModified);
}

PresetController::Curves PresetController::curvesShown() const {
  const Scene& scene = m_context.session.scene();
  return {m_context.document.presetInUse().name, scene.transferFunction, scene.keep.looks};
}

const Preset* PresetController::find(const QString& name) const {
  const auto builtIn = std::ranges::find(m_builtIn, name.toStdString(), &Preset::name);
  return builtIn == m_builtIn.end() ? m_own.find(name) : &*builtIn;
}

bool PresetController::isBuiltIn(const QString& name) const {
  return std::ranges::find(m_builtIn, name.toStdString(), &Preset::name) != m_builtIn.end();
}

// It means Hounsfield units, and what is open has others.
bool PresetController::isInOtherUnits(const Preset& preset) const {
  const std::shared_ptr<const Volume>& volume = m_context.session.scene().volume;
  return volume && isForHounsfield(preset) && !looksLikeHounsfield(*volume);
}

// Own presets know the data that they were shaped on unless that was in Hounsfield units; built-in ones fit
// themselves.
std::optional<Preset> PresetController::fitted(const QString& name) const {
  const Preset* found = find(name);
  if (!found)
    return std::nullopt;
  const std::shared_ptr<const Volume>& volume = m_context.session.scene().volume;
  if (volume && isBuiltIn(name))
    return fittedToValues(*found, *volume, m_context.document.histogram());
  return volume && found->landmarks ? fittedTo(*found, m_context.document.histogram(), volume->grid())
                                    : *found;
}

// Of built-in ones those whose numbers are Hounsfield units: the others have none of their own.
bool PresetController::isFitted(const Preset& look) const {
  const QString name = QString::fromStdString(look.name);
  const Preset* saved = find(name);
  return saved && (!isBuiltIn(name) || isInOtherUnits(*saved)) &&
         liesElsewhere(look.transferFunction, saved->transferFunction) &&
         look.transferFunction == fitted(name)->transferFunction;
}

std::vector<std::string> PresetController::namesOfFitted() const {
  std::vector<std::string> names;
  for (const Preset& preset : fittedPresets())
    if (isFitted(preset))
      names.push_back(preset.name);
  return names;
}

QString PresetController::nameShown() const {
  const OpenDocument::PresetInUse preset = m_context.document.presetInUse();
  const QString name = QString::fromStdString(preset.name);
  return name.isEmpty() ? tr("My preset") : preset.isModified ? tr("My %1").arg(presetWords(name)) : name;
}

void PresetController::use(const QString& name) {
  m_own.readEdited(name);
  const std::optional<Preset> preset = fitted(name);
  if (!preset || !m_context.session.scene().volume)
    return;
  show(*preset, tr("use preset %1").arg(presetWords(name)));
  const Preset known = *find(name);
  if (isInOtherUnits(known))
    isBuiltIn(name) ? sayHowItWasFitted(known) : offerToFit(known);
  else if (showsNothing(preset->transferFunction, m_context.document.histogram()))
    offerWhereNothingShows(known);
  else if (isFitted(*preset))
    offerAsSaved(known);
}

void PresetController::preview(const QString& name) {
  const Scene& scene = m_context.session.scene();
  if (!scene.volume)
    return;
  m_previewed = name;
  m_previewedFrom = name.isEmpty() ? Scene() : scene; // no volume is kept
  const std::optional<Preset> preset = fitted(name);
  const std::optional<Scene> ofPart = preset ? m_shownAs(*preset) : std::nullopt;
  emit previewed(ofPart   ? *ofPart
                 : preset ? withPreset(scene, asUsed(*preset), true)
                          : scene,
                 preset ? preset->name : std::string());
}

void PresetController::compare(const QString& name, int likeSide) {
  if (const std::optional<Preset> preset = fitted(name); preset && m_context.session.scene().volume)
    emit compareRequested(*preset, likeSide);
}

// Of two models both sides show the scene's own look: what stands at the other side of a preset is that.
void PresetController::useOnSide(const QString& name, int side) {
  const ViewOrder& order = m_context.view.order();
  const bool isSingle = order.comparison.layout == CompareLayout::single;
  if (isSingle || (order.comparison.look && side == 1))
    return use(name);
  if (side == 0)
    return compare(name, side);
  emit ownCompareRequested();
  use(name);
}

// The preset that the picture of a side shows as it is; empty: none. A compared look is modified where it is
// called otherwise than its preset.
std::string PresetController::unmodifiedOf(int side) const {
  const Comparison& comparison = m_context.view.order().comparison;
  if (!comparison.look || comparison.layout == CompareLayout::single || side == 1) {
    const OpenDocument::PresetInUse inUse = m_context.document.presetInUse();
    return inUse.isModified ? std::string() : inUse.name;
  }
  const QString name = QString::fromStdString(comparison.look->shown.name);
  const QString called = QString::fromStdString(comparison.look->names.front());
  return called == presetWords(name) || called == fittedWords(name) ? name.toStdString() : std::string();
}

void PresetController::fillMenu(QMenu& menu, int side) {
  menu.clear();
  const std::string shown = unmodifiedOf(side);
  for (const QString& name : m_browser.presets()) {
    QAction* action = menu.addAction(presetWords(name).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                                     [this, name, side] { useOnSide(name, side); });
    action->setCheckable(true);
    action->setChecked(name.toStdString() == shown);
  }
}

void PresetController::show(const Preset& preset, const QString& edit) {
  if (const std::optional<Scene> ofPart = m_shownAs(preset)) {
    m_context.session.edit(*ofPart, {nextGestureId(), edit, true});
    m_context.window.statusBar()->showMessage(
        tr("\"%1\" shapes the curve in hand, of one label or piece; the picture's other curves stay.")
            .arg(presetWords(QString::fromStdString(preset.name))),
        toldForMs);
  } else {
    m_context.session.usePreset(asUsed(preset), {nextGestureId(), edit, true});
  }
  markShown(); // one that changes nothing is in use as well
  emit inUseNamed();
}

void PresetController::sayHowItWasFitted(const Preset& preset) {
  const QString name = presetWords(QString::fromStdString(preset.name));
  const Landmarks to = landmarksOf(m_context.document.histogram());
  const auto number = [](double value) { return digitsNumber(value, 4); };
  const auto leaveIt = [this, preset, name, volume = m_context.session.scene().volume] {
    if (m_context.session.scene().volume == volume)
      show(preset, tr("use preset %1 as it is").arg(name));
  };
  say(tr("\"%1\" was fitted by this volume's own values: air lies at %2 (instead of %3 HU), tissue begins at "
         "%4 "
         "(%5 HU), the brightest is %6 (%7 HU).")
          .arg(name, number(to.background), number(hounsfieldLandmarks.background), number(to.object),
               number(hounsfieldLandmarks.object), number(to.brightest),
               number(hounsfieldLandmarks.brightest)),
      {tr("Use it as it is"), leaveIt});
}

void PresetController::offerAsSaved(const Preset& preset) {
  const QString name = presetWords(QString::fromStdString(preset.name));
  const auto takeAsSaved = [this, preset, name, volume = m_context.session.scene().volume] {
    if (m_context.session.scene().volume == volume)
      show(preset, tr("use preset %1 as saved").arg(name));
  };
  say(tr("\"%1\" was fitted to this volume's values.").arg(name), {tr("Use as saved"), takeAsSaved});
}

void PresetController::offerToFit(const Preset& preset) {
  const auto fit = [this, preset, volume = m_context.session.scene().volume] {
    if (m_context.session.scene().volume != volume)
      return;
    show(fittedToValues(preset, *volume, m_context.document.histogram()),
         tr("fit preset %1").arg(presetWords(QString::fromStdString(preset.name))));
    sayHowItWasFitted(preset);
  };
  say(tr("\"%1\" is made for Hounsfield units, which this volume does not have: it may show nothing, or the "
         "wrong "
         "tissue.")
          .arg(presetWords(QString::fromStdString(preset.name))),
      {tr("Fit to this volume"), fit});
}

// A preset that does not know its data had the values that its own points lie between.
void PresetController::offerWhereNothingShows(const Preset& preset) {
  const auto fit = [this, preset = withLandmarksOfPoints(preset), volume = m_context.session.scene().volume] {
    if (m_context.session.scene().volume == volume)
      show(fittedTo(preset, m_context.document.histogram(), volume->grid()),
           tr("fit preset %1").arg(presetWords(QString::fromStdString(preset.name))));
  };
  say(tr("\"%1\" shows nothing of this volume: its curve is for other values.")
          .arg(presetWords(QString::fromStdString(preset.name))),
      {tr("Fit to this volume"), fit});
}

void PresetController::say(const QString& sentence, const MessageBar::Action& action) {
  m_said = Said{sentence, curvesShown()};
  m_context.messages.show(action.text.isEmpty() ? MessageBar::Kind::note : MessageBar::Kind::warning,
                          sentence, {}, action);
}

void PresetController::useNumber(int number) {
  if (!m_context.session.scene().volume)
    return;
  if (number == 0) {
    m_context.session.setTransferFunction(
        automaticRamp(m_context.document.histogram(), m_context.session.scene().volume->grid()),
        {nextGestureId(), tr("use the full range"), true});
    return;
  }
  if (const QStringList listed = m_browser.presets(); number <= listed.size())
    use(listed[number - 1]);
}

void PresetController::setFavourite(const QString& name, bool isFavourite) {
  m_context.settings.setFavourite(name.toStdString(), isFavourite);
  showStanding();
}

} // namespace limn
