// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ChoiceRow.h"

#include "widgets/controls/FoldingSection.h"
#include "widgets/controls/LabelledRow.h"

#include <QHBoxLayout>
#include <QStyleOptionComboBox>
#include <QStyledItemDelegate>
#include <QWheelEvent>

#include <algorithm>

namespace limn {
namespace {

constexpr int shortestBox = 120; // pixels, about what tracks and fields of the rows around it need

// Qt's own rows are as low as their words, whatever a style sheet says.
class RoomyRows : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int aroundWords = 4;
    return QStyledItemDelegate::sizeHint(option, index).grownBy({0, aroundWords, 0, aroundWords});
  }
};

// Long words make no panel wider.
class ElidedComboBox : public QuietComboBox {
public:
  QSize minimumSizeHint() const override {
    const QSize whole = QComboBox::minimumSizeHint();
    return {std::min(whole.width(), shortestBox), whole.height()};
  }
};

} // namespace

QuietComboBox::QuietComboBox(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
}

// Not before: a list is made for it, which most boxes never show.
void QuietComboBox::showPopup() {
  if (!dynamic_cast<RoomyRows*>(itemDelegate()))
    setItemDelegate(new RoomyRows(this));
  QComboBox::showPopup();
}

void QuietComboBox::initStyleOption(QStyleOptionComboBox* option) const {
  constexpr int besideIcon = 4;
  QComboBox::initStyleOption(option);
  const QRect field =
      style()->subControlRect(QStyle::CC_ComboBox, option, QStyle::SC_ComboBoxEditField, this);
  const int icon = option->currentIcon.isNull() ? 0 : option->iconSize.width() + besideIcon;
  option->currentText =
      option->fontMetrics.elidedText(option->currentText, Qt::ElideRight, field.width() - icon);
}

void QuietComboBox::wheelEvent(QWheelEvent* event) {
  if (takesWheel(*this))
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

ChoiceRow::ChoiceRow(const QString& label, const QString& help, const QStringList& choices, int defaultIndex,
                     QWidget* parent)
    : QWidget(parent), m_called(label),
      m_toolTip(tr("<p>%1</p><p>%2; default %3. Double click on the name to reset.</p>")
                    .arg(help, choices.join(QStringLiteral(", ")), choices.at(defaultIndex))),
      m_default(defaultIndex), m_label(new ResetLabel(label)), m_box(new ElidedComboBox) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_label);
  layout->addWidget(m_box, 1);
  m_label->setFixedWidth(labelColumn);
  m_label->setWordWrap(true);
  m_box->addItems(choices);
  m_box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_box->setAccessibleName(label);
  m_label->setBuddy(m_box);
  setUnavailable({});
  setIndex(defaultIndex);
  connect(m_box, &QComboBox::activated, this, &ChoiceRow::edit);
  connect(m_label, &ResetLabel::resetRequested, this, [this] { edit(m_default); });
}

void ChoiceRow::setIndex(int index) {
  m_index = index;
  m_box->setCurrentIndex(index);
}

void ChoiceRow::setUnavailable(const QString& reason) {
  setEnabled(reason.isEmpty());
  setToolTip(reason.isEmpty() ? m_toolTip : reason);
}

void ChoiceRow::edit(int index) {
  if (index == m_index)
    return;
  const QString before = m_box->itemText(m_index);
  setIndex(index);
  emit indexEdited(index, choiceGesture(m_called, before, m_box->itemText(index)));
}

} // namespace limn
