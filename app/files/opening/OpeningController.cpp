// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/OpeningController.h"

#include "app/asking/FileDialogs.h"
#include "app/document/DocumentText.h"
#include "app/files/opening/RecentMenu.h"
#include "app/files/opening/SeriesDialog.h"
#include "app/window/WindowContext.h"
#include "io/looks/dicom/DicomLook.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/panels/ViewPanels.h"

#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>

#include <algorithm>

namespace limn {
namespace {

// Of the patterns of a dialog those for files of scanners, which have no ending: on media they are called by
// eight characters at most (DICOM PS3.10, 8.2), elsewhere often by their UID, which ends in a digit.
QString namesWithoutEnding() {
  QString patterns = QStringLiteral(" *[0-9]");
  for (int length = 1; length <= 8; ++length)
    patterns += QLatin1Char(' ') + QStringLiteral("[!.]").repeated(length);
  return patterns;
}

QString missingVolumeText(NamedBy by, const QString& expected) {
  switch (by) {
  case NamedBy::look:
    return OpeningController::tr("The series that this look belongs to is not beside it.");
  case NamedBy::session:
    return OpeningController::tr("The session's volume is not where the session expects it: %1.")
        .arg(expected);
  case NamedBy::picture:
    return OpeningController::tr("The volume of this picture is not where the picture expects it: %1.")
        .arg(expected);
  default:
    return OpeningController::tr("The scene's volume is not where the scene expects it: %1.").arg(expected);
  }
}

// As a label ends that tells of its volume (plainDescription).
QString descriptionOf(const SeriesSummary& series) {
  const QString size = QStringLiteral("%1×%2×%3").arg(series.dims.x).arg(series.dims.y).arg(series.dims.z);
  return series.modality.empty() ? size : QString::fromStdString(series.modality) + QLatin1Char(' ') + size;
}

} // namespace

// A disk that does not answer holds nothing up that lies on another.
VolumeLoader::VolumeLoader(QObject* parent) : QObject(parent), m_work(nullptr, BackgroundWork::Turn::atOnce) {
  connect(&m_work, &BackgroundWork::progressed, this, &VolumeLoader::progressed);
  connect(&m_work, &BackgroundWork::failed, this,
          [this](const QString& sentence) { emit failed(m_source, sentence); });
}

void VolumeLoader::start(const QString& source, const SourceOptions& options, std::function<void()> before) {
  m_source = source;
  m_work.start([this, source, options,
                before = std::move(before)](const BackgroundWork::Line& line) -> BackgroundWork::Deliver {
    if (before)
      before();
    const Progress progress{line.report, line.effort.isCancelled};
    try {
      SourceOptions asking = options;
      asking.asksForSeries = true;
      const LoadedScene scene = loadScene(source.toStdString(), asking, progress);
      const Histogram histogram = histogramOf(*scene.scene.volume, 1024, effortOf(progress, countingVoxels));
      return [this, scene, histogram] { emit loaded(scene, histogram); };
    } catch (const SeveralSeries& several) {
      return [this, source, dicom = several.dicom()] { emit seriesFound(source, dicom); };
    } catch (const VolumeMissing& error) {
      return [this, source, sentence = translated(error), expected = error.expected().string(),
              by = error.by()] {
        emit failed(source, sentence);
        emit volumeMissing(source, QString::fromStdString(expected), by);
      };
    } catch (const LabelsMissing& error) {
      return [this, source, sentence = translated(error), expected = error.expected().string()] {
        emit failed(source, sentence);
        emit labelsMissing(source, QString::fromStdString(expected));
      };
    }
  });
}

void VolumeLoader::cancel() {
  if (!m_work.isRunning())
    return;
  m_work.cancel();
  emit cancelled();
}

OpeningController::OpeningController(WindowContext& context, std::function<std::function<void()>()> before)
    : QObject(&context.window), m_context(context),
      m_recent(context.actions.addMenu(tr("Open &recent"), {Menu::file, 1, 6})),
      m_entries(new RecentMenu(*m_recent)), m_before(std::move(before)) {
  m_recent->setObjectName(QStringLiteral("recentSources"));
  connect(m_recent, &QMenu::aboutToShow, this, &OpeningController::refreshRecent);
  connect(m_entries, &RecentMenu::chosen, this, &OpeningController::openRecent);
  connect(m_entries, &RecentMenu::removed, this,
          [this](int number) { removeRecent(m_context.settings.recentSources().value(number).path); });
  connect(m_entries, &RecentMenu::cleared, this, &OpeningController::clearRecent);
  addActions();
  connectLoader();
  connectEmptyPanel();
  connect(&context.view, &CompareView::loadingCancelled, this, &OpeningController::cancel);
  connect(&context.session.undoStack(), &QUndoStack::indexChanged, this, &OpeningController::leaveFailure);
  refreshRecent();
}

void OpeningController::addActions() {
  ActionList& actions = m_context.actions;
  QAction* file =
      actions.add(QStringLiteral("openFile"),
                  {.text = tr("&Open file…"),
                   .place = {Menu::file, 1, 1},
                   .shortcut = QKeySequence::Open,
                   .toolTip = tr("Opens a volume, a session, a scene or a picture that Limn saved."),
                   .icon = QStringLiteral("open"),
                   .iconText = tr("Open")});
  const QAction* folder = actions.add(
      QStringLiteral("openFolder"),
      {.text = tr("Open &DICOM folder…"), .place = {Menu::file, 1, 2}, .shortcut = tr("Ctrl+Shift+O")});
  const QAction* sample = actions.add(QStringLiteral("openSample"),
                                      {.text = tr("Open the sample &head"), .place = {Menu::file, 1, 3}});
  QAction* clear = actions.add(
      QStringLiteral("clearRecent"),
      {.text = tr("Clear recent files"),
       .toolTip = tr("Empties the list of recent files, and with it where volumes lie and dialogs open.")});
  actions.addSetting({.row = 6, .action = clear});
  connect(file, &QAction::triggered, this, &OpeningController::askForFile);
  connect(folder, &QAction::triggered, this, &OpeningController::askForFolder);
  connect(sample, &QAction::triggered, this, &OpeningController::openSample);
  connect(clear, &QAction::triggered, this, &OpeningController::clearRecent);
  QToolButton* button = actions.makeMenuButton(QStringLiteral("openButton"), QToolButton::MenuButtonPopup);
  button->setDefaultAction(file);
  actions.addMenuButton(*button, m_recent, {1, 1});
}

void OpeningController::connectLoader() {
  connect(&m_loader, &VolumeLoader::progressed, &m_context.view, &CompareView::setLoading);
  connect(&m_loader, &VolumeLoader::cancelled, &m_context.view, &CompareView::clearLoading);
  connect(&m_loader, &VolumeLoader::seriesFound, this, &OpeningController::findSeries);
  connect(&m_loader, &VolumeLoader::loaded, this,
          [this](const LoadedScene& scene, const Histogram& histogram) {
            m_context.view.clearLoading();
            rememberFolder();
            emit loaded(scene, histogram, m_requested);
          });
  connect(&m_loader, &VolumeLoader::failed, this, &OpeningController::sayFailure);
  connect(&m_loader, &VolumeLoader::volumeMissing, this,
          [this](const QString& source, const QString& expected, NamedBy by) {
            m_failure = missingVolumeText(by, expected);
            m_context.messages.show(MessageBar::Kind::error, m_failure, {},
                                    {tr("Locate volume…"), [this, source] { locateVolume(source); }});
          });
  connect(&m_loader, &VolumeLoader::labelsMissing, this,
          [this](const QString& source, const QString& expected) {
            m_context.messages.show(
                MessageBar::Kind::error, m_failure, {},
                {tr("Locate labels…"), [this, source, expected] { locateLabels(source, expected); }}, {},
                {tr("Open without labels"), [this, source] { openWithoutLabels(source); }});
          });
}

void OpeningController::connectEmptyPanel() {
  const EmptyPanel* empty = &m_context.view.emptyPanel();
  connect(empty, &EmptyPanel::openFolderRequested, this, &OpeningController::askForFolder);
  connect(empty, &EmptyPanel::openFileRequested, this, &OpeningController::askForFile);
  connect(empty, &EmptyPanel::sampleRequested, this, &OpeningController::openSample);
  connect(empty, &EmptyPanel::recentRequested, this, &OpeningController::openRecent);
  connect(empty, &EmptyPanel::recentRemovalRequested, m_entries, &RecentMenu::removed);
}

// What was opened before stays in the list, and nobody has typed its name: it may lie on a drive that is not
// connected just now.
void OpeningController::sayFailure(const QString& source, const QString& sentence) {
  m_context.view.clearLoading();
  const bool isGone = m_again.path == source && QFileInfo(source).isAbsolute() && !QFileInfo::exists(source);
  m_failure =
      isGone ? tr("%1 is not where it was: it was moved or deleted, or its drive or network folder is not "
                  "connected.")
                   .arg(m_again.label)
             : sentence;
  const QList<RecentSource> recent = m_context.settings.recentSources();
  if (std::ranges::none_of(recent, [&](const RecentSource& one) { return one.path == source; }))
    return m_context.showError(m_failure);
  m_context.messages.show(MessageBar::Kind::error, m_failure, {},
                          {tr("Remove from recent files"), [this, source] {
                             m_context.messages.hide();
                             removeRecent(source);
                           }});
}

void OpeningController::open(const QString& source, const SourceOptions& options) {
  // A path means the same from wherever the next window is started.
  const QString path = QString::fromStdString(absoluteSource(source.toStdString()));
  if (holdsLooks(path)) {
    emit looksChosen({path});
    return;
  }
  // Whom the file shows is known once it is read; until then its name is shown only where a patient's may be.
  start({path, options}, m_context.settings.patientIsShown().value_or(false)
                             ? tr("Opening %1").arg(QFileInfo(path).fileName())
                             : tr("Opening the volume"));
}

void OpeningController::restore(const QString& session) {
  start({session, {}, true}, tr("Restoring the session"));
}

// A decoder that crashes takes the window along; so what is shown is put on the disk before one begins.
void OpeningController::start(const Request& request, const QString& what) {
  m_context.messages.hide();
  m_requested = request;
  m_again = {};
  SourceOptions known = withKnownVolumes(request.options);
  known.hidesTable = true;
  known.smoothsSlices = true;
  if (!known.read.memory)
    known.read.memory = m_context.memory;
  m_context.view.setLoading(-1.0, what);
  m_loader.start(request.source, known, m_before());
}

SourceOptions OpeningController::withKnownVolumes(SourceOptions options) const {
  options.knownVolumes = m_context.settings.knownVolumes();
  options.references = m_context.settings.references();
  return options;
}

// One that was turned by hand is another volume than its file's.
SourceOptions OpeningController::optionsNow() const {
  SourceOptions options = withKnownVolumes(m_context.document.request().options);
  const std::shared_ptr<const Volume>& volume = m_context.document.scene().volume;
  if (volume && volume->info().orientationByHand.empty())
    options.opened.emplace(m_context.document.volumePath(), volume);
  return options;
}

void OpeningController::locateVolume(const QString& scene) {
  const QString path =
      askWhatToOpen(&m_context.window,
                    {.title = tr("Where is the volume of %1?").arg(QFileInfo(scene).fileName()),
                     .isFolder = isDicomLookFile(scene.toStdString())}, // many images
                    m_context.settings);
  if (path.isEmpty())
    return;
  Request request = m_requested;
  request.source = scene;
  request.options.volume = path.toStdString();
  start(request, tr("Opening the volume"));
}

void OpeningController::locateLabels(const QString& scene, const QString& expected) {
  const QString path = askWhatToOpen(
      &m_context.window, {.title = tr("Where are the labels %1?").arg(QFileInfo(expected).fileName())},
      m_context.settings);
  if (path.isEmpty())
    return;
  Request request = m_requested;
  request.source = scene;
  request.options.labels[expected.toStdString()] = path.toStdString();
  start(request, tr("Opening the volume"));
}

void OpeningController::openWithoutLabels(const QString& scene) {
  Request request = m_requested;
  request.source = scene;
  request.options.leavesLabelsOut = true;
  start(request, tr("Opening the volume"));
}

void OpeningController::askForFile() {
  const QString path = askWhatToOpen(
      &m_context.window,
      {.title = tr("Open a volume, session, scene or Limn picture"),
       .filters =
           QStringList{tr("Everything Limn reads (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.dcm "
                          "*.inv3 *.hdr *.tif *.tiff *.png *.jpg *.json *.exr *.pdf *.vp *.plist *.itf "
                          "*.clut *.tfi *.1dt)")
                           .chopped(1) +
                       namesWithoutEnding() + QLatin1Char(')')} +
           readLookFilters()},
      m_context.settings);
  if (!path.isEmpty())
    open(path);
}

void OpeningController::askForFolder() {
  const QString path = askWhatToOpen(&m_context.window,
                                     {.title = tr("Open a DICOM folder or an image stack"), .isFolder = true},
                                     m_context.settings);
  if (!path.isEmpty())
    open(path);
}

// Of a folder that is opened again the series that it says is opened. Numbers follow from what lies in the
// folder: where that has changed, people choose.
void OpeningController::findSeries(const QString& source, const std::shared_ptr<const DicomFolder>& dicom) {
  const int before = m_again.path == source ? m_again.series : 0;
  const std::vector<SeriesSummary> all = dicom->summaries();
  const auto same = std::ranges::find(all, before, &SeriesSummary::number);
  if (same != all.end() && m_again.label.endsWith(descriptionOf(*same)))
    readSeries(source, dicom, before);
  else
    chooseSeries(source, dicom, before);
}

void OpeningController::chooseSeries(const QString& source, const std::shared_ptr<const DicomFolder>& dicom,
                                     int chosen) {
  m_context.view.clearLoading();
  auto* dialog = new SeriesDialog(dicom->summaries(), &m_context.window, chosen);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SeriesDialog::seriesChosen, this,
          [this, source, dicom](int number) { readSeries(source, dicom, number); });
  dialog->open();
}

void OpeningController::readSeries(const QString& source, const std::shared_ptr<const DicomFolder>& dicom,
                                   int number) {
  SourceOptions options = m_requested.options;
  options.read.series = number;
  options.dicom = dicom;
  open(source, options);
}

void OpeningController::askForSpacing(const Request& shown, const glm::dvec3& spacingMm) {
  auto* dialog = new QInputDialog(&m_context.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Voxel spacing"));
  dialog->setLabelText(tr("Distance between voxel centres along x, y and z in millimetres:"));
  dialog->setTextValue(numberList({spacingMm.x, spacingMm.y, spacingMm.z}));
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, shown](const QString& entered) { readWithSpacing(shown, entered); });
  dialog->open();
}

void OpeningController::readWithSpacing(const Request& shown, const QString& entered) {
  const auto typed = numbersTyped(entered);
  const bool valid =
      typed && typed->size() == 3 && std::ranges::all_of(*typed, [](double mm) { return mm > 0.0; });
  if (!valid) {
    m_context.messages.show(MessageBar::Kind::error,
                            tr("The spacing must be three positive numbers, such as 0.5, 0.5, 1.2."));
    return;
  }
  SourceOptions options = shown.options;
  options.read.spacingMm = glm::dvec3((*typed)[0], (*typed)[1], (*typed)[2]);
  open(shown.source, options);
}

void OpeningController::rememberFolder() {
  const auto& located = m_requested.options.volume;
  const QString opened = located ? QString::fromStdString(located->string()) : m_requested.source;
  // What Limn kept lies where nobody looks, the sample nowhere.
  if (!m_requested.isUnsavedSession && QFileInfo::exists(opened))
    rememberFolderOf(opened, m_context.settings);
}

void OpeningController::leaveFailure() {
  if (!m_failure.isEmpty() && m_context.messages.sentence() == m_failure)
    m_context.messages.hide();
  m_failure.clear();
}

void OpeningController::remember(const QString& path, const QString& label, const std::string& volume,
                                 int series) {
  m_context.settings.addRecentSource(path, label, series);
  if (std::filesystem::path(volume).is_absolute())
    m_context.settings.addKnownVolume(volume);
  refreshRecent();
}

// What was opened before, latest first, as a list shows it: equal labels carry a date.
QStringList OpeningController::recentTexts() {
  const QList<RecentSource> recent = m_context.settings.recentSources();
  QStringList texts;
  for (const RecentSource& source : recent) {
    const bool isAlone = std::count_if(recent.begin(), recent.end(), [&](const RecentSource& other) {
                           return other.label == source.label;
                         }) == 1;
    texts << (isAlone ? source.label : tr("%1, opened %2").arg(source.label, momentText(source.openedAt())));
  }
  return texts;
}

void OpeningController::openRecent(int number) {
  const QList<RecentSource> recent = m_context.settings.recentSources();
  if (number < 0 || number >= recent.size())
    return;
  open(recent[number].path);
  m_again = recent[number];
}

void OpeningController::clearRecent() {
  m_context.settings.clearRecentSources();
  m_recent->setEnabled(false);
  m_context.view.emptyPanel().setRecentSources({});
}

void OpeningController::removeRecent(const QString& path) {
  m_context.settings.removeRecentSource(path);
  refreshRecent();
}

void OpeningController::refreshRecent() {
  const QStringList texts = recentTexts();
  m_entries->setTexts(texts);
  m_context.view.emptyPanel().setRecentSources(texts);
}

} // namespace limn
