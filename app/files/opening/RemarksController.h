// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/OpenDocument.h"
#include "widgets/controls/BackgroundWork.h"

#include <QObject>
#include <QString>

#include <string>
#include <vector>

namespace limn {

class OpeningController;
struct WindowContext;

/// What there is to say of a volume that was opened, with what can be done about it; what a person has
/// answered since is no longer said. Of a DICOM series it offers the looks that lie beside it, once it has
/// searched them beside the event loop.
class RemarksController : public QObject {
  Q_OBJECT

public:
  /// `opening` asks for a spacing.
  RemarksController(WindowContext& context, OpeningController& opening);

  /// What to say of the volume that is open now; `notes` come from opening it.
  void show(const std::vector<Message>& notes);

private:
  void say();
  void lookForLooks(const LoadedScene& loaded, const Request& request);
  void offer(const QStringList& looks);
  void followScene(const Scene& scene);

  WindowContext& m_context;
  OpeningController& m_opening;
  BackgroundWork m_searching;
  std::vector<Message> m_notes;
  std::shared_ptr<const Volume> m_volume; ///< of which something is said
  QString m_said;                         ///< what the bar shows of it
};

} // namespace limn
