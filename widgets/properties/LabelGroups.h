// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractProxyModel>
#include <QString>

#include <vector>

namespace limn {

/// A group of labels, or one that is in none.
struct LabelGroup {
  QString name;            ///< empty: one label that is in no group
  std::vector<int> labels; ///< rows of the table, in their order
  bool isByName = true;    ///< or by what the file says that they are
  bool operator==(const LabelGroup&) const = default;
};

/// What is known of a label that may join it with others.
struct LabelKind {
  QString name;
  QString type{};     ///< as the file says; empty: it does not
  QString category{}; ///< likewise, of which sort that is
};

/// Labels in groups of three at least, each where its first label stands: those of one type; of the rest
/// those whose names begin with the same word ("rib_left_1", "rib_right_2": "rib"); of the rest those of one
/// category. What all labels share tells none apart, and makes no group.
std::vector<LabelGroup> groupsOf(const std::vector<LabelKind>& labels);

/// A table of labels (LabelTable) as a tree: groups hold their labels, the others stand beside them. A group
/// has a mark, which says whether its labels are shown, and shows or hides all of them.
class LabelTree : public QAbstractProxyModel {
  Q_OBJECT

public:
  using QAbstractProxyModel::QAbstractProxyModel;

  void setSourceModel(QAbstractItemModel* table) override;

  /// Whether an index of this model is a group.
  bool isGroup(const QModelIndex& index) const;
  bool hasGroups() const;

  /// The rows of the table that a row of this model stands for, one or a group's, and what they are called.
  std::vector<int> labelsOf(const QModelIndex& index) const;
  QString nameOf(const QModelIndex& index) const;

  QModelIndex mapToSource(const QModelIndex& index) const override;
  QModelIndex mapFromSource(const QModelIndex& index) const override;
  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  bool hasChildren(const QModelIndex& parent = {}) const override { return rowCount(parent) > 0; }
  /// A group has none in the table that could be edited in its place.
  QModelIndex buddy(const QModelIndex& index) const override { return index; }
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
  /// All labels of a group, rows of the table, shall be shown or hidden.
  void groupShown(const std::vector<int>& labels, bool isShown, const QString& name);

private:
  void regroup();
  void passOn(const QModelIndex& first, const QModelIndex& last);
  Qt::CheckState markOf(const LabelGroup& group) const;

  std::vector<LabelGroup> m_groups;
  std::vector<std::pair<int, int>> m_placeOf; ///< of each label: its group, and its row in that
};

} // namespace limn
