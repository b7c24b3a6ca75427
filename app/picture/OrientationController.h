// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QDialog>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QStringList>

#include <array>
#include <string>

class QAction;
class QActionGroup;
class QComboBox;
class QMenu;

namespace limn {

struct WindowContext;

/// Asks where the columns, rows and slices of a volume run to in the patient. Each answer is told at once, so
/// that the picture shows it; the three always go to three directions.
class OrientationDialog : public QDialog {
  Q_OBJECT

public:
  /// `letters` hold at present, or are assumed (Orientation.h).
  OrientationDialog(const std::string& letters, QWidget* parent);

  void setLetters(const std::string& letters);

signals:
  void lettersChosen(const std::string& letters);

private:
  void choose(std::size_t axis, char letter);
  void flip(std::size_t axis);

  std::string m_letters;
  std::array<QComboBox*, 3> m_boxes{};
};

/// How the voxels lie in the patient where a person says so, because the file does not; one undo step for
/// each answer. Standard views carry the patient's sides only where those are known.
class OrientationController : public QObject {
  Q_OBJECT

public:
  explicit OrientationController(WindowContext& context);

  void ask();

  /// Of the standard views; others may add to its end.
  QMenu& menu() { return *m_menu; }

private:
  void addViews(QMenu& menu);
  QAction* addCube();
  void showScene(const Scene& scene);
  void orient(const std::string& letters);
  void takeBack();

  WindowContext& m_context;
  QMenu* m_menu;
  QActionGroup* m_views;     ///< data: StandardView as int
  QAction* m_setOrientation; ///< enabled where a file says nothing
  std::shared_ptr<const Volume> m_volume;
  std::shared_ptr<const Volume> m_asFound;  ///< when the dialog was opened
  std::shared_ptr<const Volume> m_answered; ///< as the dialog turned it; null before its first answer
  QStringList m_viewNames;                  ///< of the standard views where the sides are known
  QList<QKeySequence> m_viewKeys;           ///< of those, in the picture
  QPointer<OrientationDialog> m_dialog;
};

} // namespace limn
