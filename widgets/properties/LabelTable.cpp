// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/LabelTable.h"

#include "scene/LabelLooks.h"
#include "scene/basics/Error.h"
#include "scene/regions/BodyAndLabels.h"
#include "widgets/MeasureText.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/theme/Theme.h"

#include <QApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int swatchSize = 14; // logical pixels

int percentOf(double weight) {
  return static_cast<int>(std::lround(100.0 * weight));
}

Qt::CheckState markOf(double weight) {
  return weight <= 0.0 ? Qt::Unchecked : weight >= 1.0 ? Qt::Checked : Qt::PartiallyChecked;
}

// A square of the colour, framed so that white shows on white.
QPixmap swatchOf(const glm::dvec3& color) {
  QPixmap swatch(swatchSize, swatchSize);
  QPainter painter(&swatch);
  painter.setPen(QApplication::palette().color(QPalette::Mid));
  painter.setBrush(toQColor(color));
  painter.drawRect(0, 0, swatchSize - 1, swatchSize - 1);
  return swatch;
}

QString weightGestureText(const Label& label, double weight) {
  const QString name = QString::fromStdString(label.name);
  return weight <= 0.0   ? LabelTable::tr("hide %1").arg(name)
         : weight >= 1.0 ? LabelTable::tr("show %1").arg(name)
                         : LabelTable::tr("fade %1 to %2 %").arg(name).arg(percentOf(weight));
}

// "12.3 ml · 45 ± 12 HU · −20 – 80 HU"; of a label without valid voxels its size alone.
QString figuresText(const LabelFigures& figures, const Volume& volume) {
  const QString size =
      valueText(figures.millilitres, LabelTable::tr("ml"), figures.millilitres < 10.0 ? 2 : 0);
  if (figures.voxels == 0)
    return size;
  const int decimals = decimalsOfSpan(volume.range().highest - volume.range().lowest);
  const QString unit = QString::fromStdString(volume.info().unit);
  const auto number = [&](double value) { return valueText(value, {}, decimals); };
  return LabelTable::tr("%1 · %2 · %3 – %4")
      .arg(size, meanText(figures.mean, figures.deviation, figures.voxels, volume), number(figures.lowest),
           valueText(figures.highest, unit, decimals));
}

// The region with another weight of the label at `place`.
Region withWeight(Region region, std::size_t place, double weight) {
  region.weights[place] = std::clamp(weight, 0.0, 1.0);
  return region;
}

} // namespace

void LabelTable::setScene(const Scene& scene) {
  const Region& region = scene.keep;
  m_function = scene.transferFunction;
  if (region == m_region)
    return;
  m_colors.follow(scene.volume, region);
  // Other weights of the same labels leave selection and scrolling alone.
  if (region.labels == m_region.labels && region.weights.size() == m_region.weights.size()) {
    m_region = region;
    if (rowCount() > 0)
      emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    return;
  }
  beginResetModel();
  m_region = region;
  endResetModel();
}

void LabelTable::showRows(const std::vector<int>& rows, bool isShown, const QString& name) {
  Region edited = m_region;
  for (const int row : rows)
    edited.weights[static_cast<std::size_t>(row)] = isShown ? 1.0 : 0.0;
  if (edited != m_region)
    emit regionEdited(edited, {nextGestureId(), (isShown ? tr("show %1") : tr("hide %1")).arg(name)});
}

// The table that lies beside the body is another label, and goes, too.
Region LabelTable::withOnly(const std::vector<int>& rows) const {
  Region edited = m_region;
  std::fill_n(edited.weights.begin(), ownLabels(edited), 0.0);
  for (const int row : rows) {
    const double before = m_region.weights[static_cast<std::size_t>(row)];
    edited.weights[static_cast<std::size_t>(row)] = before > 0.0 ? before : 1.0;
  }
  return edited;
}

void LabelTable::showOnly(const std::vector<int>& rows, const QString& name) {
  if (const Region edited = withOnly(rows); edited != m_region)
    emit regionEdited(edited, {nextGestureId(), tr("show only %1").arg(name)});
}

bool LabelTable::canShowOnly(const std::vector<int>& rows) const {
  return std::ranges::any_of(rows, [this](int row) { return hasVoxels(static_cast<std::size_t>(row)); }) &&
         withOnly(rows) != m_region;
}

void LabelTable::showAll() {
  Region edited = m_region;
  std::fill_n(edited.weights.begin(), rowCount({}), 1.0);
  if (edited != m_region)
    emit regionEdited(edited, {nextGestureId(), tr("show all labels")});
}

bool LabelTable::areAllShown() const {
  return std::all_of(m_region.weights.begin(), m_region.weights.begin() + rowCount({}),
                     [](double weight) { return weight == 1.0; });
}

void LabelTable::setFigures(const std::vector<LabelFigures>& figures,
                            const std::shared_ptr<const Volume>& volume) {
  m_figures = figures;
  m_volume = volume;
}

int LabelTable::rowCount(const QModelIndex& parent) const {
  const bool hasLabels = m_region.kind == Region::Kind::labels && m_region.labels && !parent.isValid();
  return hasLabels ? static_cast<int>(listedLabels(m_region)) : 0;
}

int LabelTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant LabelTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid())
    return {};
  const auto place = static_cast<std::size_t>(index.row());
  if (role == Qt::ForegroundRole)
    return hasVoxels(place) ? QVariant() : QVariant(QApplication::palette().brush(QPalette::PlaceholderText));
  return index.column() == nameColumn     ? nameData(place, role)
         : index.column() == weightColumn ? weightData(place, role)
                                          : curveData(place, role);
}

// Before anything was cut, as its size is told.
bool LabelTable::hasVoxels(std::size_t place) const {
  const LabelMap& map = m_region.isCut && m_region.uncut ? *m_region.uncut : *m_region.labels;
  const VoxelBox& box = map.boxAround(place);
  return box.lower != box.upper;
}

QVariant LabelTable::nameData(std::size_t place, int role) const {
  const Label& label = m_region.labels->labels()[place];
  switch (role) {
  case Qt::DisplayRole:
    return QString::fromStdString(label.name);
  case Qt::DecorationRole:
    return swatchOf(colorOf(place));
  case Qt::CheckStateRole:
    return markOf(m_region.weights[place]);
  case typeRole:
    return QString::fromStdString(label.type);
  case categoryRole:
    return QString::fromStdString(label.category);
  case Qt::ToolTipRole:
    return tr("%1 (label %2): shown, hidden, or faded where only a part of its opacity is kept. A click on "
              "its "
              "square gives it a colour.")
               .arg(QString::fromStdString(label.name))
               .arg(label.value) +
           (hasVoxels(place) ? QString()
                             : QLatin1Char('\n') + tr("It has no voxels of its own, so there is nothing to "
                                                      "show: labels read after it cover it.")) +
           (m_volume && place < m_figures.size()
                ? QLatin1Char('\n') + figuresText(m_figures[place], *m_volume)
                : QString());
  default:
    return {};
  }
}

QVariant LabelTable::weightData(std::size_t place, int role) const {
  const int percent = percentOf(m_region.weights[place]);
  if (role == Qt::DisplayRole)
    return tr("%1 %").arg(percent);
  if (role == Qt::EditRole)
    return percent;
  if (role == Qt::AccessibleTextRole)
    return tr("%1 shown to %2 %")
        .arg(QString::fromStdString(m_region.labels->labels()[place].name))
        .arg(percent);
  return role == Qt::TextAlignmentRole ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
}

QVariant LabelTable::curveData(std::size_t place, int role) const {
  const bool isOwn = lookOfLabel(m_region, place) > 0;
  if (role == Qt::DisplayRole)
    return isOwn ? tr("own") : QString();
  if (role == Qt::CheckStateRole)
    return isOwn ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::ToolTipRole)
    return tr("Whether %1 has a curve of its own, in place of the one for all tissue.")
        .arg(QString::fromStdString(m_region.labels->labels()[place].name));
  return {};
}

QVariant LabelTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section == weightColumn)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter); // over its numbers
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return {};
  return section == nameColumn ? tr("Label") : section == weightColumn ? tr("Shown") : tr("Curve");
}

Qt::ItemFlags LabelTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return flags | (index.column() == weightColumn ? Qt::ItemIsEditable : Qt::ItemIsUserCheckable);
}

bool LabelTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (index.isValid() && index.column() == curveColumn && role == Qt::CheckStateRole)
    return setCurve(static_cast<std::size_t>(index.row()), value.toInt() == Qt::Checked);
  const bool isMark = index.column() == nameColumn && role == Qt::CheckStateRole;
  const bool isWeight = index.column() == weightColumn && role == Qt::EditRole;
  if (!index.isValid() || (!isMark && !isWeight))
    return false;
  const auto place = static_cast<std::size_t>(index.row());
  const double before = m_region.weights[place];
  // A click on a mark hides what can be seen at all, and shows wholly what cannot.
  const double weight = isMark ? (before > 0.0 ? 0.0 : 1.0) : std::clamp(value.toInt(), 0, 100) / 100.0;
  if (weight != before)
    emit regionEdited(withWeight(m_region, place, weight),
                      {nextGestureId(), weightGestureText(m_region.labels->labels()[place], weight)});
  return true;
}

bool LabelTable::setCurve(std::size_t place, bool isOwn) {
  const QString name = QString::fromStdString(m_region.labels->labels()[place].name);
  Region edited;
  try {
    const glm::dvec3& color = m_region.labels->labels()[place].color;
    edited = withLookOf(m_region, place, isOwn ? std::optional(inOneColor(m_function, color)) : std::nullopt);
  } catch (const Error& error) { // too many looks
    emit refused(translated(error));
    return false;
  }
  emit regionEdited(edited, {nextGestureId(), isOwn ? tr("give %1 its own curve").arg(name)
                                                    : tr("give %1 the curve of all tissue").arg(name)});
  if (isOwn)
    emit curveGiven(place);
  return true;
}

void LabelTable::setColor(std::size_t place, const glm::dvec3& color, std::uint64_t gestureId) {
  if (place >= static_cast<std::size_t>(rowCount()))
    return;
  const std::size_t look = lookOfLabel(m_region, place);
  const TransferFunction& function = look > 0 ? m_region.looks[look - 1] : m_function;
  Region edited;
  try {
    edited = withLookOf(m_region, place, inOneColor(function, color));
  } catch (const Error& error) { // too many looks
    return emit refused(translated(error));
  }
  emit regionEdited(edited, {gestureId, colorText(place)});
  if (look == 0)
    emit curveGiven(place);
}

QString LabelTable::colorText(std::size_t place) const {
  return tr("colour of %1").arg(QString::fromStdString(m_region.labels->labels()[place].name));
}

} // namespace limn
