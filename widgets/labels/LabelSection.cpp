// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/labels/LabelSection.h"

#include "widgets/labels/LabelTable.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSpinBox>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

constexpr int mostRowsShown = 8;

// Rows in which marks stand clear of each other.
class RowDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, 24});
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

QString summaryOf(const Region& region) {
  if (region.kind != Region::Kind::labels)
    return LabelSection::tr("none");
  const auto weighed = std::count_if(region.weights.begin(), region.weights.end(),
                                     [](double weight) { return weight != 1.0; });
  return weighed == 0 ? LabelSection::tr("%1 shown").arg(region.weights.size())
                      : LabelSection::tr("%1 of %2 hidden or faded").arg(weighed).arg(region.weights.size());
}

} // namespace

LabelSection::LabelSection(QWidget* parent)
    : FoldingSection(tr("Labels"), parent), m_labels(new LabelTable(this)), m_table(new QTreeView),
      m_open(new QPushButton(tr("Open labels…"))), m_showAll(new QPushButton(tr("Show all"))) {
  m_table->setModel(m_labels);
  m_table->setItemDelegate(new RowDelegate(m_table));
  m_table->setItemDelegateForColumn(LabelTable::weightColumn, new PercentDelegate(m_table));
  m_table->setAccessibleName(tr("Labels"));
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                           QAbstractItemView::AnyKeyPressed);
  m_table->setToolTip(tr("Marked labels are shown; a number says how much of its opacity one keeps."));
  m_table->setRootIsDecorated(false);
  m_table->setUniformRowHeights(true); // ten thousand rows are not measured
  m_table->header()->setStretchLastSection(false);
  m_table->header()->setSectionResizeMode(LabelTable::nameColumn, QHeaderView::Stretch);
  m_table->header()->setSectionResizeMode(LabelTable::weightColumn, QHeaderView::ResizeToContents);
  m_open->setAccessibleName(m_open->text());
  m_showAll->setAccessibleName(m_showAll->text());
  m_open->setToolTip(tr("Opens a segmentation of the volume: DICOM SEG, NRRD, NIfTI."));
  m_showAll->setToolTip(tr("Shows every label wholly again."));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_open);
  buttons->addWidget(m_showAll);
  buttons->addStretch();
  contents()->addWidget(m_table);
  contents()->addLayout(buttons);
  connect(m_labels, &LabelTable::regionEdited, this, &LabelSection::keepEdited);
  connect(m_open, &QAbstractButton::clicked, this, &LabelSection::openRequested);
  connect(m_showAll, &QAbstractButton::clicked, this, [this] {
    Region all = m_labels->region();
    std::fill(all.weights.begin(), all.weights.end(), 1.0);
    emit keepEdited(all, {nextGestureId(), tr("show all labels")});
  });
  setScene({});
}

void LabelSection::setScene(const Scene& scene) {
  const bool hadRows = m_labels->rowCount() > 0;
  m_labels->setRegion(scene.keep);
  const int rows = m_labels->rowCount();
  if (rows > 0 && !hadRows)
    setFolded(false);
  m_table->setVisible(rows > 0);
  if (rows > 0)
    m_table->setFixedHeight(m_table->header()->sizeHint().height() + 2 * m_table->frameWidth() +
                            std::min(rows, mostRowsShown) * m_table->sizeHintForRow(0));
  m_open->setEnabled(scene.volume != nullptr);
  m_showAll->setVisible(rows > 0);
  m_showAll->setEnabled(isRestricting(scene.keep));
  setSummary(summaryOf(scene.keep));
}

} // namespace limn
