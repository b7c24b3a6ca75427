// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/MemoryBudget.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace limn {
namespace {

std::uint64_t allMemory() {
  return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

} // namespace

std::optional<std::uint64_t> freeMemory() {
  std::ifstream lines("/proc/meminfo");
  const std::string key = "MemAvailable:";
  for (std::string word; lines >> word;)
    if (std::uint64_t kibibytes = 0; word == key && lines >> kibibytes && kibibytes > 0)
      return kibibytes * 1024;
  return std::nullopt;
}

MemoryBudget::MemoryBudget() : m_bytes(freeMemory().value_or(allMemory()) / 2) {}

} // namespace limn
