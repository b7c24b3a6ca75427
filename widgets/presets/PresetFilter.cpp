// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetFilter.h"

#include "widgets/presets/PresetModel.h"

#include <QRegularExpression>

#include <algorithm>

namespace limn {

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
  if (!index.data(presetRole::isGroup).toBool())
    return static_cast<int>(presetHit(index.data().toString(), m_words));
  int best = static_cast<int>(PresetHit::elsewhere) + 1;
  for (int row = 0; row < sourceModel()->rowCount(index); ++row)
    if (filterAcceptsRow(row, index))
      best = std::min(best, rankOf(sourceModel()->index(row, 0, index)));
  return best;
}

} // namespace limn
