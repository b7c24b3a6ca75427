// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"
#include "widgets/Gesture.h"

#include <QAbstractTableModel>

namespace limn {

/// The labels of a region as rows: colour and name with a mark (shown, hidden, or between), and the weight in
/// percent. Edits change nothing here: they are asked for, and the answer comes by setRegion.
class LabelTable : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { nameColumn, weightColumn, columns };

  using QAbstractTableModel::QAbstractTableModel;

  void setRegion(const Region& region);
  const Region& region() const { return m_region; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
  void regionEdited(const limn::Region& region, const limn::Gesture& gesture);

private:
  QVariant nameData(std::size_t place, int role) const;
  QVariant weightData(std::size_t place, int role) const;

  Region m_region;
};

/// The region with another weight of the label at `place`, and what undo calls that.
Region withWeight(Region region, std::size_t place, double weight);
QString weightGestureText(const Label& label, double weight);

} // namespace limn
