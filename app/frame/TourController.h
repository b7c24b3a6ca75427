// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QRect>
#include <QSize>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace limn {

struct WindowContext;

/// On which side of what it speaks of a call-out stands.
enum class CalloutSide { right, left, above, below, within };

/// Where a call-out stands, in the window's coordinates.
struct CalloutPlace {
  QRect box;
  CalloutSide side = CalloutSide::within;
  QPoint tip; ///< the point of its arrow, on the edge of what it speaks of; within: in the middle of the box
};

/// Beside `target` where there is room within `window`, at the side with the most, which for what is lower
/// than the box is above or below; otherwise over it, in its middle. `size` is that of the box, to which
/// `gap` pixels are added for the arrow. The box lies within the window wherever it is not larger.
CalloutPlace calloutPlace(const QRect& target, const QSize& size, const QRect& window, int gap);

/// What one step of the tour says.
struct CalloutText {
  QString title;
  QString text;
  QString place;  ///< "2 of 6"
  QString action; ///< what its own button does; empty: it has none
};

/// A box with an arrow that speaks of a part of the window and lies over it: Enter and Right go on, Left goes
/// back, Esc ends. It blocks nothing, and the rest of the window takes clicks and keys as ever.
class Callout : public QFrame {
  Q_OBJECT

public:
  explicit Callout(QWidget& window);

  void say(const CalloutText& text, bool isFirst, bool isLast);
  /// Where it speaks of `target`, in the window's coordinates.
  void pointAt(const QRect& target);
  void takeFocus();

signals:
  void next();
  void back();
  void ended();
  void actionRequested();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QLabel* m_title;
  QLabel* m_text;
  QLabel* m_place;
  QPushButton* m_action;
  QPushButton* m_end;
  QPushButton* m_back;
  QPushButton* m_next;
  CalloutPlace m_at;
};

/// A frame around the part of the window that a call-out speaks of; the pointer goes through it.
class CalloutFrame : public QWidget {
public:
  explicit CalloutFrame(QWidget& window);

protected:
  void paintEvent(QPaintEvent* event) override;
};

/// One step of the tour.
struct TourStep {
  QString title;
  QString text;
  QWidget* target; ///< what it speaks of; a panel that is hidden is shown
};

/// A tour of the window in six steps, which starts where somebody asks for it, is offered once, and blocks
/// nothing.
class TourController : public QObject {
  Q_OBJECT

public:
  explicit TourController(WindowContext& context);

  /// Asks whether to take it, once for each user.
  void offer();

  void start();
  /// The step that is shown, from 0 on; -1: none.
  int step() const { return m_step; }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::vector<TourStep> steps() const;
  TourStep savingStep() const;
  QString ofPicture() const; ///< a sentence
  void go(int step);
  void aimAt(QWidget& target);
  void follow();
  void say(const TourStep& step);
  void place();
  void end();

  WindowContext& m_context;
  int m_step = -1;
  QString m_said;              ///< by the step that is shown
  QString m_ofPicture;         ///< as that was said
  bool m_offersSample = false; ///< by the step that is shown
  QPointer<Callout> m_callout;
  QPointer<CalloutFrame> m_frame;
  QPointer<QWidget> m_target;
  QPointer<QWidget> m_before; ///< which had the keyboard
};

} // namespace limn
