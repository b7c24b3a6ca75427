// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include <sys/inotify.h>
#include <unistd.h>

namespace limn::test {

/// Counts how often each file of a folder is opened, by whoever, from when this is made on. For some hundred
/// files: the system keeps 16,384 events.
class Openings {
public:
  explicit Openings(const std::filesystem::path& folder) : m_events(inotify_init1(IN_NONBLOCK)) {
    // The system keeps one of equal events that follow each other: reading parts two openings.
    if (inotify_add_watch(m_events, folder.c_str(), IN_OPEN | IN_ACCESS | IN_CLOSE) < 0)
      throw std::runtime_error("the folder cannot be watched");
  }
  ~Openings() { close(m_events); }
  Openings(const Openings&) = delete;
  Openings& operator=(const Openings&) = delete;

  /// Of each file that was opened since the last call.
  std::map<std::string, int> counted() {
    std::map<std::string, int> counts;
    alignas(inotify_event) char buffer[1 << 16];
    for (ssize_t length = 0; (length = read(m_events, buffer, sizeof buffer)) > 0;)
      for (const char* at = buffer; at < buffer + length;) {
        const auto& event = *reinterpret_cast<const inotify_event*>(at);
        if (event.mask & IN_Q_OVERFLOW)
          throw std::runtime_error("more happened than the system keeps");
        if ((event.mask & IN_OPEN) && !(event.mask & IN_ISDIR))
          ++counts[event.name];
        at += sizeof event + event.len;
      }
    return counts;
  }

private:
  int m_events;
};

} // namespace limn::test
