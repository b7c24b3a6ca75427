// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/SearchField.h"

#include "widgets/theme/Icons.h"

#include <QAction>
#include <QIcon>
#include <QKeyEvent>
#include <QToolButton>

namespace limn {

SearchField::SearchField(const QString& name, QWidget* parent)
    : QLineEdit(parent), m_icon(addAction(QIcon(), LeadingPosition)) {
  setPlaceholderText(name);
  setAccessibleName(name);
  setClearButtonEnabled(true);
  for (QToolButton* button : findChildren<QToolButton*>()) // Qt's own, without names
    button->setAccessibleName(button->defaultAction() == m_icon ? name : tr("Clear the search"));
  showIcon();
}

bool SearchField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && text().isEmpty()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void SearchField::changeEvent(QEvent* event) {
  QLineEdit::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
    showIcon();
}

void SearchField::showIcon() {
  m_icon->setIcon(themedIcon(QStringLiteral("search"), palette()));
}

} // namespace limn
