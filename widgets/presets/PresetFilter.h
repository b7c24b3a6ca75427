// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractProxyModel>
#include <QSortFilterProxyModel>
#include <QStringList>

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

/// How well a preset answers a search, best first. The first word of a name, mostly the modality, may be left
/// out: "bone" is the name of "CT bone".
enum class PresetHit { isName, nameBegins, wordBegins, inName, elsewhere };

/// The presets that a search finds, those first that suit the volume (ListedPreset::standing, 0 and 1), then
/// the best hit, and their groups by the best in each; without a search all of them in the order of the list.
class PresetFilter : public QSortFilterProxyModel {
public:
  explicit PresetFilter(QObject* parent = nullptr);

  /// Every word must occur in name, modality or note, in any order and as it is written.
  void search(const QString& text);

  /// The source's, and of the best hit of a search that it is this (presetRole::isBestHit).
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
  int rankOf(const QModelIndex& index) const;

  QStringList m_words;
};

/// How well a preset of this name answers the words, all of which its text holds somewhere.
PresetHit presetHit(const QString& name, const QStringList& words);

} // namespace limn
