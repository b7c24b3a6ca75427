// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>
#include <QStringList>

#include <array>
#include <functional>
#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QTimer;
class QToolButton;

namespace limn {

/// One sentence about what is shown: an error or a warning, with an action or two and further lines on
/// demand. Never modal. It lies over the lower edge of its parent, from which it takes no room; where that is
/// narrow, its buttons stand below the sentence. A note, which asks nothing and warns of nothing, goes by
/// itself.
class MessageBar : public QFrame {
  Q_OBJECT

public:
  explicit MessageBar(QWidget* parent = nullptr);

  enum class Kind { error, warning, note, question };

  /// A button beside the sentence: what it says and does. Empty: no button.
  struct Action {
    QString text;
    std::function<void()> run;
  };

  /// Shows a sentence; `details` (may be empty) unfold on demand. `dismissal` is what its last button says
  /// and does before the bar hides; `other` is what can be done instead of `action`.
  void show(Kind kind, const QString& sentence, const QStringList& details = {}, const Action& action = {},
            const Action& dismissal = {}, const Action& other = {});

  QString sentence() const;

  /// What a bar says, without what can be done about it.
  struct Said {
    Kind kind = Kind::note;
    QString sentence;
    QStringList details;
  };
  /// What it says now, for a bar that takes its place and shows it: a question, which nobody can answer
  /// there, as a note. Nothing while it says nothing.
  std::optional<Said> said() const;
  void show(const Said& said) { show(said.kind, said.sentence, said.details); }

  /// Keeps it from being seen while something more urgent is said; then it is seen again.
  void setHeldBack(bool isHeldBack);

  /// Whether what had to wait goes by itself once it is seen, as a note does: what can be had elsewhere shall
  /// not ask to be dismissed after something else was. Not at first.
  void setBriefWhenLate(bool isBrief) { m_isBriefWhenLate = isBrief; }

  /// Where it must not lie, in its parent's pixels; empty: nowhere, as at first. It stands beside that, or
  /// above where too little room is left.
  void setKeptFree(std::function<QRect()> keptFree) { m_keptFree = std::move(keptFree); }
  /// What is kept free may be elsewhere now.
  void lookAgain();

  /// A widget within its parent that it lies over where all that it says has room there; otherwise, and at
  /// first, it lies over all of its parent.
  void setPart(QWidget& part);

  /// Whether it is seen, or would be unless it were held back.
  bool isWanted() const { return m_isWanted; }

  /// Whether what it says then is a question, to which nobody has answered yet.
  bool isAsking() const { return m_isWanted && m_kind == Kind::question; }
  /// Whether it is that something went wrong, or a note.
  bool isError() const { return m_isWanted && m_kind == Kind::error; }
  bool isNote() const { return m_isWanted && m_kind == Kind::note; }

  /// How long a note stands that offers nothing, ms: as long as reading it takes twice.
  static int readingMs(const QString& sentence);

  void setVisible(bool visible) override;

signals:
  void wanted(); ///< or no longer, or for something else

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;

private:
  void layOver();
  QRect placeIn(const QRect& room);
  QRect placeOver(const QRect& area);
  bool fits(const QRect& place) const;
  int heightAt(int width) const; ///< that it needs
  void arrangeIn(int width);
  void offer(QToolButton& button, const Action& action);
  std::array<QToolButton*, 4> buttons() const { return {m_action, m_other, m_more, m_close}; }
  void goInTime();

  QBoxLayout* m_row; ///< of the sentence and the buttons
  QLabel* m_sentence;
  QLabel* m_details;
  QToolButton* m_more;
  QToolButton* m_action;
  QToolButton* m_other;
  QToolButton* m_close;
  std::function<QRect()> m_keptFree = [] { return QRect(); };
  QRect m_laidBeside;       ///< what was kept free as it was laid out
  QPointer<QWidget> m_part; ///< of the parent; null: all of it
  std::function<void()> m_run;
  std::function<void()> m_runOther;
  std::function<void()> m_dismiss;
  QTimer* m_end; ///< runs while a note stands that nobody reads
  Kind m_kind = Kind::note;
  bool m_isWanted = false;
  bool m_isHeldBack = false;
  bool m_isLate = false; ///< it was held back
  bool m_isBriefWhenLate = false;
};

/// Shows one message at a time: of those that want to be seen the first, but no note and no question
/// before an error, which answers what was just done. The others follow once it is gone.
class MessageOrder : public QObject {
  Q_OBJECT

public:
  /// The most urgent first.
  explicit MessageOrder(const std::vector<MessageBar*>& bars, QObject* parent);

private:
  void arrange();

  std::vector<MessageBar*> m_bars;
};

} // namespace limn
