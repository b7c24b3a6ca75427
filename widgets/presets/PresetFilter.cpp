// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetFilter.h"

#include "widgets/presets/PresetModel.h"

#include <QRegularExpression>

#include <algorithm>
#include <limits>

namespace limn {

void FlatPresets::setSourceModel(QAbstractItemModel* source) {
  QAbstractProxyModel::setSourceModel(source);
  connect(source, &QAbstractItemModel::modelReset, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::rowsInserted, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::rowsRemoved, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::layoutChanged, this, &FlatPresets::look);
  connect(source, &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) {
            for (int row = first.row(); first.parent().isValid() && row <= last.row(); ++row)
              if (const QModelIndex its = mapFromSource(first.siblingAtRow(row)); its.isValid())
                emit dataChanged(its, its, roles);
          });
  look();
}

void FlatPresets::look() {
  beginResetModel();
  m_presets.clear();
  const QAbstractItemModel& source = *sourceModel();
  for (int group = 0; group < source.rowCount(); ++group) {
    const QModelIndex heading = source.index(group, 0);
    for (int row = 0; row < source.rowCount(heading); ++row)
      m_presets.emplace_back(source.index(row, 0, heading));
  }
  endResetModel();
}

QModelIndex FlatPresets::mapToSource(const QModelIndex& index) const {
  return index.isValid() ? QModelIndex(m_presets[static_cast<std::size_t>(index.row())]) : QModelIndex();
}

QModelIndex FlatPresets::mapFromSource(const QModelIndex& index) const {
  const auto found = std::ranges::find(m_presets, QPersistentModelIndex(index));
  return found == m_presets.end() ? QModelIndex()
                                  : createIndex(static_cast<int>(found - m_presets.begin()), 0);
}

QModelIndex FlatPresets::index(int row, int column, const QModelIndex& parent) const {
  return parent.isValid() || row < 0 || row >= rowCount() || column != 0 ? QModelIndex()
                                                                         : createIndex(row, 0);
}

QModelIndex FlatPresets::parent(const QModelIndex&) const {
  return {};
}

int FlatPresets::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_presets.size());
}

int FlatPresets::columnCount(const QModelIndex&) const {
  return 1;
}

PresetHit presetHit(const QString& name, const QStringList& words) {
  const QString whole = words.join(QLatin1Char(' '));
  const QString rest = name.section(QLatin1Char(' '), 1);
  if (name.compare(whole, Qt::CaseInsensitive) == 0 || rest.compare(whole, Qt::CaseInsensitive) == 0)
    return PresetHit::isName;
  if (name.startsWith(whole, Qt::CaseInsensitive) || rest.startsWith(whole, Qt::CaseInsensitive))
    return PresetHit::nameBegins;
  const QStringList parts = name.split(QRegularExpression(QStringLiteral("\\W+")), Qt::SkipEmptyParts);
  const bool beginWords = std::ranges::all_of(words, [&](const QString& word) {
    return std::ranges::any_of(
        parts, [&](const QString& part) { return part.startsWith(word, Qt::CaseInsensitive); });
  });
  if (beginWords)
    return PresetHit::wordBegins;
  const bool areInName = std::ranges::all_of(
      words, [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
  return areInName ? PresetHit::inName : PresetHit::elsewhere;
}

PresetFilter::PresetFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setRecursiveFilteringEnabled(true);
}

void PresetFilter::search(const QString& text) {
  m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidate();
  sort(m_words.isEmpty() ? -1 : 0); // −1: the order of the list
}

QVariant PresetFilter::data(const QModelIndex& index, int role) const {
  if (role != presetRole::isBestHit)
    return QSortFilterProxyModel::data(index, role);
  const QModelIndex group = index.parent();
  return !m_words.isEmpty() && group.isValid() && group.row() == 0 && index.row() == 0;
}

bool PresetFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QString text =
      sourceModel()->index(row, 0, parent).data(presetRole::searchText).toString(); // none of a group
  return std::ranges::all_of(m_words,
                             [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

// Rows that are equally good stay in their order: Qt sorts stably.
bool PresetFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  return rankOf(left) < rankOf(right);
}

// A group is as good as the best of its presets that is found.
int PresetFilter::rankOf(const QModelIndex& index) const {
  constexpr int hits = static_cast<int>(PresetHit::elsewhere) + 1;
  if (!index.data(presetRole::isGroup).toBool()) {
    const int besideVolume = std::max(0, index.data(presetRole::standing).toInt() - 1);
    return hits * besideVolume + static_cast<int>(presetHit(index.data().toString(), m_words));
  }
  int best = std::numeric_limits<int>::max();
  for (int row = 0; row < sourceModel()->rowCount(index); ++row)
    if (filterAcceptsRow(row, index))
      best = std::min(best, rankOf(sourceModel()->index(row, 0, index)));
  return best;
}

} // namespace limn
