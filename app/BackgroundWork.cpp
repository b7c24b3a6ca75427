// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/BackgroundWork.h"

#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QMetaObject>

#include <new>

namespace limn {

void BackgroundWork::start(Task task) {
  cancel();
  m_state = std::make_shared<State>();
  m_thread =
      std::jthread([this, state = m_state, task = std::move(task), before = std::move(m_thread)]() mutable {
        if (before.joinable())
          before.join();
        run(state, task);
      });
}

void BackgroundWork::cancel() {
  if (m_state)
    m_state->isCancelled = true;
  m_state.reset();
}

void BackgroundWork::tell(const std::shared_ptr<State>& state, std::function<void()> message) {
  QMetaObject::invokeMethod(
      this,
      [this, state, message = std::move(message)] {
        if (m_state == state)
          message();
      },
      Qt::QueuedConnection);
}

// On the work's thread.
void BackgroundWork::run(const std::shared_ptr<State>& state, const Task& task) {
  const Effort effort{
      0, [state] { return state->isCancelled.load(); },
      [this, state](double fraction) { tell(state, [this, fraction] { emit progressed(fraction); }); }};
  const auto fail = [&](const QString& sentence) {
    tell(state, [this, sentence] {
      m_state.reset();
      emit failed(sentence);
    });
  };
  try {
    const Deliver deliver = task(effort);
    tell(state, [this, deliver] {
      m_state.reset();
      deliver();
    });
  } catch (const Cancelled&) {
    // Whoever cancelled knows.
  } catch (const Error& error) {
    fail(translated(error));
  } catch (const std::bad_alloc&) {
    fail(tr("There is not enough memory for this; close other programs or ask for something smaller."));
  } catch (const std::exception& error) {
    fail(tr("An unexpected error: %1.").arg(QString::fromLocal8Bit(error.what())));
  }
}

} // namespace limn
