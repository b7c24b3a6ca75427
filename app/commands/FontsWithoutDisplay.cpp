// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/FontsWithoutDisplay.h"

namespace limn {
namespace {

// What Qt says of a session that there is none of is nobody's concern.
class Silence {
public:
  Silence() : m_before(qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {})) {}
  ~Silence() { qInstallMessageHandler(m_before); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  QtMessageHandler m_before;
};

} // namespace

FontsWithoutDisplay::FontsWithoutDisplay() {
  const Silence silence;
  m_application.emplace(m_count, m_words.data());
}

} // namespace limn
