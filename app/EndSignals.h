// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <array>

class QSocketNotifier;

namespace limn {

/// Tells in the event loop that the system asks the program to end (SIGTERM at logout, SIGHUP where its
/// terminal closes), so that it does so in order. A second signal of the kind ends it at once. One at a time;
/// nowhere but on Unix does it tell anything.
class EndSignals : public QObject {
  Q_OBJECT

public:
  explicit EndSignals(QObject* parent = nullptr);
  ~EndSignals() override;

signals:
  void endAsked();

private:
  void read();

  std::array<int, 2> m_ends{-1, -1}; ///< of a pipe: a handler may write, and call hardly anything else
  QSocketNotifier* m_notifier = nullptr;
};

} // namespace limn
