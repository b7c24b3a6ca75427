// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/DatedPaths.h"

#include <QDateTime>
#include <QRandomGenerator>

#include <algorithm>

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
  return QString::number(QRandomGenerator::system()->generate64(), 36).toStdString();
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
static QString laterThanAll(const std::vector<DatedEntry>& latestFirst) {
  QDateTime now = QDateTime::currentDateTimeUtc();
  if (!latestFirst.empty()) {
    const auto last =
        QDateTime::fromString(QString::fromStdString(latestFirst.front().opened), Qt::ISODateWithMs);
    if (last.isValid() && last >= now)
      now = last.addMSecs(1);
  }
  return now.toString(Qt::ISODateWithMs);
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
  const QString now = laterThanAll(datedEntries(values, prefix));
  values[entryKey(prefix, name, pathSuffix)] = path;
  values[entryKey(prefix, name, openedSuffix)] = now.toStdString();
  const std::vector<DatedEntry> entries = datedEntries(values, prefix);
  for (std::size_t i = most; i < entries.size(); ++i)
    forget(values, prefix, entries[i].name);
  return name;
}

} // namespace limn
