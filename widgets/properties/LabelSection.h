// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/regions/Region.h"
#include "widgets/Gesture.h"
#include "widgets/controls/FoldingSection.h"

#include <QAbstractTableModel>

class QPushButton;
class QTreeView;

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

/// The labels of a segmentation that is open beside the volume: each is shown, hidden or faded.
class LabelSection : public FoldingSection {
  Q_OBJECT

public:
  explicit LabelSection(QWidget* parent = nullptr);

  void setScene(const Scene& scene);

signals:
  void keepEdited(const limn::Region& region, const limn::Gesture& gesture);
  void openRequested();

private:
  LabelTable* m_labels;
  QTreeView* m_table;
  QPushButton* m_open;
  QPushButton* m_showAll;
};

} // namespace limn
