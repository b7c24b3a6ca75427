// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QObject>
#include <QPointer>

class QAction;
class QActionGroup;
class QMenu;

namespace limn {

class OrientationDialog;
struct WindowContext;

/// How the voxels lie in the patient where a person says so, because the file does not; one undo step for
/// each answer. Standard views carry the patient's sides only where those are known.
class OrientationController : public QObject {
  Q_OBJECT

public:
  explicit OrientationController(WindowContext& context);

  void ask();

private:
  void addViews(QMenu& menu);
  void showScene(const Scene& scene);
  void orient(const std::string& letters);
  void takeBack();

  WindowContext& m_context;
  QActionGroup* m_views;     ///< data: StandardView as int
  QAction* m_setOrientation; ///< enabled where a file says nothing
  std::shared_ptr<const Volume> m_volume;
  std::shared_ptr<const Volume> m_asFound;  ///< when the dialog was opened
  std::shared_ptr<const Volume> m_answered; ///< as the dialog turned it; null before its first answer
  QStringList m_viewNames;                  ///< of the standard views where the sides are known
  QPointer<OrientationDialog> m_dialog;
};

} // namespace limn
