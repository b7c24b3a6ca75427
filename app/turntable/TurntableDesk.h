// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/BackgroundWork.h"

#include <QPointer>
#include <QStringList>

class QAction;
class QWidget;

namespace limn {

class CompareView;
class OpenDocument;
class SaveNotes;
class SavingDesk;
class Settings;
class TurntableDialog;

/// Saves what is open from all around, beside the event loop.
class TurntableDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    const OpenDocument& document;
    const CompareView& view;
    const SavingDesk& saving; ///< says how files call the volume
    Settings& settings;
    SaveNotes& notes;
    QAction& saveTurntable; ///< asks for one
    QWidget& window;
  };

  explicit TurntableDesk(const Parts& parts);

private:
  void show();
  QStringList pictures() const;
  void save();

  Parts m_parts;
  QPointer<TurntableDialog> m_dialog;
  BackgroundWork m_work;
};

} // namespace limn
