// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/frame/Callout.h"

#include <QObject>
#include <QPointer>

#include <vector>

namespace limn {

struct WindowContext;

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
  void go(int step);
  void say(const TourStep& step);
  void place();
  void end();

  WindowContext& m_context;
  int m_step = -1;
  bool m_offersSample = false; ///< by the step that is shown
  QPointer<Callout> m_callout;
  QPointer<CalloutFrame> m_frame;
  QPointer<QWidget> m_target;
  QPointer<QWidget> m_before; ///< which had the keyboard
};

} // namespace limn
