// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QObject>
#include <QString>

#include <string>
#include <vector>

namespace limn {

class MessageBar;
class OpenDocument;
class OpeningDesk;
class OrientationDesk;
class Session;

/// What there is to say of a volume that was opened, with what can be done about it. What a person has
/// answered since is no longer said.
class RemarksDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    Session& session;
    const OpenDocument& document;
    MessageBar& messages;
    OpeningDesk& opening;         ///< asks for a spacing
    OrientationDesk& orientation; ///< asks for an orientation
  };
  RemarksDesk(const Parts& parts, QObject* parent);

  /// What to say of the volume that is open now; `notes` come from opening it.
  void show(const std::vector<Message>& notes);

private:
  void say();
  void followScene(const Scene& scene);

  Parts m_parts;
  std::vector<Message> m_notes;
  std::shared_ptr<const Volume> m_volume; ///< of which something is said
  QString m_said;                         ///< what the bar shows of it
};

} // namespace limn
