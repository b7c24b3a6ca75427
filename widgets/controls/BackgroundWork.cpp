// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/BackgroundWork.h"

#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QMetaObject>

#include <new>

namespace limn {

void BackgroundWork::start(TellingTask task) {
  cancel();
  m_state = std::make_shared<State>();
  std::vector<std::jthread> before;
  if (m_turn == Turn::afterTheLast)
    before.swap(m_threads);
  m_threads.emplace_back(
      [this, state = m_state, task = std::move(task), before = std::move(before)]() mutable {
        before.clear(); // joins
        if (!state->isCancelled)
          run(state, task);
      });
}

void BackgroundWork::cancel() {
  if (m_state)
    m_state->isCancelled = true;
  m_state.reset();
}

void BackgroundWork::tell(const std::shared_ptr<State>& state, Deliver message) {
  QMetaObject::invokeMethod(
      this,
      [this, state, message = std::move(message)] {
        if (m_state == state)
          message();
      },
      Qt::QueuedConnection);
}

// On the work's thread.
void BackgroundWork::run(const std::shared_ptr<State>& state, const TellingTask& task) {
  Line line;
  line.tell = [this, state](Deliver message) { tell(state, std::move(message)); };
  Message last;
  std::chrono::steady_clock::time_point at{};
  line.report = [&](double fraction, const Message& doing) {
    const auto now = std::chrono::steady_clock::now();
    if (doing == last && now - at < betweenReports)
      return;
    last = doing;
    at = now;
    tell(state, [this, fraction, doing] { emit progressed(fraction, translated(doing)); });
  };
  line.effort.isCancelled = [state] { return state->isCancelled.load(); };
  line.effort.report = [&line](double fraction) { line.report(fraction, {}); };
  const auto fail = [&](const QString& sentence) {
    tell(state, [this, sentence] {
      m_state.reset();
      emit failed(sentence);
    });
  };
  try {
    Deliver deliver = task(line);
    tell(state, [this, deliver = std::move(deliver)] {
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
