// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening/OpeningDesk.h"

#include "app/Settings.h"
#include "app/opening/OpenDialog.h"
#include "app/opening/SeriesDialog.h"
#include "app/presets/LookFiles.h"
#include "app/window/MessageBar.h"
#include "io/looks/dicom/DicomLook.h"
#include "widgets/ValueText.h"

#include <QAction>
#include <QDateTime>
#include <QFileInfo>
#include <QInputDialog>
#include <QLocale>
#include <QMenu>

#include <algorithm>

namespace limn {

OpeningDesk::OpeningDesk(Settings& settings, const QAction& showsPatient, QMenu& recent, MessageBar& messages,
                         std::function<std::function<void()>()> before,
                         const std::optional<MemoryBudget>& memory, QWidget& window)
    : QObject(&window), m_settings(settings), m_showsPatient(showsPatient), m_recent(recent),
      m_messages(messages), m_before(std::move(before)), m_memory(memory), m_window(window) {
  connect(&m_loader, &VolumeLoader::progressed, this, &OpeningDesk::progressed);
  connect(&m_loader, &VolumeLoader::cancelled, this, &OpeningDesk::ended);
  connect(&m_loader, &VolumeLoader::seriesFound, this, &OpeningDesk::chooseSeries);
  connect(&m_loader, &VolumeLoader::loaded, this,
          [this](const LoadedScene& scene, const Histogram& histogram) {
            emit ended();
            emit loaded(scene, histogram, m_requested);
          });
  connect(&m_loader, &VolumeLoader::failed, this, [this](const QString& source, const QString& sentence) {
    emit ended();
    m_settings.removeRecentSource(source);
    refreshRecent();
    m_messages.show(MessageBar::Kind::error, sentence);
    m_failure = sentence;
  });
  connect(&m_loader, &VolumeLoader::volumeMissing, this,
          [this](const QString& source, const QString& expected) {
            m_failure = isDicomLookFile(source.toStdString())
                            ? tr("The series that this look belongs to is not beside it.")
                            : tr("The scene's volume is not where the scene expects it: %1.").arg(expected);
            m_messages.show(MessageBar::Kind::error, m_failure, {},
                            {tr("Locate volume…"), [this, source] { locateVolume(source); }});
          });
  connect(&recent, &QMenu::aboutToShow, this, &OpeningDesk::refreshRecent);
  refreshRecent();
}

void OpeningDesk::open(const QString& source, const SourceOptions& options) {
  // A path means the same from wherever the next window is started.
  const QString path = QString::fromStdString(absoluteSource(source.toStdString()));
  if (holdsLooks(path)) {
    emit looksChosen({path});
    return;
  }
  // Whom the file shows is known once it is read; until then its name is shown only where a patient's may be.
  start({path, options}, m_showsPatient.isChecked() ? tr("Opening %1").arg(QFileInfo(path).fileName())
                                                    : tr("Opening the volume"));
}

void OpeningDesk::restore(const QString& session) {
  start({session, {}, true}, tr("Restoring the session"));
}

// A decoder that crashes takes the window along; so what is shown is put on the disk before one begins.
void OpeningDesk::start(const Request& request, const QString& what) {
  m_messages.hide();
  m_requested = request;
  SourceOptions known = request.options;
  known.knownVolumes = m_settings.knownVolumes();
  known.references = m_settings.references();
  known.hidesTable = true;
  if (!known.read.memory)
    known.read.memory = m_memory;
  emit progressed(-1.0, what);
  m_loader.start(request.source, known, m_before());
}

void OpeningDesk::locateVolume(const QString& scene) {
  const QString path =
      askWhatToOpen(&m_window,
                    {.title = tr("Where is the volume of %1?").arg(QFileInfo(scene).fileName()),
                     .isFolder = isDicomLookFile(scene.toStdString())}, // many images
                    m_settings);
  if (path.isEmpty())
    return;
  Request request = m_requested;
  request.source = scene;
  request.options.volume = path.toStdString();
  start(request, tr("Opening the volume"));
}

void OpeningDesk::askForFile() {
  const QString path = askWhatToOpen(
      &m_window,
      {.title = tr("Open a volume, session, scene or Limn picture"),
       .filters =
           QStringList{tr("Everything Limn reads (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.dcm "
                          "*.inv3 *.hdr *.tif *.tiff *.png *.jpg *.json *.exr *.pdf *.vp *.plist *.itf "
                          "*.clut *.tfi *.1dt)")} +
           readLookFilters()},
      m_settings);
  if (!path.isEmpty())
    open(path);
}

void OpeningDesk::askForFolder() {
  const QString path = askWhatToOpen(
      &m_window, {.title = tr("Open a DICOM folder or an image stack"), .isFolder = true}, m_settings);
  if (!path.isEmpty())
    open(path);
}

void OpeningDesk::chooseSeries(const QString& source, const std::vector<SeriesSummary>& series) {
  emit ended();
  auto* dialog = new SeriesDialog(series, &m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SeriesDialog::seriesChosen, this, [this, source](int number) {
    SourceOptions options = m_requested.options;
    options.read.series = number;
    open(source, options);
  });
  dialog->open();
}

void OpeningDesk::askForSpacing(const Request& shown, const glm::dvec3& spacingMm) {
  auto* dialog = new QInputDialog(&m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Voxel spacing"));
  dialog->setLabelText(tr("Distance between voxel centres along x, y and z in millimetres:"));
  dialog->setTextValue(numberList({spacingMm.x, spacingMm.y, spacingMm.z}));
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, shown](const QString& entered) { readWithSpacing(shown, entered); });
  dialog->open();
}

void OpeningDesk::readWithSpacing(const Request& shown, const QString& entered) {
  const auto typed = numbersTyped(entered);
  const bool valid =
      typed && typed->size() == 3 && std::ranges::all_of(*typed, [](double mm) { return mm > 0.0; });
  if (!valid) {
    m_messages.show(MessageBar::Kind::error,
                    tr("The spacing must be three positive numbers, such as 0.5, 0.5, 1.2."));
    return;
  }
  SourceOptions options = shown.options;
  options.read.spacingMm = glm::dvec3((*typed)[0], (*typed)[1], (*typed)[2]);
  open(shown.source, options);
}

void OpeningDesk::leaveFailure() {
  if (!m_failure.isEmpty() && m_messages.sentence() == m_failure)
    m_messages.hide();
  m_failure.clear();
}

void OpeningDesk::remember(const QString& path, const QString& label, const std::string& volume) {
  m_settings.addRecentSource(path, label);
  if (std::filesystem::path(volume).is_absolute())
    m_settings.addKnownVolume(volume);
  refreshRecent();
}

// What was opened before, latest first, as a list shows it: equal labels carry a date.
QStringList OpeningDesk::recentTexts() {
  const QList<RecentSource> recent = m_settings.recentSources();
  QStringList texts;
  for (const RecentSource& source : recent) {
    const bool isAlone = std::count_if(recent.begin(), recent.end(), [&](const RecentSource& other) {
                           return other.label == source.label;
                         }) == 1;
    const QDateTime opened = QDateTime::fromString(source.opened, Qt::ISODateWithMs).toLocalTime();
    texts << (isAlone
                  ? source.label
                  : tr("%1, opened %2").arg(source.label, QLocale().toString(opened, QLocale::ShortFormat)));
  }
  return texts;
}

void OpeningDesk::openRecent(int number) {
  const QList<RecentSource> recent = m_settings.recentSources();
  if (number >= 0 && number < recent.size())
    open(recent[number].path);
}

void OpeningDesk::clearRecent() {
  m_settings.clearRecentSources();
  m_recent.setEnabled(false);
  emit recentChanged({});
}

void OpeningDesk::refreshRecent() {
  m_recent.clear();
  const QStringList texts = recentTexts();
  for (int number = 0; number < texts.size(); ++number)
    m_recent.addAction(QString(texts[number]).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                       [this, number] { openRecent(number); });
  m_recent.setEnabled(!m_recent.isEmpty());
  m_recent.addSeparator();
  m_recent.addAction(tr("&Clear this list"), this, &OpeningDesk::clearRecent);
  emit recentChanged(texts);
}

} // namespace limn
