// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/BackgroundWork.h"
#include "app/opening/OpeningDesk.h"

#include <QPointer>

class QAction;
class QWidget;

namespace limn {

class CompareView;
class DicomDialog;
class MessageBar;
class SaveNotes;
class Session;
class Settings;

/// Saves picture and look of a DICOM series for an archive, and offers the looks that lie beside a series
/// that was opened; both beside the event loop.
class DicomDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    const Session& session;
    const OpenDocument& document;
    const CompareView& view;
    OpeningDesk& opening;
    Settings& settings;
    SaveNotes& notes;
    MessageBar& messages;
    QAction& saveDicom; ///< asks how; enabled while a DICOM series is open
    QWidget& window;
  };

  explicit DicomDesk(const Parts& parts);

private:
  void show();
  void showLosses(); ///< of what would be saved now
  void save();
  void lookForLooks(const LoadedScene& loaded, const Request& request);
  void offer(const QStringList& looks);
  Scene sceneToSave() const;

  Parts m_parts;
  QPointer<DicomDialog> m_dialog;
  BackgroundWork m_saving;
  BackgroundWork m_searching;
};

} // namespace limn
