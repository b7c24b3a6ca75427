// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/asking/SaveNotes.h"

#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"

#include <QFileInfo>
#include <QStatusBar>

namespace limn {

bool SaveNotes::attempt(const std::function<void()>& write, const QString& path) {
  try {
    write();
  } catch (const Error& error) {
    sayFailure(translated(error.sentence()));
    return false;
  }
  if (!path.isEmpty())
    m_status.showMessage(QObject::tr("Saved %1").arg(QFileInfo(path).fileName()), 4000);
  if (!m_failure.isEmpty() && m_messages.sentence() == m_failure)
    m_messages.hide();
  m_failure.clear();
  return true;
}

void SaveNotes::sayFailure(const QString& sentence) {
  m_failure = sentence;
  m_messages.show(MessageBar::Kind::error, sentence);
}

} // namespace limn
