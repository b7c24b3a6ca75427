// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/surface/SurfaceDesk.h"

#include "app/Settings.h"
#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/engines/ProcessCost.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "app/surface/SurfaceDialog.h"
#include "app/surface/SurfaceText.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QAction>
#include <QFileInfo>
#include <QStandardPaths>

#include <cmath>

namespace limn {
namespace {

// A fifth of a voxel, as a round number: less than the triangles lie off by themselves where bone is thin.
double usualTolerance(const Grid& grid) {
  const double fifth = smallestSpacingMm(grid) / 5.0, digit = std::pow(10.0, std::floor(std::log10(fifth)));
  return std::round(fifth / digit) * digit;
}

Progress progressOf(const Effort& effort) {
  Progress progress;
  progress.isCancelled = effort.isCancelled;
  progress.report = [report = effort.report](double fraction, const Message&) { report(fraction); };
  return progress;
}

std::optional<std::size_t> onlyOne(const PointIndices& selected) {
  return selected.size() == 1 ? std::optional(selected.front()) : std::nullopt;
}

} // namespace

SurfaceDesk::SurfaceDesk(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  connect(&parts.exportSurface, &QAction::triggered, this, &SurfaceDesk::show);
  connect(&parts.session, &Session::sceneChanged, this, &SurfaceDesk::showScene);
  connect(&m_estimate, &BackgroundWork::failed, this, [this](const QString& sentence) {
    if (m_dialog && !m_work.isRunning())
      m_dialog->showRefusal(sentence);
  });
}

void SurfaceDesk::makeDialog() {
  m_dialog = new SurfaceDialog(&m_parts.window);
  m_dialog->follow(m_work);
  connect(m_dialog, &SurfaceDialog::orderEdited, this, &SurfaceDesk::estimate);
  connect(m_dialog, &SurfaceDialog::exportRequested, this, &SurfaceDesk::exportSurface);
  connect(m_dialog, &SurfaceDialog::cancelled, this, [this] {
    m_work.cancel();
    m_dialog->endProgress(tr("Cancelled; nothing was written."));
  });
}

void SurfaceDesk::show() {
  const Scene& scene = m_parts.document.scene();
  if (!scene.volume)
    return;
  if (!m_dialog)
    makeDialog();
  if (!m_estimated.volume)
    m_dialog->setTolerance(usualTolerance(scene.volume->grid()));
  if (!m_dialog->isVisible()) {
    const FirstValue first =
        firstValue(scene, m_parts.curve.pinnedValue(), onlyOne(m_parts.curve.selected()));
    m_dialog->setValue(first.value, QString::fromStdString(scene.volume->info().unit), textOf(first.origin));
    estimate();
  }
  m_dialog->show();
  m_dialog->raise();
  m_dialog->activateWindow();
}

// Another crop or kept region makes another surface; of another volume somebody asks anew.
void SurfaceDesk::showScene(const Scene& scene) {
  if (!m_dialog || !m_estimated.volume)
    return;
  if (scene.volume != m_estimated.volume) {
    m_estimate.cancel();
    m_work.cancel();
    m_estimated = {};
    m_dialog->endProgress({});
    m_dialog->hide();
  } else if (m_dialog->isVisible() && (scene.crop != m_estimated.crop || scene.keep != m_estimated.keep)) {
    estimate();
  }
}

SurfaceOrder SurfaceDesk::order() const {
  SurfaceOrder order;
  order.isovalue = m_dialog->value();
  order.isClosed = m_dialog->isClosed();
  order.smallestPartMm3 = m_dialog->smallestPartMm3();
  order.toleranceMm = m_dialog->toleranceMm();
  order.cells = m_dialog->cells();
  order.memoryBytes = freeMemory();
  return order;
}

void SurfaceDesk::estimate() {
  if (m_work.isRunning())
    return;
  m_estimated = m_parts.document.scene();
  m_dialog->showRefusal(tr("Counting triangles…"));
  m_estimate.start(
      [this, scene = m_estimated, asked = order()](const Effort& effort) -> BackgroundWork::Deliver {
        const SurfaceEstimate found = estimatedSurface(scene, asked, progressOf(effort));
        return [this, found, losesSome = asked.toleranceMm > 0.0] {
          if (m_dialog && !m_work.isRunning())
            m_dialog->showEstimate(textOf(found, losesSome));
        };
      });
}

void SurfaceDesk::exportSurface() {
  const QString path = askWhereToSave(
      m_dialog,
      {tr("Export the surface"),
       suggestedName(m_parts.document) + QStringLiteral("-surface.stl"),
       {tr("STL, for printing (*.stl)"), tr("PLY, with normals (*.ply)"), tr("OBJ, with normals (*.obj)")},
       QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)},
      m_parts.settings);
  if (path.isEmpty() || m_parts.document.scene().volume != m_estimated.volume)
    return;
  m_estimate.cancel();
  m_dialog->showProgress(0.0);
  m_work.start([this, path, scene = m_parts.document.scene(),
                asked = order()](const Effort& effort) -> BackgroundWork::Deliver {
    const std::vector<WrittenSurface> written =
        exportSurfaces(scene, {asked}, path.toStdString(), progressOf(effort));
    return [this, path, text = textOf(written.front().made, QFileInfo(path).fileName())] {
      if (m_dialog)
        m_dialog->endProgress(text);
      m_parts.notes.attempt([] {}, path);
    };
  });
}

} // namespace limn
