// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QObject>
#include <QTimer>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

namespace limn {

/// Keeps a file at the state of a session, atomically and on a thread of its own: at most every two seconds,
/// and whenever somebody asks. Signals come on the thread it lives in.
class Autosave : public QObject {
  Q_OBJECT

public:
  /// `current` tells the session of the moment; absent: there is nothing that could be lost, and no file is
  /// kept.
  Autosave(std::filesystem::path file, std::function<std::optional<SessionDocument>()> current,
           QObject* parent = nullptr);
  ~Autosave() override;

  static constexpr int intervalMs = 2000;

  /// Says that the session may have changed.
  void noteChange();

  /// Writes the session of this moment when it is called, on the thread that calls it; for whoever begins
  /// something that may end the process. Returns whether it, or a later one, is on the disk; failures are
  /// signalled as well.
  std::function<bool()> savingOfNow();

signals:
  /// The sentence says why what changed since is not on the disk; told once until it succeeds again. It is
  /// tried again every two seconds.
  void failed(const QString& sentence);
  /// What failed does no longer.
  void recovered();

private:
  struct Shared;
  void save();
  void takeOutcome(const std::optional<QString>& problem);
  void work(const std::stop_token& stop);

  std::shared_ptr<Shared> m_shared;
  std::function<std::optional<SessionDocument>()> m_current;
  QTimer m_timer;
  bool m_isFailing = false;
  std::jthread m_thread;
};

} // namespace limn
