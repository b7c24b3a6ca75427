// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Settings.h"

#include "io/scenefile/FigureFile.h"

#include "io/AtomicFile.h"
#include "io/FileLock.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "widgets/view/pictures/InteractionQuality.h"

#include <QDateTime>
#include <QFileInfo>
#include <QRandomGenerator>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

namespace fs = std::filesystem;

const std::string geometryKey = "window/geometry";
const std::string stateKey = "window/state";
const std::string themeKey = "theme";
const std::string refineKey = "refineAtRest";
const std::string patientKey = "showPatient";
const std::string movingKey = "movingMs";
const std::string engineKey = "engine";
const std::string trialPrefix = "trial/";
const std::string folderKey = "dialogFolder";
const std::string saveFolderKey = "saveFolder";
const std::string recentPrefix = "recent/";
const std::string knownPrefix = "known/";
const std::string volumePrefix = "volume/";
const std::string pathSuffix = "/path";
const std::string labelSuffix = "/label";
const std::string openedSuffix = "/opened";
constexpr std::size_t mostRecent = 10;
constexpr std::size_t mostKnown = 100;

// The name in the keys PREFIX name /path that holds this path; empty where there is none.
std::string nameOf(const SettingsDocument& values, const std::string& prefix, const std::string& path) {
  for (const auto& [key, value] : values)
    if (value == path && key.starts_with(prefix) && key.ends_with(pathSuffix))
      return key.substr(prefix.size(), key.size() - prefix.size() - pathSuffix.size());
  return {};
}

std::string newName() {
  return QString::number(QRandomGenerator::system()->generate64(), 36).toStdString();
}

struct DatedEntry {
  std::string name;
  std::string opened;
};

// Those under PREFIX name, latest first. ISO dates sort like texts.
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
QString laterThanAll(const std::vector<DatedEntry>& latestFirst) {
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
    values.erase(prefix + name + suffix);
}

// Puts a path first under PREFIX and returns its name there; beyond `most` the last ones go.
std::string putFirst(SettingsDocument& values, const std::string& prefix, const std::string& path,
                     const std::string& fresh, std::size_t most) {
  std::string name = nameOf(values, prefix, path);
  if (name.empty())
    name = fresh;
  const QString now = laterThanAll(datedEntries(values, prefix));
  values[prefix + name + pathSuffix] = path;
  values[prefix + name + openedSuffix] = now.toStdString();
  const std::vector<DatedEntry> entries = datedEntries(values, prefix);
  for (std::size_t i = most; i < entries.size(); ++i)
    forget(values, prefix, entries[i].name);
  return name;
}

constexpr std::pair<EngineSetting, const char*> engineWords[] = {
    {EngineSetting::automatic, "auto"}, {EngineSetting::openGl, "gl"}, {EngineSetting::processor, "cpu"}};

// "41.20 12.70": with OpenGL and with the processor, ms.
std::optional<EngineTimes> readTimes(const QString& text) {
  const QStringList parts = text.split(QLatin1Char(' '));
  if (parts.size() != 2)
    return std::nullopt;
  const EngineTimes times{parts[0].toDouble(), parts[1].toDouble()};
  return times.openGlMs > 0.0 && times.processorMs > 0.0 ? std::optional(times) : std::nullopt;
}

QString written(bool flag) {
  return flag ? QStringLiteral("true") : QStringLiteral("false");
}

} // namespace

Settings::Settings(fs::path file) : m_file(std::move(file)) {
  readAgain();
}

SettingsDocument Settings::readFile() const {
  std::error_code unknown;
  if (!fs::exists(m_file, unknown))
    return {};
  return parseSettings(readTextFile(m_file), m_file.filename().string());
}

void Settings::readAgain() {
  try {
    if (m_isWritable)
      m_values = readFile();
  } catch (const Error&) {
    // Whoever repairs the file by hand finds it untouched until something is set.
  }
}

// A file that somebody else damaged is put aside, not lost.
void Settings::change(const std::function<void(SettingsDocument&)>& edit) {
  edit(m_values);
  try {
    makePrivateFolder(m_file.parent_path());
    const FileLock lock = FileLock::waitFor(m_file.parent_path() / ".settings.lock");
    SettingsDocument values;
    try {
      values = readFile();
    } catch (const Error&) {
      fs::path aside = m_file;
      std::error_code failed;
      fs::rename(m_file, aside += ".damaged", failed);
    }
    edit(values);
    writeFileAtomically(m_file, settingsToJson(values), FilePlace::fixedPrivate);
    m_values = std::move(values);
    m_isWritable = true;
  } catch (const Error& error) {
    if (m_isWritable && m_tell)
      m_tell(QString::fromStdString(error.what()));
    m_isWritable = false;
  }
}

QString Settings::text(const std::string& key, const QString& otherwise) const {
  const auto found = m_values.find(key);
  return found == m_values.end() ? otherwise : QString::fromStdString(found->second);
}

void Settings::set(const std::string& key, const QString& value) {
  change([&](SettingsDocument& values) { values[key] = value.toStdString(); });
}

QByteArray Settings::windowGeometry() const {
  return QByteArray::fromBase64(text(geometryKey).toLatin1());
}

QByteArray Settings::windowState() const {
  return QByteArray::fromBase64(text(stateKey).toLatin1());
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state) {
  change([&](SettingsDocument& values) {
    values[geometryKey] = geometry.toBase64().toStdString();
    values[stateKey] = state.toBase64().toStdString();
  });
}

QList<RecentSource> Settings::recentSources() {
  readAgain();
  QList<RecentSource> sources;
  for (const DatedEntry& entry : datedEntries(m_values, recentPrefix))
    sources << RecentSource{text(recentPrefix + entry.name + pathSuffix),
                            text(recentPrefix + entry.name + labelSuffix),
                            QString::fromStdString(entry.opened)};
  return sources.mid(0, mostRecent);
}

void Settings::addRecentSource(const QString& source, const QString& label) {
  const std::string path = source.toStdString();
  const std::string fresh = newName();
  change([&](SettingsDocument& values) {
    const std::string name = putFirst(values, recentPrefix, path, fresh, mostRecent);
    values[recentPrefix + name + labelSuffix] = label.toStdString();
  });
}

void Settings::removeRecentSource(const QString& path) {
  if (!nameOf(m_values, recentPrefix, path.toStdString()).empty())
    change([&](SettingsDocument& values) {
      forget(values, recentPrefix, nameOf(values, recentPrefix, path.toStdString()));
    });
}

void Settings::clearRecentSources() {
  change([](SettingsDocument& values) {
    for (const std::string& prefix : {recentPrefix, knownPrefix})
      for (const DatedEntry& entry : datedEntries(values, prefix))
        forget(values, prefix, entry.name);
    values.erase(folderKey);
    values.erase(saveFolderKey);
  });
}

std::vector<fs::path> Settings::knownVolumes() {
  readAgain();
  std::vector<fs::path> known;
  for (const DatedEntry& entry : datedEntries(m_values, knownPrefix))
    known.emplace_back(text(knownPrefix + entry.name + pathSuffix).toStdString());
  return known;
}

void Settings::addKnownVolume(const std::string& path) {
  const std::string fresh = newName();
  change([&](SettingsDocument& values) { putFirst(values, knownPrefix, path, fresh, mostKnown); });
}

QString Settings::folderAt(const std::string& key) const {
  const QString folder = text(key);
  return QFileInfo(folder).isDir() ? folder : QString();
}

QString Settings::dialogFolder() const {
  return folderAt(folderKey);
}

QString Settings::saveFolder() const {
  return folderAt(saveFolderKey);
}

void Settings::setSaveFolder(const QString& folder) {
  set(saveFolderKey, folder);
}

void Settings::setDialogFolder(const QString& folder) {
  set(folderKey, folder);
}

std::string Settings::referenceTo(const std::string& path, const std::string& kind) {
  readAgain();
  if (const std::string known = nameOf(m_values, volumePrefix, path); !known.empty())
    return known;
  const std::string fresh = kind + "-" + newName();
  change([&](SettingsDocument& values) {
    if (nameOf(values, volumePrefix, path).empty())
      values[volumePrefix + fresh + pathSuffix] = path;
  });
  return nameOf(m_values, volumePrefix, path);
}

std::map<std::string, fs::path> Settings::references() {
  readAgain();
  std::map<std::string, fs::path> found;
  for (const auto& [key, value] : m_values)
    if (key.starts_with(volumePrefix) && key.ends_with(pathSuffix))
      found[key.substr(volumePrefix.size(), key.size() - volumePrefix.size() - pathSuffix.size())] = value;
  return found;
}

QString Settings::theme() const {
  return text(themeKey, QStringLiteral("system"));
}

void Settings::setTheme(const QString& theme) {
  set(themeKey, theme);
}

double Settings::movingMs() const {
  const double ms = text(movingKey).toDouble();
  return ms > 0.0 ? ms : InteractionQuality::usualTargetMs;
}

void Settings::setMovingMs(double ms) {
  set(movingKey, QString::number(ms, 'g', 17));
}

FigureSettings Settings::figure() const {
  try {
    const QString written = text("figure");
    return written.isEmpty() ? FigureSettings{} : parseFigureSettings(written.toStdString(), "figure");
  } catch (const Error&) {
    return {}; // of another version
  }
}

void Settings::setFigure(const FigureSettings& settings) {
  set("figure", QString::fromStdString(figureSettingsToJson(settings)));
}

bool Settings::refinesAtRest() const {
  return text(refineKey) != written(false);
}

void Settings::setRefinesAtRest(bool refines) {
  set(refineKey, written(refines));
}

EngineSetting Settings::engine() const {
  const QString word = text(engineKey);
  for (const auto& [setting, name] : engineWords)
    if (word == QLatin1String(name))
      return setting;
  return EngineSetting::automatic;
}

void Settings::setEngine(EngineSetting engine) {
  for (const auto& [setting, name] : engineWords)
    if (setting == engine)
      set(engineKey, QLatin1String(name));
}

EngineMemory Settings::engineMemory() {
  return {[this](const std::string& machine) { return readTimes(text(trialPrefix + machine)); },
          [this](const std::string& machine, const EngineTimes& times) {
            set(trialPrefix + machine,
                QStringLiteral("%1 %2").arg(times.openGlMs, 0, 'f', 2).arg(times.processorMs, 0, 'f', 2));
          }};
}

std::optional<bool> Settings::patientIsShown() const {
  const QString chosen = text(patientKey);
  return chosen.isEmpty() ? std::nullopt : std::optional(chosen == written(true));
}

void Settings::setPatientIsShown(bool shown) {
  set(patientKey, written(shown));
}

} // namespace limn
