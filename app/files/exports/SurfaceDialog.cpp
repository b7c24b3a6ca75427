// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/exports/SurfaceDialog.h"

#include "app/core/drawing/ProcessCost.h"
#include "app/document/DocumentText.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberField.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double stlBytesEach = 50.0; // of a triangle

QString millimetres(double mm) {
  return QLocale().toString(mm, 'g', 2);
}

QString counted(std::uint64_t count) {
  return QLocale().toString(static_cast<qulonglong>(count));
}

// To two digits.
QString about(std::uint64_t count) {
  const auto number = static_cast<double>(count);
  if (number >= 1e6)
    return QObject::tr("%1 million").arg(QLocale().toString(number / 1e6, 'f', number < 1e7 ? 1 : 0));
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(number, 1.0))) - 1.0));
  return counted(static_cast<std::uint64_t>(std::llround(number / unit) * std::llround(unit)));
}

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

QHBoxLayout* withUnit(QWidget* field, QLabel* unit) {
  auto* row = new QHBoxLayout;
  unit->setMinimumWidth(unit->fontMetrics().horizontalAdvance(QStringLiteral("mm³ "))); // fields end alike
  row->addWidget(field, 1);
  row->addWidget(unit);
  return row;
}

} // namespace

FirstValue firstValue(const Scene& scene, std::optional<double> pinned,
                      std::optional<std::size_t> selectedPoint) {
  if (scene.projection == Projection::isosurface || scene.projection == Projection::compositeIsosurface)
    return {scene.isovalue, ValueOrigin::isosurface};
  if (pinned)
    return {*pinned, ValueOrigin::pin};
  if (selectedPoint && *selectedPoint < scene.transferFunction.points.size())
    return {scene.transferFunction.points[*selectedPoint].value, ValueOrigin::point};
  const ValueRange& range = scene.volume->range();
  if (scene.isovalue > range.lowest && scene.isovalue <= range.highest)
    return {scene.isovalue, ValueOrigin::range};
  return {0.5 * (range.lowest + range.highest), ValueOrigin::range};
}

QString textOf(ValueOrigin origin) {
  switch (origin) {
  case ValueOrigin::isosurface:
    return QObject::tr("The isosurface that the picture shows.");
  case ValueOrigin::pin:
    return QObject::tr("The value that is pinned on the curve.");
  case ValueOrigin::point:
    return QObject::tr("The value of the selected point of the curve.");
  case ValueOrigin::range:
    return QObject::tr("Pin a value with a Shift+click in the picture to begin with that.");
  }
  return {};
}

QString textOf(const SurfaceEstimate& estimate, bool willLoseTriangles) {
  const double megabytes = stlBytesEach * static_cast<double>(estimate.triangles) / 1e6;
  const QString size =
      QObject::tr("About %1 triangles, %2 MB as STL; making it takes %3 MB of memory.")
          .arg(about(estimate.triangles), QLocale().toString(megabytes, 'f', megabytes < 10.0 ? 1 : 0),
               QLocale().toString(estimate.bytes / 1e6, 'f', 0));
  const QString fewer = QObject::tr("Those that the distance allows are taken away.");
  const QString axes =
      QObject::tr("Millimetres in the patient's axes: x to the left, y to the back, z to the head (LPS).");
  return willLoseTriangles ? QStringLiteral("%1 %2\n%3").arg(size, fewer, axes)
                           : QStringLiteral("%1\n%2").arg(size, axes);
}

QString textOf(const MadeSurface& made, const QString& file) {
  QString text = QObject::tr("Saved %1: %2 triangles.").arg(file, counted(made.mesh.triangles.size()));
  text +=
      QLatin1Char(' ') +
      (made.edges.isWatertight()
           ? QObject::tr("It is watertight: every edge is used twice.")
           : QObject::tr("It is open: %1 edges lie at the rims of holes.").arg(counted(made.edges.usedOnce)));
  text += QLatin1Char('\n') +
          QObject::tr("It lies at most %1 mm from the isosurface (%2 mm in the mean), measured "
                      "at %3 points each way.")
              .arg(millimetres(made.error.largest()), millimetres(made.error.ofMesh.mean),
                   counted(made.error.ofMesh.points));
  if (made.order.toleranceMm > 0.0 && made.error.largest() > made.order.toleranceMm)
    text += QLatin1Char(' ') +
            QObject::tr(
                "That is more than the %1 mm asked for, because the cells are too coarse in places; choose "
                "more detail.")
                .arg(millimetres(made.order.toleranceMm));
  if (made.dropped.parts + made.dropped.hollows > 0)
    text += QLatin1Char('\n') + QObject::tr("Small parts left out: %1; small hollows filled: %2.")
                                    .arg(made.dropped.parts)
                                    .arg(made.dropped.hollows);
  return text;
}

SurfaceDialog::SurfaceDialog(WindowContext& context, std::function<CurveChoice()> curve)
    : ExportDialog(context, {QStringLiteral("surface"), tr("Making the surface"),
                             tr("Cancelled; nothing was written.")}),
      m_curve(std::move(curve)), m_value(new NumberField(-1e9, 1e9, 4, this)), m_unit(new QLabel(this)),
      m_origin(new QLabel(this)),
      m_isClosed(new QCheckBox(tr("&Close holes where crop or volume end (printing needs it)"), this)),
      m_smallest(new NumberField(0.0, 1e9, 1, this)), m_tolerance(new NumberField(0.0, 100.0, 3, this)),
      m_cells(new QuietComboBox(this)) {
  setWindowTitle(tr("Export a surface"));
  name();
  m_isClosed->setChecked(true);
  m_isClosed->setToolTip(
      tr("Flat faces close the surface where the crop, the volume or what is kept of it ends."));
  m_smallest->setNumber(10.0);
  m_smallest->setToolTip(
      tr("Specks that enclose less are left out, and smaller hollows filled; 0 keeps all."));
  m_tolerance->setToolTip(
      tr("Triangles are taken away as far as this distance from the isosurface allows; 0 keeps "
         "all."));
  m_cells->addItem(tr("As fine as the voxels"), 1);
  m_cells->addItem(tr("Twice as fine (4 times the triangles)"), 2);
  m_cells->addItem(tr("3 times as fine (9 times the triangles)"), 3);
  layOut();
  connect(m_value, &NumberField::numberEdited, this, [this] {
    m_origin->clear();
    estimate();
  });
  connect(m_tolerance, &NumberField::numberEdited, this, &SurfaceDialog::estimate);
  connect(m_cells, &QComboBox::activated, this, &SurfaceDialog::estimate);
  connect(&m_estimate, &BackgroundWork::failed, this,
          [this](const QString& sentence) { showEstimate(sentence, false); });
}

ActionLook SurfaceDialog::look() {
  return {.text = tr("E&xport surface…"),
          .place = {Menu::file, 2, 7},
          .toolTip = tr("Makes a mesh of the surface at a value, to print or to model with: STL, PLY or OBJ, "
                        "in millimetres.")};
}

void SurfaceDialog::name() {
  m_value->setObjectName(QStringLiteral("surfaceValue"));
  m_isClosed->setObjectName(QStringLiteral("surfaceClosed"));
  m_smallest->setObjectName(QStringLiteral("surfaceSmallest"));
  m_tolerance->setObjectName(QStringLiteral("surfaceTolerance"));
  m_cells->setObjectName(QStringLiteral("surfaceCells"));
  m_value->setAccessibleName(tr("Value of the surface"));
  m_smallest->setAccessibleName(tr("Smallest part in cubic millimetres"));
  m_tolerance->setAccessibleName(tr("Distance from the isosurface in millimetres"));
}

void SurfaceDialog::layOut() {
  auto* form = new QFormLayout;
  const auto add = [&](const QString& label, QWidget* field, QLabel* unit) {
    auto* text = new QLabel(label, this);
    text->setBuddy(field);
    form->addRow(text, withUnit(field, unit));
  };
  add(tr("&Value"), m_value, m_unit);
  m_origin->setWordWrap(true);
  form->addRow(QString(), m_origin);
  form->addRow(QString(), m_isClosed);
  add(tr("Leave out &parts below"), m_smallest, new QLabel(tr("mm³"), this));
  add(tr("&Simplify within"), m_tolerance, new QLabel(tr("mm"), this));
  form->addRow(tr("&Detail"), m_cells);
  text()->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* start = new QPushButton(tr("&Export…"), this);
  start->setObjectName(QStringLiteral("surfaceExport"));
  connect(start, &QPushButton::clicked, this, &SurfaceDialog::exportSurface);
  auto* column = new QVBoxLayout(this);
  column->addWidget(outOfUseWhileWorking(form));
  addFoot(column, start);
  text()->setMinimumHeight(4 * fontMetrics().lineSpacing());
  column->setStretchFactor(text(), 1);
  setMinimumWidth(480);
}

void SurfaceDialog::begin(bool isNew) {
  const Scene& scene = m_context.document.scene();
  if (!m_estimated.volume)
    m_tolerance->setNumber(usualTolerance(scene.volume->grid()));
  if (!isNew)
    return;
  const CurveChoice chosen = m_curve();
  const FirstValue first = firstValue(scene, chosen.pinnedValue, chosen.point);
  m_value->setNumber(first.value);
  m_unit->setText(QString::fromStdString(scene.volume->info().unit));
  m_origin->setText(textOf(first.origin));
  estimate();
}

// Another crop or kept region makes another surface; of another volume somebody asks anew.
void SurfaceDialog::showScene(const Scene& scene) {
  if (!m_estimated.volume)
    return;
  if (scene.volume != m_estimated.volume) {
    m_estimate.cancel();
    m_work.cancel();
    m_estimated = {};
    end({});
    hide();
  } else if (isVisible() && (scene.crop != m_estimated.crop || scene.keep != m_estimated.keep)) {
    estimate();
  }
}

SurfaceOrder SurfaceDialog::order() const {
  SurfaceOrder order;
  order.isovalue = m_value->number();
  order.isClosed = m_isClosed->isChecked();
  order.smallestPartMm3 = m_smallest->number();
  order.toleranceMm = m_tolerance->number();
  order.cells = m_cells->currentData().toInt();
  order.memoryBytes = freeMemory();
  return order;
}

void SurfaceDialog::estimate() {
  if (m_work.isRunning())
    return;
  m_estimated = m_context.document.scene();
  showEstimate(tr("Counting triangles…"), false);
  m_estimate.start([this, scene = m_estimated,
                    asked = order()](const Effort& effort) -> BackgroundWork::Deliver {
    const SurfaceEstimate found = estimatedSurface(scene, asked, progressOf(effort));
    return
        [this, found, losesSome = asked.toleranceMm > 0.0] { showEstimate(textOf(found, losesSome), true); };
  });
}

void SurfaceDialog::showEstimate(const QString& sentence, bool canBeMade) {
  if (m_work.isRunning())
    return;
  setStartable(canBeMade);
  say(sentence);
}

void SurfaceDialog::exportSurface() {
  m_estimate.cancel();
  exportTo(
      {tr("Export the surface"),
       suggestedName(m_context.document) + QStringLiteral("-surface.stl"),
       {tr("STL, for printing (*.stl)"), tr("PLY, with normals (*.ply)"), tr("OBJ, with normals (*.obj)")},
       QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)},
      [scene = m_estimated, asked = order()](const std::string& path, const Effort& effort) {
        const std::vector<WrittenSurface> written = exportSurfaces(scene, {asked}, path, progressOf(effort));
        return Outcome{textOf(written.front().made, QFileInfo(QString::fromStdString(path)).fileName())};
      });
}

QString SurfaceDialog::doing(double) const {
  return tr("Making the surface and measuring it…");
}

} // namespace limn
