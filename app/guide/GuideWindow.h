// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guide/GuidePage.h"
#include "app/guide/GuideSearch.h"

#include <QDialog>
#include <QString>
#include <QTextBrowser>
#include <QTimer>

class QLabel;
class QLineEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class QWidget;

namespace limn {

/// The page of the guide: pictures as wide as the page at most, words that are looked for marked.
class GuideView : public QTextBrowser {
  Q_OBJECT

public:
  explicit GuideView(QWidget* parent = nullptr);

  const std::vector<GuideHeading>& headings() const { return m_page.headings; }

  /// Shows the place of an anchor at the top; does nothing where there is none.
  void goTo(const QString& anchor);
  /// The heading under which what is seen at the top stands; -1 above the first.
  int headingAtTop() const;
  /// Goes back to where the last link was followed; does nothing where none was.
  void goBack();
  bool canGoBack() const { return !m_left.empty(); }

  /// Marks every place of a text, whatever its case, and goes to the first from what is seen on. Of a text
  /// that stands nowhere these are the paragraphs and rows of tables that tell of its words, which may be a
  /// question (guideWordsOf). The number of places.
  int look(const QString& text);
  /// Goes to the next place or the one before, around the end; the number of it, from 1 on, or 0 for none.
  int step(int direction);
  int hits() const { return static_cast<int>(m_hits.size()); }
  int hitShown() const { return m_shown + 1; }

signals:
  void scrolled();

protected:
  QVariant loadResource(int type, const QUrl& name) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  // So many pixels below the top of a heading; of the page where that is -1.
  struct Place {
    int heading = -1;
    int beyond = 0;
  };

  void fitPage();
  int roomForPictures() const; ///< their greatest width, pixels
  Place placeAtTop() const;
  void showPlace(const Place& place);
  void layOut();
  void mark();
  int topOf(int heading) const;
  std::vector<QTextCursor> placesOf(const QList<GuideWord>& words) const;

  GuidePage m_page;
  std::vector<int> m_places; ///< of the headings in the document
  std::vector<QTextCursor> m_hits;
  std::vector<Place> m_left; ///< where links were followed
  QString m_looked;          ///< what they are of
  int m_shown = -1;          ///< of the hits
  int m_width = 0;           ///< for which pictures were made, pixels
  QTimer m_layOut; ///< once the event that asks for it is over: a page must not change while it is laid out
};

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
