// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QLabel;
class QLineEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class QWidget;

namespace limn {

class GuideView;

/// The guide in a window of its own, which blocks nothing: contents at the left, what is looked for above the
/// page. Ctrl+F looks, F3 and Shift+F3 go on; Alt+Left goes back to where a link was followed; Esc ends
/// looking, then closes.
class GuideWindow : public QDialog {
  Q_OBJECT

public:
  explicit GuideWindow(QWidget* parent = nullptr);

  /// Shows a place, such as "panels.presets".
  void showPlace(const QString& anchor);
  void look(const QString& words);

  const GuideView& page() const { return *m_page; }

protected:
  void reject() override;

private:
  QWidget* makeSearch();
  void fillContents();
  void noteFound();
  void noteScrolled();

  GuideView* m_page;
  QTreeWidget* m_contents;
  QLineEdit* m_search = nullptr;
  QToolButton* m_back = nullptr;
  QLabel* m_found = nullptr;
  QList<QTreeWidgetItem*> m_items; ///< by heading; that of its chapter for a heading of the third level
};

/// The place of the guide that speaks of the panel in which `focused` stands, such as "panels.presets"; the
/// first chapter where none does or it is null.
QString guidePlaceOf(const QWidget* focused);

} // namespace limn
