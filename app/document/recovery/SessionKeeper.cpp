// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recovery/SessionKeeper.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <iterator>

namespace limn {
namespace {

constexpr int againMs = 5000;
constexpr int mostLooks = 12;

} // namespace

SessionKeeper::SessionKeeper(const std::filesystem::path& folder,
                             std::function<std::optional<SessionDocument>()> current, QObject* parent)
    : QObject(parent), m_sessions(folder), m_abandoned(m_sessions.takeAbandoned()),
      m_place(m_sessions.place()),
      m_autosave(std::make_unique<Autosave>(m_place.file(), std::move(current))) {
  connect(&m_again, &QTimer::timeout, this, &SessionKeeper::lookAgain);
  m_again.start(againMs);
}

SessionKeeper::~SessionKeeper() = default;

void SessionKeeper::lookAgain() {
  if (++m_looks >= mostLooks)
    m_again.stop();
  std::vector<AutosavePlace> more;
  try {
    more = m_sessions.takeAbandoned();
  } catch (const Error&) {
    m_again.stop(); // where the folder cannot be written, saving says so
  }
  if (more.empty())
    return;
  std::move(more.begin(), more.end(), std::back_inserter(m_abandoned));
  emit abandonedFound();
}

void SessionKeeper::close() {
  m_again.stop();
  m_autosave.reset();
  m_place.remove();
}

void SessionKeeper::keep(const SessionDocument& session) const {
  m_sessions.keep(sessionToJson(session));
}

std::optional<std::filesystem::path> SessionKeeper::abandoned() const {
  return m_abandoned.empty() ? std::nullopt : std::optional(m_abandoned.front().file());
}

void SessionKeeper::forget(const std::filesystem::path& file) {
  const auto found = std::find_if(m_abandoned.begin(), m_abandoned.end(),
                                  [&](const AutosavePlace& place) { return place.file() == file; });
  if (found == m_abandoned.end()) {
    std::error_code failed;
    std::filesystem::remove(file, failed);
    return;
  }
  found->remove();
  m_abandoned.erase(found);
}

} // namespace limn
