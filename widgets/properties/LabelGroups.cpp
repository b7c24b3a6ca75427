// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/LabelGroups.h"

#include "widgets/properties/LabelTable.h"

#include <QRegularExpression>

#include <algorithm>
#include <map>
#include <tuple>

namespace limn {
namespace {

constexpr std::size_t fewestInGroup = 3;

// In lower case; empty of a name of one word.
QString firstWord(const QString& name) {
  static const QRegularExpression end(QStringLiteral("[_ .-]"));
  const qsizetype at = name.indexOf(end);
  return at > 0 ? name.left(at).toLower() : QString();
}

} // namespace

std::vector<LabelGroup> groupsOf(const std::vector<LabelKind>& labels) {
  // What a label shares with others of its group, in lower case, and how it is written there.
  enum class By { type, name, category };
  struct Shared {
    QString key;
    QString name;
    By by = By::name;
    bool operator<(const Shared& other) const { return std::tie(by, key) < std::tie(other.by, other.key); }
  };
  std::vector<Shared> shared(labels.size());
  const auto join = [&](const auto& sharedOf) {
    std::map<QString, std::size_t> all, left;
    for (std::size_t n = 0; n < labels.size(); ++n) {
      const QString key = sharedOf(labels[n]).key;
      ++all[key];
      left[key] += shared[n].key.isEmpty() ? 1 : 0;
    }
    for (std::size_t n = 0; n < labels.size(); ++n) {
      const Shared by = sharedOf(labels[n]);
      // Every name says something; a type and a sort only some may have, of the background none is told.
      const std::size_t told = labels.size() - (by.by == By::name ? 0 : all[QString()]);
      if (shared[n].key.isEmpty() && !by.key.isEmpty() && left[by.key] >= fewestInGroup && all[by.key] < told)
        shared[n] = by;
    }
  };
  join([](const LabelKind& label) { return Shared{label.type.toLower(), label.type, By::type}; });
  join([](const LabelKind& label) {
    const QString word = firstWord(label.name);
    return Shared{word, label.name.left(word.size()), By::name};
  });
  join([](const LabelKind& label) { return Shared{label.category.toLower(), label.category, By::category}; });

  std::vector<LabelGroup> groups;
  std::map<Shared, std::size_t> begun;
  for (std::size_t n = 0; n < labels.size(); ++n) {
    const bool isInGroup = !shared[n].key.isEmpty();
    const auto [known, isNew] =
        isInGroup ? begun.try_emplace(shared[n], groups.size()) : std::pair(begun.end(), true);
    if (isNew)
      groups.push_back({shared[n].name, {}, shared[n].by == By::name});
    groups[isInGroup ? known->second : groups.size() - 1].labels.push_back(static_cast<int>(n));
  }
  return groups;
}

void LabelTree::setSourceModel(QAbstractItemModel* table) {
  beginResetModel();
  QAbstractProxyModel::setSourceModel(table);
  connect(table, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
  connect(table, &QAbstractItemModel::modelReset, this, [this] {
    regroup();
    endResetModel();
  });
  connect(table, &QAbstractItemModel::dataChanged, this, &LabelTree::passOn);
  regroup();
  endResetModel();
}

void LabelTree::regroup() {
  std::vector<LabelKind> labels;
  for (int row = 0; row < sourceModel()->rowCount(); ++row) {
    const QModelIndex label = sourceModel()->index(row, 0);
    labels.push_back({label.data().toString(), label.data(LabelTable::typeRole).toString(),
                      label.data(LabelTable::categoryRole).toString()});
  }
  m_groups = groupsOf(labels);
  m_placeOf.assign(labels.size(), {0, 0});
  for (std::size_t group = 0; group < m_groups.size(); ++group)
    for (std::size_t n = 0; n < m_groups[group].labels.size(); ++n)
      m_placeOf[static_cast<std::size_t>(m_groups[group].labels[n])] = {static_cast<int>(group),
                                                                        static_cast<int>(n)};
}

// Once for each parent, because a view measures its columns anew each time. What labels show their groups sum
// up.
void LabelTree::passOn(const QModelIndex& first, const QModelIndex& last) {
  const auto tell = [&](const QModelIndex& parent) {
    emit dataChanged(index(0, first.column(), parent), index(rowCount(parent) - 1, last.column(), parent));
  };
  tell({});
  for (int group = 0; group < rowCount(); ++group)
    if (const QModelIndex parent = index(group, 0); isGroup(parent))
      tell(parent);
}

bool LabelTree::isGroup(const QModelIndex& index) const {
  return index.isValid() && index.internalId() == 0 &&
         !m_groups[static_cast<std::size_t>(index.row())].name.isEmpty();
}

bool LabelTree::hasGroups() const {
  return std::ranges::any_of(m_groups, [](const LabelGroup& group) { return !group.name.isEmpty(); });
}

std::vector<int> LabelTree::labelsOf(const QModelIndex& index) const {
  if (isGroup(index))
    return m_groups[static_cast<std::size_t>(index.row())].labels;
  return index.isValid() ? std::vector{mapToSource(index).row()} : std::vector<int>();
}

QString LabelTree::nameOf(const QModelIndex& index) const {
  return isGroup(index) ? m_groups[static_cast<std::size_t>(index.row())].name
                        : index.siblingAtColumn(0).data().toString();
}

// Rows inside a group carry its number, counted from 1.
QModelIndex LabelTree::index(int row, int column, const QModelIndex& parent) const {
  if (row < 0 || row >= rowCount(parent) || column < 0 || column >= columnCount(parent))
    return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : 0);
}

QModelIndex LabelTree::parent(const QModelIndex& index) const {
  return index.isValid() && index.internalId() > 0
             ? createIndex(static_cast<int>(index.internalId()) - 1, 0, quintptr{0})
             : QModelIndex();
}

int LabelTree::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid())
    return static_cast<int>(m_groups.size());
  return isGroup(parent) && parent.column() == 0
             ? static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].labels.size())
             : 0;
}

int LabelTree::columnCount(const QModelIndex&) const {
  return sourceModel() ? sourceModel()->columnCount() : 0;
}

QModelIndex LabelTree::mapToSource(const QModelIndex& index) const {
  if (!index.isValid() || isGroup(index))
    return {};
  const bool isInGroup = index.internalId() > 0;
  const std::size_t group = isInGroup ? index.internalId() - 1 : static_cast<std::size_t>(index.row());
  const auto n = static_cast<std::size_t>(isInGroup ? index.row() : 0);
  return sourceModel()->index(m_groups[group].labels[n], index.column());
}

QModelIndex LabelTree::mapFromSource(const QModelIndex& source) const {
  if (!source.isValid() || static_cast<std::size_t>(source.row()) >= m_placeOf.size())
    return {};
  const auto& [group, n] = m_placeOf[static_cast<std::size_t>(source.row())];
  const bool isInGroup = !m_groups[static_cast<std::size_t>(group)].name.isEmpty();
  return isInGroup ? createIndex(n, source.column(), static_cast<quintptr>(group) + 1)
                   : createIndex(group, source.column(), quintptr{0});
}

Qt::CheckState LabelTree::markOf(const LabelGroup& group) const {
  const auto mark = [this](int label) {
    return sourceModel()->index(label, 0).data(Qt::CheckStateRole).toInt();
  };
  const int first = mark(group.labels.front());
  return std::ranges::all_of(group.labels, [&](int label) { return mark(label) == first; })
             ? static_cast<Qt::CheckState>(first)
             : Qt::PartiallyChecked;
}

QVariant LabelTree::data(const QModelIndex& index, int role) const {
  if (!isGroup(index))
    return QAbstractProxyModel::data(index, role);
  const LabelGroup& group = m_groups[static_cast<std::size_t>(index.row())];
  if (index.column() != 0)
    return {};
  switch (role) {
  case Qt::DisplayRole:
    return tr("%1 (%2)").arg(group.name).arg(group.labels.size());
  case Qt::CheckStateRole:
    return markOf(group);
  case Qt::ToolTipRole:
    return (group.isByName
                ? tr("%1 labels whose names begin with \"%2\": a click on the mark shows or hides all of "
                     "them.")
                : tr("%1 labels that their file counts as \"%2\": a click on the mark shows or hides all of "
                     "them."))
        .arg(group.labels.size())
        .arg(group.name);
  default:
    return {};
  }
}

QVariant LabelTree::headerData(int section, Qt::Orientation orientation, int role) const {
  return sourceModel() ? sourceModel()->headerData(section, orientation, role) : QVariant();
}

Qt::ItemFlags LabelTree::flags(const QModelIndex& index) const {
  if (!isGroup(index))
    return QAbstractProxyModel::flags(index);
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == 0 ? flags | Qt::ItemIsUserCheckable : flags;
}

// A click hides what can be seen of it at all, and shows wholly what cannot, as of a label.
bool LabelTree::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!isGroup(index))
    return QAbstractProxyModel::setData(index, value, role);
  if (index.column() != 0 || role != Qt::CheckStateRole)
    return false;
  const LabelGroup& group = m_groups[static_cast<std::size_t>(index.row())];
  emit groupShown(group.labels, markOf(group) == Qt::Unchecked, group.name);
  return true;
}

} // namespace limn
