// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/volume/CropBoxDesk.h"

#include "widgets/properties/CropSection.h"
#include "widgets/view/CompareView.h"

#include <QAction>
#include <QApplication>

namespace limn {

CropBoxDesk::CropBoxDesk(CompareView& view, const CropSection& section, QAction& action)
    : m_view(view), m_section(section), m_action(action) {
  view.addAction(&action);
  connect(&action, &QAction::toggled, this, &CropBoxDesk::show);
  connect(&section, &FoldingSection::foldedByUser, this, [this](bool folded) {
    m_isEdited = !folded;
    show();
  });
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget*, const QWidget* now) { followFocus(now); });
}

void CropBoxDesk::show() {
  m_view.setCropBoxVisible(m_action.isChecked() || m_isEdited);
}

void CropBoxDesk::followFocus(const QWidget* now) {
  if (!now)
    return; // another program's turn
  m_isEdited = m_section.isAncestorOf(now) || (m_isEdited && now == &m_view);
  show();
}

} // namespace limn
