// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/TitleController.h"

#include "app/document/DocumentText.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/MessageBar.h"

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

TitleController::TitleController(WindowContext& context)
    : QObject(&context.window), m_context(context),
      m_patientInTitle(context.actions.add(
          QStringLiteral("patientInTitle"),
          {.text = tr("Show the patient's &name in the title bar"), .isCheckable = true})) {
  context.actions.addSetting({.row = 5, .action = m_patientInTitle});
  m_patientInTitle->setChecked(context.settings.patientIsShown().value_or(false));
  connect(m_patientInTitle, &QAction::toggled, this, &TitleController::choose);
  connect(&context.session.undoStack(), &QUndoStack::cleanChanged, &context.window,
          [this](bool isClean) { m_context.window.setWindowModified(!isClean); });
}

void TitleController::show() {
  m_context.window.setWindowTitle(titleOf(m_context.document, m_patientInTitle->isChecked()));
  if (m_context.settings.patientIsShown() || !namesSomebody(m_context.document))
    m_context.patient.hide();
  else
    ask();
}

void TitleController::choose(bool isShown) {
  m_context.settings.setPatientIsShown(isShown);
  show();
}

void TitleController::ask() {
  m_context.patient.show(MessageBar::Kind::question,
                         tr("This volume carries its patient's name. Show it in the title bar?"), {},
                         {tr("Name the patient"), [this] { m_patientInTitle->setChecked(true); }},
                         {tr("Do not show it"), [this] { choose(false); }});
}

} // namespace limn
