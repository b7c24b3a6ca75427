// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/MessageBar.h"
#include "app/PrivateNames.h"
#include "app/SeriesDialog.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/scene/PropertiesPanel.h"

#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>

#include <algorithm>

namespace limn {

void MainWindow::connectLoader() {
  connect(&m_loader, &VolumeLoader::progressed, m_view, &CompareView::setLoading);
  connect(&m_loader, &VolumeLoader::loaded, this, &MainWindow::showLoaded);
  connect(&m_loader, &VolumeLoader::seriesFound, this, &MainWindow::chooseSeries);
  connect(&m_loader, &VolumeLoader::cancelled, m_view, &CompareView::clearLoading);
  connect(&m_loader, &VolumeLoader::failed, this, [this](const QString& source, const QString& sentence) {
    m_view->clearLoading();
    m_settings.removeRecentSource(source);
    refreshRecentMenu();
    showError(sentence);
  });
  connect(&m_loader, &VolumeLoader::volumeMissing, this,
          [this](const QString& source, const QString& expected) {
            m_messages->show(MessageBar::Kind::error,
                             tr("The scene's volume is not where the scene expects it: %1.").arg(expected),
                             {}, {tr("Locate volume…"), [this, source] { locateVolume(source); }});
          });
}

void MainWindow::openSource(const QString& source, const SourceOptions& options) {
  // A path means the same from wherever the next window is started.
  const QString path = QString::fromStdString(absoluteSource(source.toStdString()));
  // Whom the file shows is known once it is read; until then its name is shown only where a patient's may be.
  startReading({path, options}, m_patientAction->isChecked()
                                    ? tr("Opening %1").arg(QFileInfo(path).fileName())
                                    : tr("Opening the volume"));
}

// A decoder that crashes takes the window along; so what is shown is put on the disk before one begins.
void MainWindow::startReading(const Request& request, const QString& what) {
  m_messages->hide();
  m_requested = request;
  SourceOptions known = request.options;
  for (const RecentSource& recent : m_settings.recentSources())
    known.knownVolumes.emplace_back(recent.path.toStdString());
  known.references = m_settings.references();
  m_view->setLoading(-1.0, what);
  m_loader.start(request.source, known,
                 m_keeper ? std::function<void()>(m_keeper->autosave().savingOfNow()) : nullptr);
}

void MainWindow::locateVolume(const QString& scene) {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Where is the volume of %1?").arg(QFileInfo(scene).fileName()));
  if (path.isEmpty())
    return;
  Request request = m_requested;
  request.source = scene;
  request.options.volume = path.toStdString();
  startReading(request, tr("Opening the volume"));
}

void MainWindow::openFile() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a volume, session, scene or Limn picture"), QString(),
                                   tr("Everything Limn reads (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti "
                                      "*.vtk *.dcm *.inv3 *.hdr *.tif *.tiff "
                                      "*.png *.jpg *.json *.exr);;All files (*)"));
  if (!path.isEmpty())
    openSource(path);
}

void MainWindow::openFolder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open a DICOM folder or an image stack"));
  if (!path.isEmpty())
    openSource(path);
}

void MainWindow::closeVolume() {
  if (!mayLeaveScene())
    return;
  m_messages->hide();
  m_sessionFile.clear();
  m_session.open({});
  m_editor->setHistogram({});
  measureGradients();
  m_volumeLabel->clear();
  updateTitle();
}

void MainWindow::showLoaded(const LoadedScene& loaded, const Histogram& histogram) {
  m_view->clearLoading();
  if (!mayLeaveScene())
    return;
  m_shown = m_requested;
  m_shown.options.read = loaded.read;
  m_histogram = histogram;
  const Volume& volume = *loaded.scene.volume;
  const VolumeInfo& info = volume.info();
  m_editor->setUnit(QString::fromStdString(info.unit));
  m_editor->setHistogram(histogram);
  m_editor->setPinnedValue(std::nullopt);
  m_preset = {};
  m_preset.name = loaded.preset;
  m_preset.transferFunction = loaded.scene.transferFunction;
  m_preset.gradientOpacity = loaded.scene.gradientOpacity;
  LoadedScene shown = loaded;
  if (!loaded.hasOwnCamera)
    shown.scene.camera = framed(loaded.scene.camera, volume.grid(), m_view->pictureAspect());
  m_session.open(shown);
  m_editor->canvas()->resetView(); // the points of the volume before no longer stretch the axis
  m_properties->foldUnused();
  measureGradients();
  const Grid& grid = volume.grid();
  m_volumeLabel->setText(tr("%1×%2×%3 · %4×%5×%6 mm · %7 to %8 %9")
                             .arg(grid.dims.x)
                             .arg(grid.dims.y)
                             .arg(grid.dims.z)
                             .arg(grid.spacingMm.x, 0, 'g', 3)
                             .arg(grid.spacingMm.y, 0, 'g', 3)
                             .arg(grid.spacingMm.z, 0, 'g', 3)
                             .arg(volume.range().lowest, 0, 'g', 5)
                             .arg(volume.range().highest, 0, 'g', 5)
                             .arg(QString::fromStdString(info.unit)));
  QStringList remarks;
  for (const std::string& note : loaded.notes)
    remarks << QString::fromStdString(note);
  for (const std::string& warning : info.warnings)
    remarks << QString::fromStdString(warning);
  if (volume.invalidVoxels() > 0)
    remarks << tr("%L1 voxels hold no data and are shown as the smallest value.").arg(volume.invalidVoxels());
  if (!remarks.isEmpty())
    m_messages->show(MessageBar::Kind::warning, remarks.front(), remarks.mid(1),
                     info.spacingKnown ? MessageBar::Action{}
                                       : MessageBar::Action{tr("Set spacing…"), [this] { askForSpacing(); }});
  settleSession(loaded);
  if (!m_shown.isUnsavedSession)
    m_settings.addRecentSource(m_shown.source, labelOfShown());
  refreshRecentMenu();
  updateTitle();
}

void MainWindow::chooseSeries(const QString& source, const std::vector<SeriesSummary>& series) {
  m_view->clearLoading();
  auto* dialog = new SeriesDialog(series, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SeriesDialog::seriesChosen, this, [this, source](int number) {
    SourceOptions options = m_requested.options;
    options.read.series = number;
    openSource(source, options);
  });
  dialog->open();
}

void MainWindow::askForSpacing() {
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Voxel spacing"));
  dialog->setLabelText(tr("Distance between voxel centres along x, y and z in millimetres:"));
  const glm::dvec3 spacing =
      m_session.scene().volume ? m_session.scene().volume->grid().spacingMm : glm::dvec3(1.0);
  dialog->setTextValue(QStringLiteral("%1, %2, %3").arg(spacing.x).arg(spacing.y).arg(spacing.z));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    const QStringList numbers = text.split(QLatin1Char(','));
    glm::dvec3 entered(0.0);
    bool valid = numbers.size() == 3;
    for (int axis = 0; valid && axis < 3; ++axis) {
      entered[axis] = numbers[axis].trimmed().toDouble(&valid);
      valid = valid && entered[axis] > 0.0;
    }
    if (!valid) {
      showError(tr("The spacing must be three positive numbers, such as 0.5, 0.5, 1.2."));
      return;
    }
    SourceOptions options = m_shown.options;
    options.read.spacingMm = entered;
    openSource(m_shown.source, options);
  });
  dialog->open();
}

void MainWindow::refreshRecentMenu() {
  m_recentMenu->clear();
  const QList<RecentSource> recent = m_settings.recentSources();
  for (const RecentSource& source : recent) {
    const bool isAlone = std::count_if(recent.begin(), recent.end(), [&](const RecentSource& other) {
                           return other.label == source.label;
                         }) == 1;
    const QDateTime opened = QDateTime::fromString(source.opened, Qt::ISODateWithMs).toLocalTime();
    const QString label =
        isAlone ? source.label
                : tr("%1, opened %2").arg(source.label, QLocale().toString(opened, QLocale::ShortFormat));
    QString text = label;
    m_recentMenu->addAction(text.replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                            [this, path = source.path] { openSource(path); });
  }
  m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
  m_recentMenu->addSeparator();
  m_recentMenu->addAction(tr("&Clear this list"), this, [this] {
    m_settings.clearRecentSources();
    m_recentMenu->setEnabled(false);
  });
}

// What may stand in a list without naming anybody.
QString MainWindow::labelOfShown() const {
  if (m_shown.source == QStringLiteral("sample"))
    return tr("Sample head");
  const Volume& volume = *m_session.scene().volume;
  const QString name = m_shown.isUnsavedSession ? QString() : QFileInfo(m_shown.source).fileName();
  if (name.isEmpty() || mayNameThePatient(name, volume.info().patient))
    return plainDescription(volume);
  return name + QStringLiteral(" · ") + plainDescription(volume);
}

// How a file at this place names the volume. A relative path survives moving both together; one that may name
// the patient is kept in the settings, and the file gets a name that stands for it.
std::string MainWindow::volumeSeenFrom(const std::filesystem::path& file) {
  const std::filesystem::path volume(m_session.volumePath());
  if (!volume.is_absolute())
    return volume.string();
  const std::string relative =
      volume.lexically_relative(std::filesystem::absolute(file).parent_path()).string();
  const Volume& shown = *m_session.scene().volume;
  if (!pathMayNameThePatient(QString::fromStdString(relative), shown.info().patient))
    return relative;
  return m_settings.referenceTo(volume.string(), plainFileName(shown).toStdString());
}

QString MainWindow::suggestedName() const {
  const auto& volume = m_session.scene().volume;
  if (!volume || m_session.volumePath().empty())
    return QStringLiteral("limn");
  const QString name = shareableName(QString::fromStdString(m_session.volumePath()), *volume);
  return QFileInfo(name).baseName();
}

} // namespace limn
