// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/LabelSection.h"

#include "scene/LabelLooks.h"
#include "scene/basics/Error.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/regions/LabelColor.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/controls/ListRows.h"
#include "widgets/properties/LabelGroups.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

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

constexpr int mostRowsShown = 8;

// Rows in which marks stand clear of each other.
class RowDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, listRowHeight});
  }
};

// Edits percents.
class PercentDelegate : public RowDelegate {
public:
  using RowDelegate::RowDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* field = new QSpinBox(parent);
    field->setRange(0, 100);
    field->setSuffix(LabelSection::tr(" %"));
    field->setAccessibleName(LabelSection::tr("Shown"));
    return field;
  }
};

// Of the segmentation's own labels: what was cut away by hand is none of them, nor is what is not the body.
std::vector<double> ownWeights(const Region& region) {
  std::vector<double> weights = region.weights;
  weights.resize(listedLabels(region));
  return weights;
}

QString summaryOf(const Region& region) {
  if (region.kind != Region::Kind::labels)
    return LabelSection::tr("none");
  const std::vector<double> own = ownWeights(region);
  const auto weighed = std::count_if(own.begin(), own.end(), [](double weight) { return weight != 1.0; });
  return weighed == 0 ? LabelSection::tr("%1 shown").arg(own.size())
                      : LabelSection::tr("%1 of %2 hidden or faded").arg(weighed).arg(own.size());
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
  return LabelTable::tr("%1 · %2 ± %3 · %4 – %5")
      .arg(size, number(figures.mean), valueText(figures.deviation, unit, decimals), number(figures.lowest),
           valueText(figures.highest, unit, decimals));
}

// The region with another weight of the label at `place`, and what undo calls that.
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
  findColors(scene);
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

// Of those whose curve is another than before: it takes some thousand voxels each.
void LabelTable::findColors(const Scene& scene) {
  const Region& region = scene.keep;
  std::map<std::size_t, glm::dvec3> colors;
  const std::size_t listed = region.labels && scene.volume ? listedLabels(region) : 0;
  for (std::size_t place = 0; place < listed; ++place) {
    const std::size_t look = lookOfLabel(region, place), before = lookOfLabel(m_region, place);
    if (look == 0)
      continue;
    const auto known = m_colors.find(place);
    const bool isSame = known != m_colors.end() && region.labels == m_region.labels && before > 0 &&
                        region.looks[look - 1] == m_region.looks[before - 1];
    colors[place] = isSame ? known->second : shownColor(*scene.volume, region, place);
  }
  m_colors = std::move(colors);
}

void LabelTable::showRows(const std::vector<int>& rows, bool isShown, const QString& name) {
  Region edited = m_region;
  for (const int row : rows)
    edited.weights[static_cast<std::size_t>(row)] = isShown ? 1.0 : 0.0;
  if (edited != m_region)
    emit regionEdited(edited, {nextGestureId(), (isShown ? tr("show %1") : tr("hide %1")).arg(name)});
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
  return index.column() == nameColumn     ? nameData(place, role)
         : index.column() == weightColumn ? weightData(place, role)
                                          : curveData(place, role);
}

QVariant LabelTable::nameData(std::size_t place, int role) const {
  const Label& label = m_region.labels->labels()[place];
  switch (role) {
  case Qt::DisplayRole:
    return QString::fromStdString(label.name);
  case Qt::DecorationRole:
    return swatchOf(m_colors.contains(place) ? m_colors.at(place) : label.color);
  case Qt::CheckStateRole:
    return markOf(m_region.weights[place]);
  case typeRole:
    return QString::fromStdString(label.type);
  case categoryRole:
    return QString::fromStdString(label.category);
  case Qt::ToolTipRole:
    return tr("%1 (label %2): shown, hidden, or faded where only a part of its opacity is kept.")
               .arg(QString::fromStdString(label.name))
               .arg(label.value) +
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

LabelSection::LabelSection(QWidget* parent)
    : FoldingSection(tr("Labels"), parent), m_labels(new LabelTable(this)), m_tree(new LabelTree(this)),
      m_found(new QSortFilterProxyModel(this)), m_search(new QLineEdit), m_table(new QTreeView),
      m_open(new QPushButton(tr("Open labels…"))), m_showAll(new QPushButton(tr("Show all"))) {
  m_tree->setSourceModel(m_labels);
  m_found->setSourceModel(m_tree);
  m_found->setRecursiveFilteringEnabled(true);
  m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
  m_search->setPlaceholderText(tr("Search labels"));
  m_search->setAccessibleName(tr("Search labels"));
  m_search->setToolTip(tr("Shows only labels whose name holds these words"));
  m_search->setClearButtonEnabled(true);
  for (QToolButton* button : m_search->findChildren<QToolButton*>()) // Qt's own, without a name
    button->setAccessibleName(tr("Clear the search"));
  connect(m_search, &QLineEdit::textChanged, this, [this](const QString& words) {
    m_found->setFilterFixedString(words);
    if (!words.isEmpty())
      m_table->expandAll(); // what was found is seen
  });
  m_table->setModel(m_found);
  m_table->setItemDelegate(new RowDelegate(m_table));
  m_table->setItemDelegateForColumn(LabelTable::weightColumn, new PercentDelegate(m_table));
  m_table->setAccessibleName(tr("Labels"));
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                           QAbstractItemView::AnyKeyPressed);
  m_table->setToolTip(tr("Marked labels are shown; a number says how much of its opacity one keeps. One with "
                         "its own curve comes into the curve panel by a click."));
  m_table->setUniformRowHeights(true); // ten thousand rows are not measured
  m_table->header()->setStretchLastSection(false);
  m_table->header()->setSectionResizeMode(LabelTable::nameColumn, QHeaderView::Stretch);
  m_table->header()->setSectionResizeMode(LabelTable::weightColumn, QHeaderView::ResizeToContents);
  m_table->header()->setSectionResizeMode(LabelTable::curveColumn, QHeaderView::ResizeToContents);
  m_open->setAccessibleName(m_open->text());
  m_showAll->setAccessibleName(m_showAll->text());
  m_open->setToolTip(tr("Opens a segmentation of the volume: DICOM SEG, NRRD, NIfTI."));
  m_showAll->setToolTip(tr("Shows every label wholly again."));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_open);
  buttons->addWidget(m_showAll);
  buttons->addStretch();
  contents()->addWidget(m_search);
  contents()->addWidget(m_table);
  contents()->addLayout(buttons);
  connect(m_labels, &LabelTable::regionEdited, this, &LabelSection::keepEdited);
  connect(m_table, &QTreeView::expanded, this, &LabelSection::fitTable);
  connect(m_table, &QTreeView::collapsed, this, &LabelSection::fitTable);
  connect(m_tree, &LabelTree::groupShown, m_labels, &LabelTable::showRows);
  connect(m_labels, &LabelTable::refused, this, &LabelSection::refused);
  connect(m_labels, &QAbstractItemModel::modelReset, this, [this] {
    if (m_labels->rowCount() > 0)
      emit opened();
  });
  connect(m_labels, &LabelTable::curveGiven, this, &LabelSection::curveRequested);
  connect(m_table, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    const QModelIndex row = m_tree->mapToSource(m_found->mapToSource(index));
    if (!row.isValid())
      return; // a group
    const auto place = static_cast<std::size_t>(row.row());
    if (lookOfLabel(m_labels->region(), place) > 0)
      emit curveRequested(place);
  });
  connect(m_open, &QAbstractButton::clicked, this, &LabelSection::openRequested);
  connect(m_showAll, &QAbstractButton::clicked, this, [this] {
    Region all = m_labels->region();
    std::fill_n(all.weights.begin(), listedLabels(all), 1.0);
    emit keepEdited(all, {nextGestureId(), tr("show all labels")});
  });
  setScene({});
}

void LabelSection::setScene(const Scene& scene) {
  const bool hadRows = m_labels->rowCount() > 0;
  m_labels->setScene(scene);
  m_table->setRootIsDecorated(m_tree->hasGroups());
  const int rows = m_labels->rowCount();
  m_search->setVisible(rows > mostRowsShown);
  if (rows <= mostRowsShown)
    m_search->clear();
  if (rows > 0 && !hadRows)
    setFolded(false);
  fitTable();
  m_open->setEnabled(scene.volume != nullptr);
  m_showAll->setVisible(rows > 0);
  m_showAll->setEnabled(rows > 0 &&
                        ownWeights(scene.keep) != std::vector<double>(listedLabels(scene.keep), 1.0));
  setSummary(summaryOf(scene.keep));
}

// As high as its rows, whatever is searched for: an open group has more.
void LabelSection::fitTable() {
  int rows = m_tree->rowCount();
  for (int row = 0; row < m_tree->rowCount(); ++row)
    if (const QModelIndex group = m_tree->index(row, 0); m_table->isExpanded(m_found->mapFromSource(group)))
      rows += m_tree->rowCount(group);
  fitToRows(*m_table, rows, mostRowsShown);
}

void LabelSection::select(std::size_t place) {
  if (place >= static_cast<std::size_t>(m_labels->rowCount()))
    return;
  setFolded(false);
  const QModelIndex row = m_labels->index(static_cast<int>(place), LabelTable::nameColumn);
  const QModelIndex inTree = m_tree->mapFromSource(row);
  if (!m_found->mapFromSource(inTree).isValid())
    m_search->clear();
  m_table->expand(m_found->mapFromSource(inTree.parent()));
  m_table->setCurrentIndex(m_found->mapFromSource(inTree));
  m_table->scrollTo(m_table->currentIndex(), QAbstractItemView::PositionAtCenter);
}

} // namespace limn
