// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace limn {

/// Does one piece of work at a time beside the event loop: new work ends what runs. Of ended work nothing
/// more is told. Signals come on the thread it lives in.
class BackgroundWork : public QObject {
  Q_OBJECT

public:
  /// Called on the thread this lives in once work is done, unless it was ended.
  using Deliver = std::function<void()>;
  /// Works on a thread of its own, tells and asks its effort, and returns what is to be done with the
  /// outcome.
  using Task = std::function<Deliver(const Effort& effort)>;

  explicit BackgroundWork(QObject* parent = nullptr) : QObject(parent) {}
  ~BackgroundWork() override { cancel(); }

  void start(Task task);
  void cancel();
  bool isRunning() const { return m_state != nullptr; }

signals:
  void progressed(double fraction);
  /// The work ended with a sentence that says why.
  void failed(const QString& sentence);

private:
  /// What runs; shared with its thread.
  struct State {
    std::atomic<bool> isCancelled = false;
  };

  void run(const std::shared_ptr<State>& state, const Task& task);
  void tell(const std::shared_ptr<State>& state, std::function<void()> message);

  std::shared_ptr<State> m_state;
  std::jthread m_thread; ///< of the last work; it waits for the one before
};

} // namespace limn
