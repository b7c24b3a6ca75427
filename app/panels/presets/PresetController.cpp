// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/presets/PresetController.h"

#include "app/presets/PresetStore.h"
#include "app/window/WindowContext.h"
#include "scene/basics/Error.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/presets/PresetFit.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/CompareView.h"

#include <QDialogButtonBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace limn {
namespace {

auto named(const std::vector<Preset>& presets, const QString& name) {
  return std::find_if(presets.begin(), presets.end(),
                      [&](const Preset& preset) { return preset.name == name.toStdString(); });
}

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
      m_store(context.folders.presets) {
  QDockWidget* dock = context.docks.add({tr("P&resets"), "presetDock", &m_browser, Qt::LeftDockWidgetArea});
  const QAction* find = context.actions.add(
      QStringLiteral("findPreset"),
      {.text = tr("&Find preset"), .place = {Menu::preset, 1, 1}, .shortcut = QKeySequence::Find});
  connect(find, &QAction::triggered, this, [this, dock] {
    dock->show();
    dock->raise();
    m_browser.focusSearch();
  });
  const QAction* save = context.actions.add(
      QStringLiteral("savePreset"),
      {.text = tr("&Save as preset…"), .place = {Menu::preset, 1, 2}, .needsVolume = true});
  connect(save, &QAction::triggered, this, &PresetController::askForName);
  connect(&context.view, &CompareView::windowPresetRequested, this, &PresetController::useNumber);
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
  connect(browser, &PresetBrowser::presetChosen, this, &PresetController::use);
  connect(browser, &PresetBrowser::previewRequested, this, &PresetController::preview);
  connect(browser, &PresetBrowser::compareRequested, this, &PresetController::compare);
  connect(browser, &PresetBrowser::saveRequested, this, &PresetController::askForName);
  connect(browser, &PresetBrowser::deleteRequested, this, &PresetController::remove);
  connect(browser, &PresetBrowser::renameRequested, this, &PresetController::rename);
  connect(browser, &PresetBrowser::favouriteRequested, this, &PresetController::setFavourite);
  connect(browser, &PresetBrowser::noteRequested, this, &PresetController::editNote);
  connect(browser, &PresetBrowser::folderRequested, this, &PresetController::moveTo);
  connect(browser, &PresetBrowser::newFolderRequested, this, &PresetController::moveToNewFolder);
  connect(browser, &PresetBrowser::duplicateRequested, this, &PresetController::duplicate);
  connect(browser, &PresetBrowser::exportRequested, this, &PresetController::exportRequested);
  connect(browser, &PresetBrowser::searchEnded, &m_context.view, qOverload<>(&QWidget::setFocus));
  connect(browser, &PresetBrowser::galleryChosen, this,
          [this](bool isGallery) { m_context.settings.setPresetsAreGallery(isGallery); });
  m_browser.setGallery(m_context.settings.presetsAreGallery());
}

void PresetController::refresh() {
  const PresetStore::Contents own = m_store.read();
  m_own = own.presets;
  showStanding();
  m_browser.setPresets(m_builtIn, m_own);
  if (!own.problems.empty())
    m_context.messages.show(MessageBar::Kind::error, translated(own.problems.front()));
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
  m_volume = m_context.session.scene().volume;
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

void PresetController::markShown() {
  goOnWithPreview();
  if (m_context.session.scene().volume != m_volume)
    showStanding();
  const OpenDocument::PresetInUse preset = m_context.document.presetInUse();
  if (!m_saidOf.empty() && m_saidOf != preset.name && m_context.messages.sentence() == m_said)
    m_context.messages.hide(); // it was about another preset
  m_browser.setCurrent(QString::fromStdString(preset.name), preset.isModified);
}

const Preset* PresetController::find(const QString& name) const {
  for (const std::vector<Preset>* presets : {&m_builtIn, &m_own})
    if (const auto found = named(*presets, name); found != presets->end())
      return &*found;
  return nullptr;
}

bool PresetController::isBuiltIn(const QString& name) const {
  return named(m_builtIn, name) != m_builtIn.end();
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

// Somebody may have edited its file.
void PresetController::readAgain(const QString& name) {
  const auto known = named(m_own, name);
  if (known == m_own.end())
    return;
  try {
    if (m_store.find(known->name) != *known)
      refresh();
  } catch (const Error&) {
    refresh(); // and say why
  }
}

QString PresetController::nameShown() const {
  const OpenDocument::PresetInUse preset = m_context.document.presetInUse();
  const QString name = QString::fromStdString(preset.name);
  return name.isEmpty() ? tr("My preset") : preset.isModified ? tr("My %1").arg(name) : name;
}

void PresetController::use(const QString& name) {
  readAgain(name);
  const std::optional<Preset> preset = fitted(name);
  if (!preset || !m_context.session.scene().volume)
    return;
  show(*preset, tr("use preset %1").arg(presetWords(name)));
  const Preset known = *find(name);
  if (isInOtherUnits(known))
    isBuiltIn(name) ? sayHowItWasFitted(known) : offerToFit(known);
  else if (showsNothing(preset->transferFunction, m_context.document.histogram()))
    offerWhereNothingShows(known);
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

void PresetController::compare(const QString& name) {
  if (const std::optional<Preset> preset = fitted(name); preset && m_context.session.scene().volume)
    emit compareRequested(*preset);
}

// Of two models both sides show the scene's own look: what stands at the other side of a preset is that.
void PresetController::useOnSide(const QString& name, int side) {
  const ViewOrder& order = m_context.view.order();
  const bool isSingle = order.comparison.layout == CompareLayout::single;
  if (isSingle || (order.comparison.look && side == 1))
    return use(name);
  if (side == 1) {
    const std::string own = m_context.document.presetInUse().name;
    Preset shown = presetOf(m_context.session.scene(), own.empty() ? tr("Before").toStdString() : own);
    shown.isWhole = true;
    emit compareRequested(shown);
  }
  side == 1 ? use(name) : compare(name);
}

void PresetController::fillMenu(QMenu& menu, int side) {
  menu.clear();
  const ViewOrder& order = m_context.view.order();
  const bool isCompared = order.comparison.look && order.comparison.layout != CompareLayout::single;
  const std::string shown =
      isCompared && side == 0 ? order.comparison.look->shown.name : m_context.document.presetInUse().name;
  for (const QString& name : m_browser.presets()) {
    QAction* action = menu.addAction(presetWords(name).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                                     [this, name, side] { useOnSide(name, side); });
    action->setCheckable(true);
    action->setChecked(name.toStdString() == shown);
  }
}

void PresetController::show(const Preset& preset, const QString& edit) {
  if (const std::optional<Scene> ofPart = m_shownAs(preset))
    m_context.session.edit(*ofPart, {nextGestureId(), edit});
  else
    m_context.session.usePreset(asUsed(preset), {nextGestureId(), edit});
  markShown(); // one that changes nothing is in use as well
}

void PresetController::sayHowItWasFitted(const Preset& preset) {
  const QString name = presetWords(QString::fromStdString(preset.name));
  const Landmarks to = landmarksOf(m_context.document.histogram());
  const auto number = [](double value) { return digitsNumber(value, 4); };
  const auto leaveIt = [this, preset, name, volume = m_context.session.scene().volume] {
    if (m_context.session.scene().volume == volume)
      show(preset, tr("use preset %1").arg(name));
  };
  say(tr("\"%1\" was fitted by this volume's own values: air lies at %2 (instead of %3 HU), tissue begins at "
         "%4 "
         "(%5 HU), the brightest is %6 (%7 HU).")
          .arg(name, number(to.background), number(hounsfieldLandmarks.background), number(to.object),
               number(hounsfieldLandmarks.object), number(to.brightest),
               number(hounsfieldLandmarks.brightest)),
      {tr("Use it as it is"), leaveIt});
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
  m_said = sentence;
  m_saidOf = m_context.document.presetInUse().name;
  m_context.messages.show(action.text.isEmpty() ? MessageBar::Kind::note : MessageBar::Kind::warning,
                          sentence, {}, action);
}

void PresetController::useNumber(int number) {
  if (!m_context.session.scene().volume)
    return;
  if (number == 0) {
    m_context.session.setTransferFunction(
        automaticRamp(m_context.document.histogram(), m_context.session.scene().volume->grid()),
        {nextGestureId(), tr("use the full range")});
    return;
  }
  if (const QStringList listed = m_browser.presets(); number <= listed.size())
    use(listed[number - 1]);
}

void PresetController::askForName() {
  if (!m_context.session.scene().volume)
    return;
  const QString inUse = QString::fromStdString(m_context.document.presetInUse().name);
  const std::vector<Preset> own = m_store.read().presets;
  const QString proposed = inUse.isEmpty()                  ? tr("My preset")
                           : named(own, inUse) != own.end() ? inUse
                                                            : tr("My %1").arg(inUse);
  ask(tr("Save as preset"), tr("Name:"), proposed, [this](const QString& name) { save(name); });
}

void PresetController::ask(const QString& title, const QString& label, const QString& name,
                           const std::function<void(const QString&)>& answer) {
  auto* dialog = new QInputDialog(&m_context.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->setLabelText(label);
  dialog->setTextValue(name);
  dialog->setOkButtonText(tr("Save"));
  const auto* buttons = dialog->findChild<QDialogButtonBox*>();
  connect(dialog, &QInputDialog::textValueChanged, buttons, [buttons](const QString& entered) {
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!entered.trimmed().isEmpty());
  });
  connect(dialog, &QInputDialog::textValueSelected, this,
          [answer](const QString& entered) { answer(entered.trimmed()); });
  dialog->open();
}

// A name of a preset of the user's own; says why not.
bool PresetController::mayBeCalled(const QString& name) const {
  const bool isTaken = isBuiltIn(name);
  if (name.isEmpty() || isTaken)
    m_context.messages.show(MessageBar::Kind::error,
                            isTaken ? tr("\"%1\" is a built-in preset; choose another name.").arg(name)
                                    : tr("A preset needs a name."));
  return !name.isEmpty() && !isTaken;
}

void PresetController::save(const QString& name) {
  if (!mayBeCalled(name))
    return;
  if (named(m_own, name) != m_own.end() && !mayReplace(name))
    return;
  Preset preset = presetOf(m_context.session.scene(), name.toStdString());
  // Values without a unit mean something beside those of their own volume alone.
  if (const auto& volume = m_context.session.scene().volume; !looksLikeHounsfield(*volume))
    preset.landmarks = landmarksOf(m_context.document.histogram());
  // What opening sets belongs to the slices of the volume.
  if (const Grid& grid = m_context.session.scene().volume->grid();
      preset.shading && preset.shading->gradientSmoothing == smoothingOfSlices(grid))
    preset.shading->gradientSmoothing = 0.0;
  std::optional<Preset> replaced;
  if (const auto before = named(m_own, name); before != m_own.end()) {
    replaced = *before;
    preset.note = before->note;
    preset.folder = before->folder;
  }
  const auto write = [&] {
    m_store.save(preset);
    refresh();
    m_context.session.adoptPreset(preset);
    markShown();
    m_browser.reveal(name);
    if (replaced)
      offerBack(*replaced, tr("\"%1\" was replaced by what is shown.").arg(name), tr("Take the old one back"),
                false);
  };
  m_context.notes.attempt(write);
}

// Names are typed with ease, so it is asked; all the same what was is brought back by one click.
bool PresetController::mayReplace(const QString& name) {
  QMessageBox box(QMessageBox::Question, tr("Replace preset"),
                  tr("There is a preset \"%1\" already. Replace it by what is shown?").arg(name),
                  QMessageBox::Cancel, &m_context.window);
  box.setObjectName(QStringLiteral("replacePreset"));
  const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::AcceptRole);
  box.exec();
  return box.clickedButton() == replace;
}

void PresetController::offerBack(const Preset& preset, const QString& sentence, const QString& label,
                                 bool isFavourite) {
  const auto bringBack = [this, preset, isFavourite] {
    m_context.notes.attempt([&] {
      m_store.save(preset);
      if (isFavourite)
        m_context.settings.setFavourite(preset.name, true);
      refresh();
      markShown();
    });
  };
  say(sentence, {label, bringBack});
  m_saidOf.clear(); // it holds whatever is shown
}

void PresetController::remove(const QString& name) {
  const auto known = named(m_own, name);
  if (known == m_own.end())
    return;
  Preset removed = *known;
  try {
    m_store.remove(removed.name);
    const bool isFavourite = m_context.settings.favourites().contains(removed.name);
    if (isFavourite)
      m_context.settings.setFavourite(removed.name, false);
    refresh();
    offerBack(removed, tr("\"%1\" was deleted.").arg(name), tr("Bring it back"), isFavourite);
  } catch (const Error& error) {
    m_context.messages.show(MessageBar::Kind::error, translated(error.sentence()));
  }
}

void PresetController::rename(const QString& name) {
  const auto give = [this, name](const QString& entered) {
    const auto found = named(m_own, name);
    if (entered == name || found == m_own.end() || !mayBeCalled(entered))
      return;
    if (named(m_own, entered) != m_own.end())
      return m_context.messages.show(
          MessageBar::Kind::error, tr("There is a preset \"%1\" already; choose another name.").arg(entered));
    m_context.notes.attempt([&] {
      Preset renamed = *found;
      renamed.name = entered.toStdString();
      m_store.save(renamed);
      m_store.remove(name.toStdString());
      if (m_context.settings.favourites().contains(name.toStdString())) {
        m_context.settings.setFavourite(name.toStdString(), false);
        m_context.settings.setFavourite(renamed.name, true);
      }
      if (Preset inUse = m_context.session.preset(); inUse.name == name.toStdString()) {
        inUse.name = renamed.name;
        m_context.session.adoptPreset(inUse);
      }
      refresh();
      markShown();
    });
  };
  ask(tr("Rename preset"), tr("New name:"), name, give);
}

void PresetController::setFavourite(const QString& name, bool isFavourite) {
  m_context.settings.setFavourite(name.toStdString(), isFavourite);
  showStanding();
}

void PresetController::change(const QString& name, const std::function<void(Preset&)>& edit) {
  const auto found = named(m_own, name);
  if (found == m_own.end())
    return;
  Preset changed = *found;
  edit(changed);
  m_context.notes.attempt([&] {
    m_store.save(changed);
    refresh();
  });
}

void PresetController::editNote(const QString& name) {
  const Preset* preset = find(name);
  if (!preset)
    return;
  ask(tr("Note of \"%1\"").arg(name), tr("What it shows, in one sentence:"),
      QString::fromStdString(preset->note), [this, name](const QString& note) {
        change(name, [&](Preset& changed) { changed.note = note.toStdString(); });
      });
}

void PresetController::moveTo(const QString& name, const QString& folder) {
  change(name, [&](Preset& changed) { changed.folder = folder.toStdString(); });
}

void PresetController::moveToNewFolder(const QString& name) {
  ask(tr("New folder"), tr("Folder for \"%1\":").arg(name), {},
      [this, name](const QString& folder) { moveTo(name, folder); });
}

void PresetController::duplicate(const QString& name) {
  const std::optional<Preset> preset = fitted(name);
  if (!preset)
    return;
  const auto keep = [this, copy = *preset](const QString& entered) mutable {
    if (!mayBeCalled(entered))
      return;
    copy.name = entered.toStdString();
    m_context.notes.attempt([&] {
      m_store.save(copy);
      refresh();
      m_browser.reveal(entered);
    });
  };
  ask(tr("Duplicate preset"), tr("Name of the copy (a preset of the same name is replaced):"),
      tr("%1 copy").arg(name), keep);
}

} // namespace limn
