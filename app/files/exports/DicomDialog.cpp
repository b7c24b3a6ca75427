// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/exports/DicomDialog.h"

#include "app/core/drawing/PathDrawing.h"
#include "app/core/making/DicomSaving.h"
#include "app/document/DocumentText.h"
#include "io/looks/dicom/Losses.h"
#include "widgets/Translated.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/Titles.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leastSide = 1024.0; // of a picture for an archive, pixels

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  return label;
}

} // namespace

DicomDialog::DicomDialog(WindowContext& context)
    : ExportDialog(context, {QStringLiteral("dicom"), tr("Drawing the picture"),
                             tr("Cancelled; nothing was written.")}),
      m_picture(wrapped({}, this)), m_carries(wrapped({}, this)),
      m_anonymous(new QCheckBox(tr("&Leave out what the series says of its patient and study"), this)),
      m_losses(new QListWidget(this)) {
  setWindowTitle(tr("Save to DICOM"));
  m_anonymous->setObjectName(QStringLiteral("dicomAnonymous"));
  m_anonymous->setToolTip(tr("The UIDs of study and images stay: by them the look finds its images."));
  m_losses->setObjectName(QStringLiteral("dicomLosses"));
  m_losses->setWordWrap(true);
  m_losses->setSpacing(2);
  m_losses->setSelectionMode(QAbstractItemView::NoSelection);
  m_losses->setAccessibleName(tr("What other programs see differently"));
  layOut();
  connect(m_anonymous, &QCheckBox::toggled, this, &DicomDialog::sayWhatTheyCarry);
  sayWhatTheyCarry();
}

ActionLook DicomDialog::look() {
  return {.text = tr("Save to D&ICOM…"),
          .place = {Menu::file, 2, 8},
          .toolTip = tr("Saves picture and look of a DICOM series for an archive, filed with its patient and "
                        "study.")};
}

bool DicomDialog::suits(const Scene& scene) {
  return scene.volume && scene.volume->info().format == "DICOM";
}

void DicomDialog::layOut() {
  auto* lossTitle =
      wrapped(tr("What &others see differently (Limn reads all of it back, but for kept labels):"), this);
  lossTitle->setBuddy(m_losses);
  auto* save = new QPushButton(tr("&Save…"), this);
  save->setObjectName(QStringLiteral("dicomSave"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(wrapped(
      tr("Saves files for an archive: the picture (picture.dcm), the look that it was made with "
         "(look.dcm), which other programs and Limn can open, and where something is kept by label or cut "
         "away which voxels these are (segments.dcm)."),
      this));
  column->addWidget(m_picture);
  column->addWidget(m_carries);
  column->addWidget(m_anonymous);
  column->addWidget(lossTitle);
  column->addWidget(m_losses, 1);
  addFoot(column, save);
  setMinimumWidth(520);
  connect(this, &ExportDialog::workingChanged, m_anonymous, &QWidget::setDisabled);
  connect(save, &QPushButton::clicked, this, &DicomDialog::save);
}

void DicomDialog::sayWhatTheyCarry() {
  m_carries->setText(m_anonymous->isChecked()
                         ? tr("The files name nobody. They keep the UIDs of the study and of its images, "
                              "by which the look finds them.")
                         : tr("The files carry what the series says of its patient, because an archive "
                              "files them by it. Nothing else that Limn writes does."));
}

void DicomDialog::begin(bool) {
  describe();
}

void DicomDialog::showScene(const Scene&) {
  if (isVisible())
    describe();
}

Scene DicomDialog::sceneToSave() const {
  Scene scene = m_context.view.sceneOfSide(0);
  const QRectF picture = m_context.view.logicalRect(0);
  const double density = m_context.window.devicePixelRatioF();
  const double shorter = std::max(1.0, std::min(picture.width(), picture.height()) * density);
  const double scale = density * std::max(1.0, leastSide / shorter);
  scene.image.width = std::max(1, static_cast<int>(std::lround(picture.width() * scale)));
  scene.image.height = std::max(1, static_cast<int>(std::lround(picture.height() * scale)));
  return scene;
}

void DicomDialog::describe() {
  const Scene scene = sceneToSave();
  m_picture->setText(tr("The picture: %1, %2 × %3 pixels, without marks on it.")
                         .arg(sideTitle(scene))
                         .arg(scene.image.width)
                         .arg(scene.image.height));
  QStringList losses;
  for (const Message& loss : lossesOf(scene))
    losses << translated(loss);
  if (losses == m_shown)
    return; // or a screen reader would lose its place whenever the camera moves
  m_shown = losses;
  m_losses->clear();
  m_losses->addItems(losses);
}

void DicomDialog::save() {
  exportTo({tr("Save picture and look in a new folder"),
            suggestedName(m_context.document) + QStringLiteral(".dicom"),
            {tr("Folder with picture.dcm and look.dcm (*.dicom)")},
            QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)},
           [scene = sceneToSave(), order = m_context.drawnLikeTheView(),
            isAnonymous = m_anonymous->isChecked(), source = m_context.document.volumePath(),
            dicom = m_context.document.request().options.dicom,
            series = m_context.document.request().options.read.series](const std::string& path,
                                                                       const Effort& effort) {
             requireDicomFolder(path);
             Progress reading;
             reading.isCancelled = effort.isCancelled;
             const SeriesImages images = shownSeries(source, dicom, series, reading);
             MakingOptions told = order;
             told.effort = effort;
             QString said;
             makeEach({scene}, {scene.image.width, scene.image.height}, told,
                      [&](std::size_t, const MadePicture& picture) {
                        saveToDicom(path, scene, picture.image, images, isAnonymous, exactnessOf(picture));
                        if (picture.paths)
                          said = QLatin1Char(' ') + translated(sentenceOf(*picture.paths));
                      });
             return Outcome{tr("Saved %1.").arg(QFileInfo(QString::fromStdString(path)).fileName()) + said};
           });
}

QString DicomDialog::doing(double) const {
  return tr("Drawing the picture…");
}

} // namespace limn
