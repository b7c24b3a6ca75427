// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/NamedView.h"

#include <QDialog>
#include <QObject>
#include <QPointer>
#include <QString>

#include <vector>

class QAction;
class QActionGroup;
class QLabel;
class QListWidget;
class QMenu;
class QPushButton;

namespace limn {

struct WindowContext;
struct Scene;

/// A view's name in one line of at most so many letters: in a list it must not push others away.
QString shortName(const NamedView& view, int mostLetters = 48);

/// Lists the named views, to look from there, rename and delete them. Asks for others, and is told them.
class ViewsDialog : public QDialog {
  Q_OBJECT

public:
  explicit ViewsDialog(QWidget* parent);

  void setViews(const std::vector<NamedView>& views);

signals:
  void viewChosen(const limn::Camera& camera);
  /// `what` is what undo calls it.
  void viewsEdited(const std::vector<limn::NamedView>& views, const QString& what);

private:
  void rename(int row, const QString& name);
  void remove();
  void lookFrom();
  void showButtons();
  void showViews();

  std::vector<NamedView> m_views;
  QListWidget* m_list;
  QLabel* m_note;
  QPushButton* m_look;
  QPushButton* m_rename;
  QPushButton* m_delete;
};

/// Cameras that are kept under names, until another volume is opened: kept, gone back to, renamed, deleted. A
/// look from one is a step of the camera's history; which there are is undone like other work.
class ViewsController : public QObject {
  Q_OBJECT

public:
  /// `menu` is that of the standard views, to whose end the named ones are added.
  ViewsController(WindowContext& context, QMenu& menu);

  /// Keeps the camera of now; another view of that name is replaced.
  void keep(const QString& name);

signals:
  void viewChosen(const limn::Camera& camera);

private:
  void askForName();
  void manage();
  void showViews(const std::vector<NamedView>& views);
  void showScene(const Scene& scene);

  WindowContext& m_context;
  QMenu& m_menu;
  QActionGroup* m_actions; ///< the one that keeps, then one for each view
  QAction* m_keep;
  QAction* m_manage;
  QPointer<ViewsDialog> m_dialog;
};

} // namespace limn
