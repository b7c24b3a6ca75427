// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/labels/LabelTable.h"

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
  painter.setBrush(QColor::fromRgbF(static_cast<float>(color.r), static_cast<float>(color.g),
                                    static_cast<float>(color.b)));
  painter.drawRect(0, 0, swatchSize - 1, swatchSize - 1);
  return swatch;
}

} // namespace

Region withWeight(Region region, std::size_t place, double weight) {
  region.weights[place] = std::clamp(weight, 0.0, 1.0);
  return region;
}

QString weightGestureText(const Label& label, double weight) {
  const QString name = QString::fromStdString(label.name);
  return weight <= 0.0   ? LabelTable::tr("hide %1").arg(name)
         : weight >= 1.0 ? LabelTable::tr("show %1").arg(name)
                         : LabelTable::tr("fade %1 to %2 %").arg(name).arg(percentOf(weight));
}

void LabelTable::setRegion(const Region& region) {
  if (region == m_region)
    return;
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

int LabelTable::rowCount(const QModelIndex& parent) const {
  const bool hasLabels = m_region.kind == Region::Kind::labels && m_region.labels && !parent.isValid();
  return hasLabels ? static_cast<int>(m_region.weights.size()) : 0;
}

int LabelTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant LabelTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid())
    return {};
  const auto place = static_cast<std::size_t>(index.row());
  return index.column() == nameColumn ? nameData(place, role) : weightData(place, role);
}

QVariant LabelTable::nameData(std::size_t place, int role) const {
  const Label& label = m_region.labels->labels()[place];
  switch (role) {
  case Qt::DisplayRole:
    return QString::fromStdString(label.name);
  case Qt::DecorationRole:
    return swatchOf(label.color);
  case Qt::CheckStateRole:
    return markOf(m_region.weights[place]);
  case Qt::ToolTipRole:
    return tr("%1 (label %2): shown, hidden, or faded where only a part of its opacity is kept.")
        .arg(QString::fromStdString(label.name))
        .arg(label.value);
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

QVariant LabelTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section == weightColumn)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter); // over its numbers
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return {};
  return section == nameColumn ? tr("Label") : tr("Shown");
}

Qt::ItemFlags LabelTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return flags | (index.column() == nameColumn ? Qt::ItemIsUserCheckable : Qt::ItemIsEditable);
}

bool LabelTable::setData(const QModelIndex& index, const QVariant& value, int role) {
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

} // namespace limn
