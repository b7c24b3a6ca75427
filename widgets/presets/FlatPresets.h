// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractProxyModel>

#include <vector>

namespace limn {

/// The presets of a model of groups one after the other, without the groups: for views that know no trees.
class FlatPresets : public QAbstractProxyModel {
  Q_OBJECT

public:
  using QAbstractProxyModel::QAbstractProxyModel;

  void setSourceModel(QAbstractItemModel* source) override;
  QModelIndex mapToSource(const QModelIndex& index) const override;
  QModelIndex mapFromSource(const QModelIndex& index) const override;
  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;

private:
  void look();

  std::vector<QPersistentModelIndex> m_presets;
};

} // namespace limn
