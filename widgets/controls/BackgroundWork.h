// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Message.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace limn {

/// Two reports that say the same lie at least as far apart: each has the whole window painted, and work
/// reports thousands of times a second.
inline constexpr std::chrono::milliseconds betweenReports{50};

/// Does one piece of work at a time beside the event loop: new work ends what runs. Of ended work nothing
/// more is told, and no thread outlives this. Signals come on the thread it lives in.
class BackgroundWork : public QObject {
  Q_OBJECT

public:
  /// Called on the thread this lives in, unless the work was ended.
  using Deliver = std::function<void()>;

  /// What work has of whoever waits for it; for the work's thread.
  struct Line {
    Effort effort; ///< its progress has no words
    std::function<void(double fraction, const Message& doing)> report;
    std::function<void(Deliver)> tell; ///< of what there is before the end; the outcome comes after it
  };

  /// Works on a thread of its own and returns what is to be done with the outcome. What it throws is told by
  /// `failed`; Cancelled by nobody, as whoever cancelled knows.
  using Task = std::function<Deliver(const Effort& effort)>;
  using TellingTask = std::function<Deliver(const Line& line)>;

  /// When new work begins: after what it ended, as a rule, because two would share memory and processor; or
  /// at once, where the end may be long in coming because a disk does not answer.
  enum class Turn { afterTheLast, atOnce };

  explicit BackgroundWork(QObject* parent = nullptr, Turn turn = Turn::afterTheLast)
      : QObject(parent), m_turn(turn) {}
  ~BackgroundWork() override { cancel(); }

  void start(TellingTask task);
  void start(Task task) {
    start([task = std::move(task)](const Line& line) { return task(line.effort); });
  }
  void cancel();
  bool isRunning() const { return m_state != nullptr; }

signals:
  /// 0..1, and what is being done where the work says it; now and then (`betweenReports`).
  void progressed(double fraction, const QString& doing);
  /// The work ended with a sentence that says why.
  void failed(const QString& sentence);

private:
  /// What runs; shared with its thread.
  struct State {
    std::atomic<bool> isCancelled = false;
  };

  void run(const std::shared_ptr<State>& state, const TellingTask& task);
  void tell(const std::shared_ptr<State>& state, Deliver message);

  Turn m_turn;
  std::shared_ptr<State> m_state;
  std::vector<std::jthread> m_threads; ///< of the last work, which waits for those before or leaves them here
};

} // namespace limn
