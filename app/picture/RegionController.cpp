// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/RegionController.h"

#include "app/asking/FileDialogs.h"
#include "app/document/PrivateNames.h"
#include "app/window/WindowContext.h"
#include "io/labels/LabelNames.h"
#include "io/labels/MaskFolder.h"
#include "regions/Cutting.h"
#include "regions/LabelVoxels.h"
#include "scene/regions/BodyAndLabels.h"
#include "widgets/Translated.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <memory>
#include <optional>

namespace limn {
namespace {

// What was cut away first, so that one who wants that back keeps the table hidden; then the rest: labels stay
// open, each shown wholly, and a body goes. Cuts stay in their list, off where they hide something.
Region shownWholly(const Region& region) {
  Region whole;
  if (isCutAway(region)) {
    whole = withoutCuts(region);
  } else if (region.kind == Region::Kind::labels) {
    whole = withoutCuts(region);
    std::fill(whole.weights.begin(), whole.weights.end(), 1.0);
  }
  whole.cuts = region.cuts;
  for (Cut& cut : whole.cuts)
    cut.isOn = cut.isOn && !takesAway(cut);
  return whole;
}

// What is worked at for less is not said: a bar that flashes tells nobody anything.
constexpr int worthSayingMs = 300;

// What was hidden beside the body stays hidden, and what is shown beside it can be hidden again.
FoundRegion withTableOf(const Region& kept, FoundRegion found, const Volume& volume, const Region& body,
                        const Progress& progress) {
  const std::optional<std::size_t> before = tableLabel(kept);
  if (!before && !hidesTable(kept))
    return found;
  found.region = withBodyOf(found.region, volume, body, progress).region;
  const std::optional<std::size_t> table = tableLabel(found.region);
  if (before && table)
    found.region.weights[*table] = kept.weights[*before];
  return found;
}

// What undo calls it. A file that may be called after its patient is not named.
QString openingText(const QStringList& paths, const Volume& volume) {
  const QString name = QFileInfo(paths.front()).fileName();
  if (paths.size() > 1)
    return RegionController::tr("open labels of %1 files").arg(paths.size());
  return mayNameThePatient(name, volume.info().patient) ? RegionController::tr("open labels")
                                                        : RegionController::tr("open labels %1").arg(name);
}

// The file of labels, or how many there are, as a sentence names it: it may be read by whoever looks on.
QString namesOf(const Region& region, const Volume& volume) {
  const std::vector<std::string> sources = sourcesOf(region);
  if (sources.size() > 1)
    return RegionController::tr("%1 files").arg(sources.size());
  const QString name = QFileInfo(QString::fromStdString(sources.front())).fileName();
  return mayNameThePatient(name, volume.info().patient) ? RegionController::tr("one file") : name;
}

} // namespace

RegionController::RegionController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_offers(context) {
  const QAction* open = context.actions.add(
      QStringLiteral("openLabels"), {.text = tr("Open &labels…"),
                                     .place = {Menu::file, 1, 4},
                                     .toolTip = tr("Opens a segmentation of the volume, or the masks of "
                                                   "several files at once: each label can be shown, hidden "
                                                   "or faded."),
                                     .needsVolume = true});
  const QAction* openFolder = context.actions.add(
      QStringLiteral("openLabelFolder"),
      {.text = tr("Open a folder of mas&ks…"),
       .place = {Menu::file, 1, 5},
       .toolTip =
           tr("Opens a segmentation that has a file for each structure, as TotalSegmentator writes it: "
              "each becomes a label, called after its file."),
       .needsVolume = true});
  m_bodyOnly =
      context.actions.add(QStringLiteral("bodyOnly"),
                          {.text = tr("&Body only"),
                           .place = {Menu::view, 2, 8},
                           .toolTip = tr("Finds the body and hides the table, the head holder and what "
                                         "else lies beside it; labels that are open stay open."),
                           .isCheckable = true,
                           .needsVolume = true});
  connect(open, &QAction::triggered, this, &RegionController::askForLabels);
  connect(openFolder, &QAction::triggered, this, &RegionController::askForMasks);
  connect(m_bodyOnly, &QAction::triggered, this, &RegionController::setBodyOnly);
  connect(&m_offers, &RegionOffers::cutsWanted, this, &RegionController::setCuts);
  connect(&context.view.input(), &ViewInput::everythingRequested, this, &RegionController::showEverything);
  connect(&context.view, &CompareView::loadingCancelled, this, &RegionController::cancel);
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
  connect(&m_work, &BackgroundWork::progressed, this, [this](double done) {
    if (m_doingFor.elapsed() >= worthSayingMs)
      m_context.view.setLoading(done, m_doing);
  });
  connect(&m_work, &BackgroundWork::failed, this, [this](const QString& sentence) {
    const QString folder = QFileInfo(m_opening).isDir() ? m_opening : QString();
    end();
    // Pictures in a folder may as well be what is to be looked at.
    if (folder.isEmpty())
      m_context.showError(sentence);
    else
      m_context.messages.show(MessageBar::Kind::error, sentence, {},
                              {tr("Open it as a volume"), [this, folder] {
                                 m_context.messages.hide();
                                 const QFileInfoList files = QDir(folder).entryInfoList(QDir::Files);
                                 emit volumeMeant(files.size() == 1 ? files.front().filePath() : folder);
                               }});
  });
}

void RegionController::askForLabels() {
  const QStringList paths = askForPaths(
      &m_context.window,
      {.title = tr("Open the labels of this volume"),
       .filters = {tr("Segmentations (*.nrrd *.nhdr *.nii *.nii.gz *.dcm *.mha *.mhd *.vti *.vtk)"),
                   tr("All files (*)")},
       .isMany = true},
      m_context.settings);
  if (!paths.isEmpty())
    openLabelFiles(paths);
}

void RegionController::askForMasks() {
  const QString path = askWhatToOpen(&m_context.window,
                                     {.title = tr("Open a folder of masks of this volume"), .isFolder = true},
                                     m_context.settings);
  if (!path.isEmpty())
    openLabels(path);
}

void RegionController::openLabelFiles(const QStringList& chosen) {
  if (!m_volume)
    return;
  QStringList paths = chosen;
  paths.sort(); // and not in the order in which they were clicked
  std::vector<std::filesystem::path> files;
  for (const QString& path : paths)
    files.emplace_back(path.toStdString());
  openInOrder(files, {nextGestureId(), openingText(paths, *m_volume)});
}

void RegionController::openInOrder(const std::vector<std::filesystem::path>& files, const Gesture& gesture) {
  start(tr("Opening labels"), gesture,
        [files, body = m_body, opened = std::make_shared<std::optional<Segmentation>>()](
            const Region& kept, const Volume& volume, const Progress& progress) {
          if (!*opened)
            *opened = readBeside(files, volume, part(progress, 0.0, 0.8));
          const FoundRegion found = openedBeside(kept, **opened, volume, part(progress, 0.8, 1.0));
          return withTableOf(kept, found, volume, body, progress);
        });
  m_opening = QString::fromStdString(files.front().string());
}

MessageBar::Action RegionController::smallestOnTop(const FoundRegion& found) {
  if (found.smallestLast.empty())
    return {};
  return {tr("Smaller ones on top"), [this, files = found.smallestLast, volume = m_volume] {
            m_context.messages.hide();
            if (m_context.session.scene().volume == volume)
              openInOrder(files, {nextGestureId(), tr("smaller labels on top")});
          }};
}

void RegionController::setBodyOnly(bool isOn) {
  const Gesture gesture{nextGestureId(), tr("body only")};
  const Region& kept = m_context.session.scene().keep;
  if (kept.kind == Region::Kind::labels)
    hideTableBesideLabels(isOn, gesture);
  else if (!isOn)
    showEverything();
  else if (m_body.kind == Region::Kind::body)
    cut(m_body, m_context.session.scene().keep.cuts, gesture);
  else
    start(tr("Looking for the body"), gesture,
          [](const Region&, const Volume& volume, const Progress& progress) {
            return bodyOf(volume, progress);
          });
}

// The segmentation stays open; what is not the body is a label of its own.
void RegionController::hideTableBesideLabels(bool isHidden, const Gesture& gesture) {
  Region kept = m_context.session.scene().keep;
  if (const std::optional<std::size_t> table = tableLabel(kept)) {
    kept.weights[*table] = isHidden ? 0.0 : 1.0;
    setKeep(kept, gesture);
  } else if (isHidden) {
    start(tr("Looking for the body"), gesture,
          [body = m_body](const Region& labels, const Volume& volume, const Progress& progress) {
            // They may have been closed meanwhile.
            return labels.kind == Region::Kind::labels
                       ? withBodyOf(withoutCuts(labels), volume, body, progress)
                       : FoundRegion{labels, {}};
          });
  }
}

void RegionController::setKeep(const Region& region, const Gesture& gesture) {
  if (needsCutting(region))
    cut(region, region.cuts, gesture);
  else
    m_context.session.setKeep(region, gesture);
}

void RegionController::setCuts(const std::vector<Cut>& cuts, const QString& gesture) {
  cut(m_context.session.scene().keep, cuts, {nextGestureId(), gesture});
}

void RegionController::setCutsOf(const std::vector<Cut>& cuts, const Gesture& gesture) {
  cut(m_context.session.scene().keep, cuts, gesture);
  m_goesOn = m_work.isRunning();
}

void RegionController::addCut(const Cut& cut, const QString& gesture) {
  std::vector<Cut> cuts = m_cutsWanted.value_or(m_context.session.scene().keep.cuts);
  cuts.push_back(cut);
  setCuts(cuts, gesture);
}

// A region with these cuts, which a thread makes where any is on. Other names take no other voxels.
void RegionController::cut(const Region& region, const std::vector<Cut>& cuts, const Gesture& gesture) {
  if (!m_work.isRunning() && !needsCutting(region) && withoutNames(cuts) == withoutNames(region.cuts)) {
    Region named = region;
    named.cuts = cuts;
    return m_context.session.setKeep(named, gesture);
  }
  if (std::none_of(cuts.begin(), cuts.end(), [](const Cut& cut) { return cut.isOn; })) {
    cancel();
    Region uncut = withoutCuts(region);
    uncut.cuts = cuts;
    keep({uncut, {}}, gesture);
    return;
  }
  const bool isKept = region == m_context.session.scene().keep;
  start(tr("Cutting"), gesture,
        [region, isKept, cuts](const Region& kept, const Volume& volume, const Progress& progress) {
          return isKept ? cutIn(volume, kept, cutsOver(kept.cuts, region.cuts, cuts), progress)
                        : cutIn(volume, region, cuts, progress);
        });
  m_cutsWanted = cuts;
}

void RegionController::showEverything() {
  cancel();
  const Region shown = shownWholly(m_context.session.scene().keep);
  setKeep(shown,
          {nextGestureId(), isRestricting(shown) ? tr("show what was cut away") : tr("show everything")});
}

void RegionController::showScene(const Scene& scene) {
  if (scene.volume != m_volume) {
    cancel();
    m_volume = scene.volume;
    m_body = {};
  }
  m_offers.showScene(scene);
  if (scene.keep.kind == Region::Kind::body)
    m_body = withoutCuts(scene.keep);
  m_bodyOnly->setChecked(hidesTable(scene.keep));
  leaveWhatWasSaid(scene);
  measureLabels(scene);
}

// Once for each map; cuts leave a segmentation what it was.
void RegionController::measureLabels(const Scene& scene) {
  const bool hasLabels = scene.volume && scene.keep.kind == Region::Kind::labels;
  const std::shared_ptr<const LabelMap> labels = !hasLabels         ? nullptr
                                                 : scene.keep.isCut ? scene.keep.uncut
                                                                    : scene.keep.labels;
  if (labels == m_labels)
    return;
  m_labels = labels;
  m_measuring.cancel();
  emit labelsMeasured({}, nullptr);
  if (labels)
    m_measuring.start([this, labels, volume = scene.volume](const Effort& effort) -> BackgroundWork::Deliver {
      const std::vector<LabelFigures> figures = figuresOfLabels(*labels, *volume, effort);
      return [this, figures, volume] { emit labelsMeasured(figures, volume); };
    });
}

void RegionController::start(const QString& what, const Gesture& gesture, const Work& work) {
  cancel();
  m_goesOn = false;
  if (!m_volume)
    return;
  m_doing = what;
  m_doingFor.start();
  this->work(gesture, work);
}

void RegionController::work(const Gesture& gesture, const Work& work) {
  m_work.start([this, volume = m_volume, gesture, kept = m_context.session.scene().keep,
                work](const Effort& effort) -> BackgroundWork::Deliver {
    const Progress progress{[&effort](double done, const Message&) { effort.report(done); },
                            effort.isCancelled};
    FoundRegion found = work(kept, *volume, progress);
    // What was cut before stays cut when other things are kept.
    if (found.region.cuts.empty() && !kept.cuts.empty())
      found = cutIn(*volume, found, kept.cuts, progress);
    return [this, found, kept, gesture, work] {
      // What was edited or undone meanwhile holds.
      if (m_context.session.scene().keep != kept)
        return this->work(gesture, work);
      if (!m_opening.isEmpty())
        rememberFolderOf(m_opening, m_context.settings);
      end();
      keep(found, gesture);
    };
  });
}

void RegionController::keep(const FoundRegion& found, const Gesture& gesture) {
  const Region kept = m_context.session.scene().keep;
  const std::size_t before = kept.cuts.size();
  if (!m_goesOn && found.takesNothing && found.region.cuts.size() > before) {
    m_context.messages.show(MessageBar::Kind::warning, translated(found.remark));
    return;
  }
  m_context.session.setKeep(found.region, gesture);
  const bool isStep = m_context.session.scene().keep != kept;
  const std::size_t cuts = found.region.cuts.size();
  if (const auto label = cuts > before ? labelOfCut(found.region, cuts - 1) : std::nullopt)
    emit curveGiven(*label);
  if (m_goesOn)
    return showScene(m_context.session.scene());
  if (found.region.kind == Region::Kind::labels && replacesLabels(found.region, kept))
    sayWhatGaveWay(kept, found);
  else if (!found.remark.empty() && isRestricting(found.region))
    say(translated(found.remark), {}, {tr("Show everything"), [this] { showEverything(); }},
        smallestOnTop(found));
  else if (!found.remark.empty())
    say(translated(found.remark), {}, smallestOnTop(found));
  else
    return showScene(m_context.session.scene());
  if (isStep)
    m_context.messageGoesWithLastStep();
  showScene(m_context.session.scene());
}

// Cuts that came since hold for the labels that come back, too.
void RegionController::sayWhatGaveWay(const Region& before, const FoundRegion& found) {
  const auto bringBack = [this, before, volume = m_volume] {
    m_context.messages.hide();
    if (m_context.session.scene().volume != volume)
      return;
    Region labels = withoutCuts(before);
    labels.cuts = m_context.session.scene().keep.cuts;
    setKeep(labels, {nextGestureId(), tr("labels of before")});
  };
  const QString gaveWay = tr("The labels of %1 took the place of those of %2.")
                              .arg(namesOf(found.region, *m_volume), namesOf(before, *m_volume));
  say(found.covered.empty() ? gaveWay : gaveWay + QLatin1Char(' ') + translated(found.covered),
      found.remark.empty() ? QStringList() : QStringList{translated(found.remark)},
      {tr("Bring those back"), bringBack}, smallestOnTop(found));
}

void RegionController::say(const QString& sentence, const QStringList& details,
                           const MessageBar::Action& action, const MessageBar::Action& other) {
  m_said = sentence;
  const Scene& scene = m_context.session.scene();
  m_saidOf = {scene.volume, scene.keep.kind, sourcesOf(scene.keep)};
  m_context.messages.show(MessageBar::Kind::warning, sentence, details, action, {}, other);
}

// Where those labels or the body have gone otherwise than by undo, nothing that was said of them holds.
void RegionController::leaveWhatWasSaid(const Scene& scene) {
  const bool isSame = scene.volume && haveSameVoxels(scene.volume, m_saidOf.volume) &&
                      scene.keep.kind == m_saidOf.kind && sourcesOf(scene.keep) == m_saidOf.sources;
  if (m_said.isEmpty() || isSame)
    return;
  if (m_context.messages.sentence() == m_said)
    m_context.messages.hide();
  m_said.clear();
  m_saidOf = {};
}

void RegionController::cancel() {
  if (!m_work.isRunning())
    return;
  m_work.cancel();
  end();
}

void RegionController::end() {
  m_opening.clear();
  m_cutsWanted.reset();
  m_context.view.clearLoading();
  // A box that was checked for what did not come of it.
  m_bodyOnly->setChecked(hidesTable(m_context.session.scene().keep));
}

bool opensAsLabels(const QString& path) {
  return isNamedLikeLabels(path.toStdString()) || isMaskFolder(path.toStdString());
}

} // namespace limn
