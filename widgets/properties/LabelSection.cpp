// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/LabelSection.h"

#include "scene/regions/BodyAndLabels.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/ListRows.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/SearchField.h"
#include "widgets/properties/LabelGroups.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <utility>

namespace limn {
namespace {

constexpr int mostRowsShown = 8;

// Rows in which marks stand clear of each other. A click on the square of a row asks for another colour.
class RowDelegate : public QStyledItemDelegate {
public:
  using Ask = std::function<void(const QModelIndex& row, const QRect& square)>;

  RowDelegate(QTreeView& view, Ask askForColor)
      : QStyledItemDelegate(&view), m_view(view), m_askForColor(std::move(askForColor)) {
    view.setMouseTracking(true); // a square shows that it can be clicked
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, listRowHeight});
  }

  // Of a row, as high as that; empty where it has none.
  QRect squareOf(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    constexpr int besideSquare = 2;
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    if (shown.icon.isNull())
      return {};
    const QRect square = m_view.style()->subElementRect(QStyle::SE_ItemViewItemDecoration, &shown, &m_view);
    return {square.left() - besideSquare, option.rect.top(), square.width() + 2 * besideSquare,
            option.rect.height()};
  }

  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
    const auto type = event->type();
    if (type == QEvent::MouseMove || type == QEvent::MouseButtonRelease) {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const QRect square = squareOf(option, index);
      const bool isOnSquare = square.contains(mouse->position().toPoint());
      if (type == QEvent::MouseMove)
        m_view.viewport()->setCursor(isOnSquare ? Qt::PointingHandCursor : Qt::ArrowCursor);
      if (type == QEvent::MouseButtonRelease && isOnSquare && mouse->button() == Qt::LeftButton) {
        m_askForColor(index, square);
        return true;
      }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
  }

protected:
  // A square that is selected has its colour, too, where styles would blend the selection in.
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!option->icon.isNull())
      option->icon.addPixmap(option->icon.pixmap(option->decorationSize), QIcon::Selected);
  }

private:
  QTreeView& m_view;
  Ask m_askForColor;
};

// Edits percents. What does not fit is said at the field, which stays for another number; where it is left
// with that, `tell` says so.
class PercentDelegate : public RowDelegate {
public:
  using Tell = std::function<void(const QString& sentence)>;

  PercentDelegate(QTreeView& view, Ask askForColor, Tell tell)
      : RowDelegate(view, std::move(askForColor)), m_tell(std::move(tell)) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* field = new NumberField(0.0, 100.0, 0, parent);
    field->setUnit(QStringLiteral("%"));
    field->setAccessibleName(LabelSection::tr("Shown"));
    return field;
  }

  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    static_cast<NumberField*>(editor)->setNumber(index.data(Qt::EditRole).toDouble());
  }

  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
    auto& field = static_cast<NumberField&>(*editor);
    const bool isSaid = !field.refusal().isEmpty();
    if (!field.commit() && !isSaid)
      m_tell(field.refusal());
    if (field.number() != index.data(Qt::EditRole).toDouble()) // it rounds: an untouched one changes nothing
      model->setData(index, field.number());
  }

  bool eventFilter(QObject* editor, QEvent* event) override {
    if (event->type() == QEvent::KeyPress) {
      const int key = static_cast<QKeyEvent*>(event)->key();
      const bool endsTyping =
          key == Qt::Key_Enter || key == Qt::Key_Return || key == Qt::Key_Tab || key == Qt::Key_Backtab;
      if (endsTyping && !static_cast<NumberField*>(editor)->commit())
        return true; // to be typed once more
    }
    return RowDelegate::eventFilter(editor, event);
  }

private:
  Tell m_tell;
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

} // namespace

LabelSection::LabelSection(QWidget* parent)
    : FoldingSection(tr("Labels"), parent), m_labels(new LabelTable(this)), m_tree(new LabelTree(this)),
      m_found(new QSortFilterProxyModel(this)), m_search(new SearchField(tr("Search labels"))),
      m_table(new QTreeView), m_open(new QPushButton(tr("Open labels…"))),
      m_showAll(new QPushButton(tr("Show all"))) {
  m_tree->setSourceModel(m_labels);
  m_found->setSourceModel(m_tree);
  m_found->setRecursiveFilteringEnabled(true);
  m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
  m_search->setToolTip(tr("Shows only labels whose name holds these words"));
  connect(m_search, &QLineEdit::textChanged, this, [this](const QString& words) {
    m_found->setFilterFixedString(words);
    if (!words.isEmpty())
      m_table->expandAll(); // what was found is seen
  });
  m_table->setModel(m_found);
  const auto askForColor = [this](const QModelIndex& row, const QRect& square) { pickColor(row, square); };
  m_table->setItemDelegate(new RowDelegate(*m_table, askForColor));
  m_table->setItemDelegateForColumn(
      LabelTable::weightColumn, new PercentDelegate(*m_table, askForColor, [this](const QString& sentence) {
        emit refused(sentence);
      }));
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
  connect(m_labels, &LabelTable::curveGiven, this, &LabelSection::curveRequested);
  connect(m_table, &QTreeView::clicked, this, [this](const QModelIndex& row) {
    if (const auto place = labelAt(row); place && lookOfLabel(m_labels->region(), *place) > 0)
      emit curveRequested(*place);
  });
  m_table->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_table, &QWidget::customContextMenuRequested, this, &LabelSection::openMenu);
  connect(m_open, &QAbstractButton::clicked, this, &LabelSection::openRequested);
  connect(m_showAll, &QAbstractButton::clicked, m_labels, &LabelTable::showAll);
  setScene({});
}

void LabelSection::setScene(const Scene& scene) {
  const bool hadRows = m_labels->rowCount() > 0;
  m_labels->setScene(scene);
  m_table->setRootIsDecorated(m_tree->hasGroups());
  const int rows = m_labels->rowCount();
  // Cuts leave a segmentation what it is, and so does a hidden table.
  // Nor does another place of the same voxels.
  const bool isSame = m_volume && scene.volume && m_volume->sharesVoxelsWith(*scene.volume);
  const bool isOther = rows > 0 && (!hadRows || !isSame || sourcesOf(scene.keep) != m_sources);
  m_volume = rows > 0 ? scene.volume : nullptr;
  m_sources = sourcesOf(scene.keep);
  m_search->setVisible(rows > mostRowsShown);
  if (rows <= mostRowsShown)
    m_search->clear();
  if (isOther)
    setFolded(false);
  fitTable();
  m_open->setEnabled(scene.volume != nullptr);
  m_showAll->setVisible(rows > 0);
  m_showAll->setEnabled(rows > 0 && !m_labels->areAllShown());
  setSummary(summaryOf(scene.keep));
  if (isOther)
    emit opened();
}

// Nothing of a group.
std::optional<std::size_t> LabelSection::labelAt(const QModelIndex& row) const {
  const QModelIndex label = m_tree->mapToSource(m_found->mapToSource(row));
  return label.isValid() ? std::optional(static_cast<std::size_t>(label.row())) : std::nullopt;
}

void LabelSection::pickColor(const QModelIndex& row, const QRect& square) {
  const auto place = labelAt(row);
  if (!place)
    return;
  const QWidget* rows = m_table->viewport();
  const ColorPicker* picker =
      openColorPicker(m_labels->colorOf(*place), {rows->mapToGlobal(square.topLeft()), square.size()}, this);
  connect(
      picker, &ColorPicker::colorPicked, m_labels,
      [this, place](const glm::dvec3& color, std::uint64_t id) { m_labels->setColor(*place, color, id); });
  // The curve was not one colour, or there was none.
  connect(picker, &ColorPicker::takenBack, this,
          [this, place, before = m_labels->region()](std::uint64_t id) {
            if (before.labels == m_labels->region().labels)
              emit keepEdited(before, {id, m_labels->colorText(*place)});
          });
}

// A right click has made its row the current one; the key for menus has no place of its own. A group has no
// colour of its own.
void LabelSection::openMenu() {
  const QModelIndex row = m_table->currentIndex().siblingAtColumn(LabelTable::nameColumn);
  const QModelIndex inTree = m_found->mapToSource(row);
  const std::vector<int> labels = m_tree->labelsOf(inTree);
  if (labels.empty())
    return;
  const QString name = m_tree->nameOf(inTree);
  auto* menu = new QMenu(m_table);
  menu->setObjectName(QStringLiteral("labelMenu"));
  menu->setAccessibleName(name);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  // The labels may have become others while the menu was open.
  const auto ifThere = [row = QPersistentModelIndex(row)](const auto& act) {
    return [row, act] {
      if (row.isValid())
        act(QModelIndex(row));
    };
  };
  menu->addAction(tr("Show only this"), this,
                  ifThere([this, labels, name](const QModelIndex&) { m_labels->showOnly(labels, name); }))
      ->setEnabled(m_labels->canShowOnly(labels));
  menu->addAction(m_showAll->text(), m_labels, &LabelTable::showAll)->setEnabled(!m_labels->areAllShown());
  if (labelAt(row)) {
    menu->addSeparator();
    menu->addAction(tr("Colour…"), this, ifThere([this](const QModelIndex& label) {
                      pickColor(label, m_table->visualRect(label));
                    }));
  }
  menu->popup(m_table->viewport()->mapToGlobal(m_table->visualRect(row).bottomLeft()));
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
