// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QObject>
#include <QPointer>

class QAction;
class QActionGroup;
class QWidget;

namespace limn {

class OrientationDialog;
class Session;

/// How the voxels lie in the patient where a person says so, because the file does not; one undo step for
/// each answer. Standard views carry the patient's sides only where those are known.
class OrientationDesk : public QObject {
  Q_OBJECT

public:
  /// What it works with; all outlive it.
  struct Parts {
    Session& session;
    QAction& setOrientation;
    QActionGroup& views; ///< data: StandardView as int
    QWidget& window;
  };
  explicit OrientationDesk(const Parts& parts);

  void ask();

private:
  void showScene(const Scene& scene);
  void orient(const std::string& letters);
  void takeBack();

  Parts m_parts;
  std::shared_ptr<const Volume> m_volume;
  std::shared_ptr<const Volume> m_asFound;  ///< when the dialog was opened
  std::shared_ptr<const Volume> m_answered; ///< as the dialog turned it; null before its first answer
  QStringList m_viewNames;                  ///< of the standard views where the sides are known
  QPointer<OrientationDialog> m_dialog;
};

} // namespace limn
