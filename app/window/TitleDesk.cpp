// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/TitleDesk.h"

#include "app/Settings.h"
#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/window/MessageBar.h"

#include <QAction>
#include <QWidget>

namespace limn {
namespace {

// The sample's patient is an example.
bool namesSomebody(const OpenDocument& document) {
  const auto& volume = document.scene().volume;
  if (!volume || document.request().source == QLatin1String("sample"))
    return false;
  return !volume->info().patient.name.empty() || !volume->info().patient.id.empty();
}

} // namespace

TitleDesk::TitleDesk(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  m_parts.patientInTitle.setChecked(m_parts.settings.patientIsShown().value_or(false));
  connect(&m_parts.patientInTitle, &QAction::toggled, this, &TitleDesk::choose);
}

void TitleDesk::show() {
  m_parts.window.setWindowTitle(titleOf(m_parts.document, m_parts.patientInTitle.isChecked()));
  if (m_parts.settings.patientIsShown() || !namesSomebody(m_parts.document))
    m_parts.question.hide();
  else
    ask();
}

void TitleDesk::choose(bool isShown) {
  m_parts.settings.setPatientIsShown(isShown);
  show();
}

void TitleDesk::ask() {
  m_parts.question.show(MessageBar::Kind::question,
                        tr("This volume carries its patient's name. Show it in the title bar?"), {},
                        {tr("Name the patient"), [this] { m_parts.patientInTitle.setChecked(true); }},
                        {tr("Do not show it"), [this] { choose(false); }});
}

} // namespace limn
