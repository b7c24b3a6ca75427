// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/naming/DatedPaths.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <random>

namespace limn {

std::string entryKey(const std::string& prefix, const std::string& name, const std::string& suffix) {
  return prefix + name + suffix;
}

std::string nameOf(const SettingsDocument& values, const std::string& prefix, const std::string& path) {
  for (const auto& [key, value] : values)
    if (value == path && key.starts_with(prefix) && key.ends_with(pathSuffix))
      return key.substr(prefix.size(), key.size() - prefix.size() - pathSuffix.size());
  return {};
}

std::string newName() {
  std::random_device system;
  std::array<char, 16> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::uint64_t{system()} << 32 | system(), 36);
  return {text.data(), end.ptr};
}

// ISO dates sort like texts.
std::vector<DatedEntry> datedEntries(const SettingsDocument& values, const std::string& prefix) {
  std::vector<DatedEntry> entries;
  for (const auto& [key, value] : values)
    if (key.starts_with(prefix) && key.ends_with(openedSuffix))
      entries.push_back({key.substr(prefix.size(), key.size() - prefix.size() - openedSuffix.size()), value});
  std::ranges::sort(entries, [](const DatedEntry& a, const DatedEntry& b) { return a.opened > b.opened; });
  return entries;
}

// This moment, or where the clock shows the same millisecond still, or an earlier one, the next behind them
// all.
static std::string laterThanAll(const std::vector<DatedEntry>& latestFirst) {
  using namespace std::chrono;
  auto now = time_point_cast<milliseconds>(system_clock::now());
  int y = 0, mo = 0, d = 0, h = 0, mi = 0, s = 0, ms = 0;
  if (!latestFirst.empty() && std::sscanf(latestFirst.front().opened.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d.%3dZ",
                                          &y, &mo, &d, &h, &mi, &s, &ms) == 7) {
    const year_month_day day = year(y) / mo / d;
    if (const auto last = sys_days(day) + hours(h) + minutes(mi) + seconds(s) + milliseconds(ms);
        day.ok() && last >= now)
      now = last + milliseconds(1);
  }
  const auto midnight = floor<days>(now);
  const year_month_day day(midnight);
  const hh_mm_ss time(now - midnight);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", int(day.year()),
                unsigned(day.month()), unsigned(day.day()), int(time.hours().count()),
                int(time.minutes().count()), int(time.seconds().count()), int(time.subseconds().count()));
  return text.data();
}

void forget(SettingsDocument& values, const std::string& prefix, const std::string& name) {
  for (const std::string& suffix : {pathSuffix, labelSuffix, openedSuffix})
    values.erase(entryKey(prefix, name, suffix));
}

std::string putFirst(SettingsDocument& values, const std::string& prefix, const std::string& path,
                     const std::string& fresh, std::size_t most) {
  std::string name = nameOf(values, prefix, path);
  if (name.empty())
    name = fresh;
  const std::string now = laterThanAll(datedEntries(values, prefix));
  values[entryKey(prefix, name, pathSuffix)] = path;
  values[entryKey(prefix, name, openedSuffix)] = now;
  const std::vector<DatedEntry> entries = datedEntries(values, prefix);
  for (std::size_t i = most; i < entries.size(); ++i)
    forget(values, prefix, entries[i].name);
  return name;
}

} // namespace limn
