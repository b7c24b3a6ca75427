// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/MeasureSection.h"

#include "widgets/controls/ListRows.h"
#include "widgets/theme/Icons.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace limn {
namespace {

enum MeasureColumn { measureName, measureValue };

constexpr int mostMeasuresShown = 8;

QString measureHelp(Measurement::Kind kind) {
  switch (kind) {
  case Measurement::Kind::distance:
    return MeasureSection::tr(
        "Measures from one end to the other: drag in a slice, or click both ends in the "
        "picture (D).");
  case Measurement::Kind::angle:
    return MeasureSection::tr("Measures at a corner: drag from an end to it in a slice and click the other "
                              "end, or click all three in the picture (G).");
  case Measurement::Kind::ellipse:
    return MeasureSection::tr("Mean, deviation and area of what lies in an ellipse: drag in a slice (E).");
  case Measurement::Kind::mark:
    return MeasureSection::tr("Marks a place: click in a slice or in the picture (N).");
  }
  return {};
}

// What the first column says: the name, or what kind it is.
QString rowName(const Measured& measured) {
  return measured.measurement.name.empty() ? measureKindText(measured.measurement.kind)
                                           : QString::fromStdString(measured.measurement.name);
}

QIcon iconOf(Measurement::Kind kind, const QPalette& palette) {
  return themedIcon(QLatin1String(nameOf(kind)), palette);
}

} // namespace

MeasureSection::MeasureSection(QWidget* parent)
    : FoldingSection(tr("Measurements"), parent), m_list(new QTreeWidget),
      m_delete(new QPushButton(tr("Delete"))) {
  m_list->setObjectName(QStringLiteral("measurements"));
  m_list->setAccessibleName(tr("Measurements"));
  m_list->setToolTip(
      tr("What was measured; marked ones are shown. A click goes there, a double click renames."));
  m_list->setHeaderHidden(true);
  m_list->setColumnCount(2);
  m_list->setRootIsDecorated(false);
  m_list->setUniformRowHeights(true);
  m_list->setTextElideMode(Qt::ElideRight);
  m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  m_list->header()->setStretchLastSection(false);
  m_list->header()->setSectionResizeMode(measureName, QHeaderView::Stretch);
  m_list->header()->setSectionResizeMode(measureValue, QHeaderView::ResizeToContents);
  m_list->installEventFilter(this);
  m_delete->setAccessibleName(m_delete->text());
  m_delete->setToolTip(tr("Takes the chosen measurement away."));
  contents()->addWidget(m_list);
  addTools();
  showIcons();
  connect(m_list, &QTreeWidget::itemChanged, this,
          [this](QTreeWidgetItem* item) { takeRow(m_list->indexOfTopLevelItem(item)); });
  connect(m_list, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
    emit chosen(static_cast<std::size_t>(m_list->indexOfTopLevelItem(item)));
  });
  connect(m_list, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
    emit chosen(static_cast<std::size_t>(m_list->indexOfTopLevelItem(item)));
  });
  connect(m_delete, &QPushButton::clicked, this, &MeasureSection::remove);
  setMeasured({}, nullptr, std::nullopt);
}

void MeasureSection::addTools() {
  auto* row = new QHBoxLayout;
  for (const Measurement::Kind kind : measurementKinds) {
    auto* button = m_tools[static_cast<std::size_t>(kind)] = new QToolButton;
    button->setObjectName(QStringLiteral("measure-") + QLatin1String(nameOf(kind)));
    button->setAccessibleName(tr("Measure: %1").arg(measureKindText(kind)));
    button->setToolTip(measureHelp(kind));
    connect(button, &QToolButton::clicked, this, [this, kind] { emit toolRequested(kind); });
    row->addWidget(button);
  }
  row->addStretch();
  row->addWidget(m_delete);
  contents()->addLayout(row);
}

void MeasureSection::setMeasured(const std::vector<Measured>& measured,
                                 const std::shared_ptr<const Volume>& volume,
                                 std::optional<std::size_t> inHand) {
  const bool isFirst = m_measured.empty() && !measured.empty();
  if (isFirst)
    setFolded(false);
  m_measured = volume ? measured : std::vector<Measured>();
  m_volume = volume;
  showRows(inHand);
  for (QToolButton* button : m_tools)
    button->setEnabled(volume != nullptr);
  if (isFirst && inHand)
    emit begun();
}

// Rows stay as long as they can: what is being renamed in one of them would go.
void MeasureSection::showRows(std::optional<std::size_t> inHand) {
  const QSignalBlocker blocker(m_list);
  const int rows = static_cast<int>(m_measured.size());
  while (m_list->topLevelItemCount() > rows)
    delete m_list->takeTopLevelItem(m_list->topLevelItemCount() - 1);
  while (m_list->topLevelItemCount() < rows) {
    auto* item = new QTreeWidgetItem(m_list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    item->setSizeHint(measureName, {0, listRowHeight});
    item->setTextAlignment(measureValue, Qt::AlignRight | Qt::AlignVCenter);
  }
  for (std::size_t number = 0; number < m_measured.size(); ++number)
    showRow(number);
  m_list->setCurrentItem(
      inHand && *inHand < m_measured.size() ? m_list->topLevelItem(static_cast<int>(*inHand)) : nullptr);
  m_delete->setVisible(rows > 0);
  m_delete->setEnabled(m_list->currentItem() != nullptr);
  fitToRows(*m_list, rows, mostMeasuresShown);
  setSummary(rows == 0 ? tr("none") : QString::number(rows));
}

void MeasureSection::showRow(std::size_t number) {
  const Measured& measured = m_measured[number];
  QTreeWidgetItem* item = m_list->topLevelItem(static_cast<int>(number));
  item->setIcon(measureName, iconOf(measured.measurement.kind, palette()));
  item->setText(measureName, rowName(measured));
  item->setText(measureValue, measureValueText(measured, *m_volume));
  item->setCheckState(measureName, measured.measurement.isShown ? Qt::Checked : Qt::Unchecked);
  for (const int column : {measureName, measureValue})
    item->setToolTip(column, measureDetails(measured, *m_volume));
}

// What somebody did to a row: its mark, or its name. Of a value nothing can be edited.
void MeasureSection::takeRow(int row) {
  const auto number = static_cast<std::size_t>(row);
  if (row < 0 || number >= m_measured.size())
    return;
  const Measured& before = m_measured[number];
  const QTreeWidgetItem* item = m_list->topLevelItem(row);
  std::vector<Measurement> measurements = measurementsOf(m_measured);
  Measurement& edited = measurements[number];
  const QString title = measureTitle(before, *m_volume);
  QString gesture;
  if (const bool isShown = item->checkState(measureName) == Qt::Checked; isShown != edited.isShown) {
    edited.isShown = isShown;
    gesture = isShown ? tr("show: %1").arg(title) : tr("hide: %1").arg(title);
  } else if (const QString name = item->text(measureName).trimmed(); name != rowName(before)) {
    edited.name = name.toStdString();
    gesture = tr("rename: %1").arg(measureTitle({edited, before.ellipse}, *m_volume));
  } else {
    const QSignalBlocker blocker(m_list);
    showRow(number);
    return;
  }
  emit measurementsEdited({measurements, number, {nextGestureId(), gesture}});
}

void MeasureSection::remove() {
  if (const int row = m_list->indexOfTopLevelItem(m_list->currentItem()); row >= 0)
    emit measurementsEdited(withoutMeasure(m_measured, static_cast<std::size_t>(row), *m_volume));
}

void MeasureSection::showIcons() {
  for (const Measurement::Kind kind : measurementKinds)
    m_tools[static_cast<std::size_t>(kind)]->setIcon(iconOf(kind, palette()));
  const QSignalBlocker blocker(m_list);
  for (std::size_t number = 0; number < m_measured.size(); ++number)
    m_list->topLevelItem(static_cast<int>(number))
        ->setIcon(measureName, iconOf(m_measured[number].measurement.kind, palette()));
}

void MeasureSection::changeEvent(QEvent* event) {
  FoldingSection::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
    showIcons();
}

bool MeasureSection::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    remove();
    return true;
  }
  return FoldingSection::eventFilter(watched, event);
}

} // namespace limn
