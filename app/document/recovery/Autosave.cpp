// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery/Autosave.h"

#include "io/AtomicFile.h"
#include "widgets/Translated.h"

#include <mutex>

namespace limn {

// What the threads share. It may outlive the object: a loader may still hold what saves.
struct Autosave::Shared {
  struct State {
    std::uint64_t number = 0; ///< later ones have larger numbers
    std::optional<SessionDocument> session;
  };

  std::filesystem::path file;
  std::mutex mutex; ///< guards what follows
  std::condition_variable_any wake;
  std::uint64_t lastNumber = 0;
  std::optional<State> waiting;
  /// Takes why writing failed, or that it did not; empty once the object is gone.
  std::function<void(const std::optional<QString>& problem)> tell;

  std::mutex writing; ///< guards what follows and the file
  std::uint64_t written = 0;
  std::optional<SessionDocument> onDisk;
  bool hasFailed = false;

  State numbered(std::optional<SessionDocument> session) {
    const std::lock_guard guard(mutex);
    return {++lastNumber, std::move(session)};
  }

  bool write(const State& state) {
    const std::lock_guard guard(writing);
    if (state.number <= written)
      return !hasFailed; // a later one came first
    written = state.number;
    if (!hasFailed && state.session == onDisk)
      return true;
    try {
      if (state.session)
        writeFileAtomically(file, sessionToJson(*state.session), FilePlace::fixedPrivate);
      else
        std::filesystem::remove(file);
      onDisk = state.session;
      hasFailed = false;
      report(std::nullopt);
    } catch (const std::exception& error) {
      hasFailed = true;
      report(translated(error));
    }
    return !hasFailed;
  }

  void report(const std::optional<QString>& problem) {
    const std::lock_guard guard(mutex);
    if (tell)
      tell(problem);
  }
};

Autosave::Autosave(std::filesystem::path file, std::function<std::optional<SessionDocument>()> current,
                   QObject* parent)
    : QObject(parent), m_shared(std::make_shared<Shared>()), m_current(std::move(current)) {
  m_shared->file = std::move(file);
  m_shared->tell = [this](const std::optional<QString>& problem) {
    QMetaObject::invokeMethod(
        this, [this, problem] { takeOutcome(problem); }, Qt::QueuedConnection);
  };
  m_timer.setSingleShot(true);
  m_timer.setInterval(intervalMs);
  connect(&m_timer, &QTimer::timeout, this, &Autosave::save);
  m_thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

Autosave::~Autosave() {
  m_thread.request_stop();
  m_thread.join();
  const std::lock_guard guard(m_shared->mutex);
  m_shared->tell = {};
}

void Autosave::takeOutcome(const std::optional<QString>& problem) {
  const bool isNew = m_isFailing != problem.has_value();
  m_isFailing = problem.has_value();
  if (problem)
    noteChange(); // there may be room again although nothing changes
  if (isNew && problem)
    emit failed(*problem);
  else if (isNew)
    emit recovered();
}

// Not started anew by every change: a long gesture is saved on its way.
void Autosave::noteChange() {
  if (!m_timer.isActive())
    m_timer.start();
}

void Autosave::save() {
  Shared::State state = m_shared->numbered(m_current());
  const std::lock_guard guard(m_shared->mutex);
  m_shared->waiting = std::move(state);
  m_shared->wake.notify_one();
}

std::function<bool()> Autosave::savingOfNow() {
  m_timer.stop();
  return [shared = m_shared, state = m_shared->numbered(m_current())] { return shared->write(state); };
}

void Autosave::work(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::unique_lock guard(m_shared->mutex);
    if (!m_shared->wake.wait(guard, stop, [this] { return m_shared->waiting.has_value(); }))
      return;
    const Shared::State state = std::move(*m_shared->waiting);
    m_shared->waiting.reset();
    guard.unlock();
    m_shared->write(state);
  }
}

} // namespace limn
