// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/CutSection.h"

#include "widgets/ValueText.h"
#include "widgets/controls/ListRows.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int mostCutsShown = 6;

constexpr int nameRole = Qt::UserRole; // what a person calls a cut; else it is called by what it does

// Edits the name alone, without the number before it.
class CutNameDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    static_cast<QLineEdit*>(editor)->setText(index.data(nameRole).toString());
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
    model->setData(index, static_cast<QLineEdit*>(editor)->text().simplified(), nameRole);
  }
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* editor = new QLineEdit(parent);
    editor->setAccessibleName(CutSection::tr("Name of the cut"));
    return editor;
  }
};

QString summaryOf(const std::vector<Cut>& cuts) {
  if (cuts.empty())
    return CutSection::tr("none");
  const auto on = std::count_if(cuts.begin(), cuts.end(), [](const Cut& cut) { return cut.isOn; });
  return on == static_cast<std::ptrdiff_t>(cuts.size())
             ? CutSection::tr("%1 on").arg(cuts.size())
             : CutSection::tr("%1 of %2 on").arg(on).arg(cuts.size());
}

} // namespace

ValueRange foundRange(const ConnectedPiece& piece, const Volume& volume) {
  const ValueRange all = volume.range();
  return {std::max(piece.range.x, all.lowest), std::min(piece.range.y, all.highest)};
}

QString cutText(const Cut& cut, const Volume& volume) {
  if (const auto* scissors = std::get_if<Scissors>(&cut.how)) {
    const QString where =
        scissors->removesInside ? CutSection::tr("Scissors, inside") : CutSection::tr("Scissors, outside");
    // What is seen in the picture begins at the eye; a slab of slices lies within the volume.
    const bool isSlab = scissors->depthMm && scissors->depthMm->x > 0.0;
    return isSlab ? CutSection::tr("%1, %2 deep")
                        .arg(where,
                             valueText(scissors->depthMm->y - scissors->depthMm->x, CutSection::tr("mm"), 1))
           : scissors->depthMm ? CutSection::tr("%1, what is seen").arg(where)
                               : where;
  }
  const auto& piece = std::get<ConnectedPiece>(cut.how);
  const QString unit = QString::fromStdString(volume.info().unit);
  const int decimals = decimalsOfSpan(volume.range().highest - volume.range().lowest);
  const ValueRange found = foundRange(piece, volume);
  const QString range = CutSection::tr("%1 – %2").arg(valueText(found.lowest, {}, decimals),
                                                      valueText(found.highest, unit, decimals));
  switch (piece.fate) {
  case ConnectedPiece::Fate::alone:
    return CutSection::tr("Piece %1, alone").arg(range);
  case ConnectedPiece::Fate::ownLook:
    return CutSection::tr("Piece %1, own curve").arg(range);
  case ConnectedPiece::Fate::hidden:
    break;
  }
  return CutSection::tr("Piece %1, hidden").arg(range);
}

CutSection::CutSection(QWidget* parent)
    : FoldingSection(tr("Cuts"), parent), m_list(new QListWidget),
      m_scissors(new QPushButton(tr("Scissors"))), m_piece(new QPushButton(tr("Pick a piece"))),
      m_up(new QPushButton(tr("Up"))), m_down(new QPushButton(tr("Down"))),
      m_delete(new QPushButton(tr("Delete"))) {
  m_list->setAccessibleName(tr("Cuts"));
  m_list->setToolTip(tr("What was cut away or told apart, in order; marked cuts hold. A double click or F2 "
                        "names one; a piece with its own curve comes into the curve panel by a click."));
  m_list->setItemDelegate(new CutNameDelegate(m_list));
  m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  m_scissors->setToolTip(tr("Cuts along a line that you draw on the picture (X)."));
  m_piece->setToolTip(tr("Hides the connected piece that you click, or all but it, or gives it a curve of "
                         "its own (K)."));
  m_up->setToolTip(tr("Makes the chosen cut earlier."));
  m_down->setToolTip(tr("Makes the chosen cut later."));
  m_delete->setToolTip(tr("Takes the chosen cut back."));
  auto* tools = new QHBoxLayout;
  tools->addWidget(m_scissors);
  tools->addWidget(m_piece);
  tools->addStretch();
  auto* order = new QHBoxLayout;
  for (QPushButton* button : {m_up, m_down, m_delete})
    order->addWidget(button);
  order->addStretch();
  for (QPushButton* button : {m_scissors, m_piece, m_up, m_down, m_delete})
    button->setAccessibleName(button->text());
  contents()->addWidget(m_list);
  contents()->addLayout(order);
  contents()->addLayout(tools);
  connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
    std::vector<Cut> cuts = m_cuts;
    const auto row = static_cast<std::size_t>(m_list->row(item));
    const QString number = QString::number(row + 1);
    if (const std::string name = item->data(nameRole).toString().toStdString(); name != cuts[row].name) {
      cuts[row].name = name;
      // Once the editor is closed, which until then holds the item.
      QMetaObject::invokeMethod(
          this, [this, cuts, number] { emit cutsEdited(cuts, tr("name cut %1").arg(number)); },
          Qt::QueuedConnection);
      return;
    }
    cuts[row].isOn = item->checkState() == Qt::Checked;
    emit cutsEdited(cuts, cuts[row].isOn ? tr("switch cut %1 on").arg(number)
                                         : tr("switch cut %1 off").arg(number));
  });
  connect(m_list, &QListWidget::currentRowChanged, this, &CutSection::showButtons);
  connect(m_list, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
    if (const auto label = labelOfCut(m_keep, static_cast<std::size_t>(m_list->row(item))))
      emit curveRequested(*label);
  });
  connect(m_scissors, &QPushButton::clicked, this, &CutSection::scissorsRequested);
  connect(m_piece, &QPushButton::clicked, this, &CutSection::pieceRequested);
  connect(m_up, &QPushButton::clicked, this, [this] { moveBy(-1); });
  connect(m_down, &QPushButton::clicked, this, [this] { moveBy(1); });
  connect(m_delete, &QPushButton::clicked, this, &CutSection::remove);
  setScene({});
}

void CutSection::setScene(const Scene& scene) {
  const bool hadCuts = !m_cuts.empty();
  const std::vector<Cut>& cuts = scene.keep.cuts;
  const bool isMadeLast = m_volume == scene.volume && cuts.size() > m_cuts.size() &&
                          std::equal(m_cuts.begin(), m_cuts.end(), cuts.begin());
  m_scissors->setEnabled(scene.volume != nullptr);
  m_piece->setEnabled(scene.volume != nullptr);
  if (!hadCuts && !scene.keep.cuts.empty())
    setFolded(false);
  const bool isOther = m_cuts != scene.keep.cuts || m_volume != scene.volume;
  m_cuts = scene.volume ? scene.keep.cuts : std::vector<Cut>();
  m_keep = scene.keep;
  m_volume = scene.volume;
  if (isOther || m_cuts.empty())
    showCuts();
  if (isMadeLast) // or Delete would take another one back
    m_list->setCurrentRow(m_list->count() - 1);
}

void CutSection::showCuts() {
  const int row = m_list->currentRow();
  const QSignalBlocker blocker(m_list);
  m_list->clear();
  for (std::size_t n = 0; n < m_cuts.size(); ++n) {
    const QString what = cutText(m_cuts[n], *m_volume);
    const QString name = QString::fromStdString(m_cuts[n].name);
    auto* item = new QListWidgetItem(tr("%1  %2").arg(n + 1).arg(name.isEmpty() ? what : name), m_list);
    item->setData(nameRole, name);
    if (!name.isEmpty())
      item->setToolTip(what);
    item->setSizeHint({0, listRowHeight});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    item->setCheckState(m_cuts[n].isOn ? Qt::Checked : Qt::Unchecked);
  }
  const int rows = m_list->count();
  m_list->setCurrentRow(std::min(std::max(row, 0), rows - 1));
  fitToRows(*m_list, rows, mostCutsShown);
  setSummary(summaryOf(m_cuts));
  showButtons();
}

void CutSection::showButtons() {
  const int row = m_list->currentRow(), rows = m_list->count();
  for (QPushButton* button : {m_up, m_down, m_delete})
    button->setVisible(rows > 0);
  m_up->setEnabled(row > 0);
  m_down->setEnabled(row >= 0 && row + 1 < rows);
  m_delete->setEnabled(row >= 0);
}

void CutSection::moveBy(int rows) {
  const int row = m_list->currentRow();
  std::vector<Cut> cuts = m_cuts;
  std::swap(cuts[static_cast<std::size_t>(row)], cuts[static_cast<std::size_t>(row + rows)]);
  m_list->setCurrentRow(row + rows);
  // A button that ends here would leave the keyboard to the next one, which deletes.
  if (QPushButton* pressed = rows < 0 ? m_up : m_down; pressed->hasFocus() && !pressed->isEnabled())
    m_list->setFocus();
  emit cutsEdited(cuts, tr("move cut %1").arg(row + 1));
}

void CutSection::remove() {
  const int row = m_list->currentRow();
  std::vector<Cut> cuts = m_cuts;
  cuts.erase(cuts.begin() + row);
  emit cutsEdited(cuts, tr("delete cut %1").arg(row + 1));
}

} // namespace limn
