// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/EndSignals.h"

#include <QSocketNotifier>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>
#endif

namespace limn {

#ifdef Q_OS_UNIX
namespace {

constexpr std::array endSignals{SIGTERM, SIGHUP};

volatile std::sig_atomic_t writingEnd = -1;

void onSignal(int) {
  const int before = errno;
  const char byte = 0;
  [[maybe_unused]] const auto written = ::write(writingEnd, &byte, 1);
  errno = before;
}

} // namespace

EndSignals::EndSignals(QObject* parent) : QObject(parent) {
  if (::pipe(m_ends.data()) != 0)
    return; // then a signal ends the program, and what is unsaved is offered as after a crash
  for (const int end : m_ends) {
    ::fcntl(end, F_SETFD, FD_CLOEXEC);
    ::fcntl(end, F_SETFL, O_NONBLOCK);
  }
  writingEnd = m_ends[1];
  m_notifier = new QSocketNotifier(m_ends[0], QSocketNotifier::Read, this);
  connect(m_notifier, &QSocketNotifier::activated, this, &EndSignals::read);
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  for (const int signal : endSignals) {
    struct sigaction present {};
    // Who is started with nohup outlives its terminal.
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler != SIG_IGN)
      ::sigaction(signal, &action, nullptr);
  }
}

EndSignals::~EndSignals() {
  if (!m_notifier)
    return;
  for (const int signal : endSignals) {
    struct sigaction present {};
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == onSignal)
      std::signal(signal, SIG_DFL);
  }
  writingEnd = -1;
  delete m_notifier; // before what it looks at
  for (const int end : m_ends)
    ::close(end);
}

void EndSignals::read() {
  std::array<char, 16> bytes{};
  while (::read(m_ends[0], bytes.data(), bytes.size()) > 0) {
  }
  emit endAsked();
}

#else

EndSignals::EndSignals(QObject* parent) : QObject(parent) {}
EndSignals::~EndSignals() = default;
void EndSignals::read() {}

#endif

} // namespace limn
