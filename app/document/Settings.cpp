// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Settings.h"

#include "app/core/naming/DatedPaths.h"
#include "io/AtomicFile.h"
#include "io/FileLock.h"
#include "io/scenefile/FigureFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/view/pictures/InteractionQuality.h"

#include <QFileInfo>

#include <utility>

namespace limn {
namespace {

namespace fs = std::filesystem;

const std::string geometryKey = "window/geometry";
const std::string stateKey = "window/state";
const std::string themeKey = "theme";
const std::string languageKey = "language";
const std::string refineKey = "refineAtRest";
const std::string cubeKey = "orientationCube";
const std::string histogramScaleKey = "histogramScale";
const std::string histogramPartKey = "histogramPart";
const std::string patientKey = "showPatient";
const std::string movingKey = "movingMs";
const std::string engineKey = "engine";
const std::string galleryKey = "presetGallery";
const std::string keepLightKey = "presetsKeepLight";
const std::string tourKey = "tourIsKnown";
const std::string pictureKey = "pictureOptions";
const std::string favouritePrefix = "favourite/";
const std::string trialPrefix = "trial/";
const std::string folderKey = "dialogFolder";
const std::string saveFolderKey = "saveFolder";
const std::string pictureFolderKey = "pictureFolder";
const std::string lookEndingKey = "lookEnding";
const std::string recentPrefix = "recent/";
const std::string seriesSuffix = "/series";
const std::string knownPrefix = "known/";
const std::string volumePrefix = "volume/";
const std::string dismissedPrefix = "dismissed/";
constexpr std::size_t mostRecent = 10;
constexpr std::size_t mostKnown = 100;
constexpr std::size_t mostDismissed = 100;

// "41.20 12.70": with OpenGL and with the processor, ms.
std::optional<EngineTimes> readTimes(const QString& text) {
  const QStringList parts = text.split(QLatin1Char(' '));
  if (parts.size() != 2)
    return std::nullopt;
  const EngineTimes times{parts[0].toDouble(), parts[1].toDouble()};
  return times.openGlMs > 0.0 && times.processorMs > 0.0 ? std::optional(times) : std::nullopt;
}

std::string dismissedOf(const std::string& volumePath) {
  return volumePath + ": ";
}

std::string dismissedText(const std::string& volumePath, const QString& sentence) {
  return dismissedOf(volumePath) + sentence.toStdString();
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
      m_tell(translated(error.sentence()));
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
    sources << RecentSource{text(entryKey(recentPrefix, entry.name, pathSuffix)),
                            text(entryKey(recentPrefix, entry.name, labelSuffix)),
                            QString::fromStdString(entry.opened),
                            text(entryKey(recentPrefix, entry.name, seriesSuffix)).toInt()};
  return sources.mid(0, mostRecent);
}

void Settings::addRecentSource(const QString& source, const QString& label, int series) {
  const std::string path = source.toStdString();
  const std::string fresh = newName();
  change([&](SettingsDocument& values) {
    const std::string name = putFirst(values, recentPrefix, path, fresh, mostRecent);
    values[recentPrefix + name + labelSuffix] = label.toStdString();
    if (series > 0)
      values[recentPrefix + name + seriesSuffix] = std::to_string(series);
    else
      values.erase(recentPrefix + name + seriesSuffix);
  });
}

void Settings::removeRecentSource(const QString& path) {
  if (!nameOf(m_values, recentPrefix, path.toStdString()).empty())
    change([&](SettingsDocument& values) {
      forget(values, recentPrefix, nameOf(values, recentPrefix, path.toStdString()));
      for (const DatedEntry& entry : datedEntries(values, dismissedPrefix))
        if (const auto said = values.find(entryKey(dismissedPrefix, entry.name, pathSuffix));
            said != values.end() && said->second.starts_with(dismissedOf(path.toStdString())))
          forget(values, dismissedPrefix, entry.name);
    });
}

void Settings::clearRecentSources() {
  change([](SettingsDocument& values) {
    for (const std::string& prefix : {recentPrefix, knownPrefix, dismissedPrefix})
      for (const DatedEntry& entry : datedEntries(values, prefix))
        forget(values, prefix, entry.name);
    values.erase(folderKey);
    values.erase(saveFolderKey);
    values.erase(pictureFolderKey);
  });
}

std::vector<fs::path> Settings::knownVolumes() {
  readAgain();
  std::vector<fs::path> known;
  for (const DatedEntry& entry : datedEntries(m_values, knownPrefix))
    known.emplace_back(text(entryKey(knownPrefix, entry.name, pathSuffix)).toStdString());
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

QString Settings::pictureFolder() const {
  return folderAt(pictureFolderKey);
}

void Settings::setPictureFolder(const QString& folder) {
  set(pictureFolderKey, folder);
}

void Settings::setDialogFolder(const QString& folder) {
  set(folderKey, folder);
}

QString Settings::lookEnding() const {
  return text(lookEndingKey);
}

void Settings::setLookEnding(const QString& ending) {
  set(lookEndingKey, ending);
}

std::string Settings::referenceTo(const std::string& path, const std::string& kind) {
  readAgain();
  if (std::string known = nameOf(m_values, volumePrefix, path); !known.empty())
    return known;
  const std::string fresh = kind + "-" + newName();
  change([&](SettingsDocument& values) {
    if (nameOf(values, volumePrefix, path).empty())
      values[entryKey(volumePrefix, fresh, pathSuffix)] = path;
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

QString Settings::language() const {
  return text(languageKey, QStringLiteral("system"));
}

void Settings::setLanguage(const QString& language) {
  set(languageKey, language);
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

bool Settings::cubeIsShown() const {
  return text(cubeKey) != written(false);
}

void Settings::setCubeIsShown(bool isShown) {
  set(cubeKey, written(isShown));
}

HistogramView Settings::histogramView() const {
  HistogramView view;
  const QString scaleWord = text(histogramScaleKey);
  for (const HistogramScale scale :
       {HistogramScale::linear, HistogramScale::logarithmic, HistogramScale::percentile})
    if (scaleWord == QLatin1String(nameOf(scale)))
      view.scale = scale;
  const QString partWord = text(histogramPartKey);
  for (const HistogramPart part : {HistogramPart::whole, HistogramPart::kept, HistogramPart::visible})
    if (partWord == QLatin1String(nameOf(part)))
      view.part = part;
  return view;
}

void Settings::setHistogramView(const HistogramView& view) {
  set(histogramScaleKey, QLatin1String(nameOf(view.scale)));
  set(histogramPartKey, QLatin1String(nameOf(view.part)));
}

std::optional<Engine> Settings::engine() const {
  const std::optional<Engine> engine = engineNamed(text(engineKey).toStdString());
  return engine == Engine::rayCaster || engine == Engine::cpu ? engine : std::nullopt;
}

void Settings::setEngine(std::optional<Engine> engine) {
  set(engineKey, QLatin1String(nameOf(engine)));
}

bool Settings::isDismissed(const std::string& volumePath, const QString& sentence) {
  readAgain();
  return !nameOf(m_values, dismissedPrefix, dismissedText(volumePath, sentence)).empty();
}

void Settings::setDismissed(const std::string& volumePath, const QString& sentence) {
  const std::string fresh = newName();
  change([&](SettingsDocument& values) {
    putFirst(values, dismissedPrefix, dismissedText(volumePath, sentence), fresh, mostDismissed);
  });
}

bool Settings::tourIsKnown() const {
  return text(tourKey) == written(true);
}

void Settings::setTourIsKnown(bool isKnown) {
  set(tourKey, written(isKnown));
}

bool Settings::presetsAreGallery() const {
  return text(galleryKey) == written(true);
}

void Settings::setPresetsAreGallery(bool areGallery) {
  set(galleryKey, written(areGallery));
}

bool Settings::presetsKeepLight() const {
  return text(keepLightKey) == written(true);
}

void Settings::setPresetsKeepLight(bool keepLight) {
  set(keepLightKey, written(keepLight));
}

QString Settings::pictureOptions() const {
  return text(pictureKey);
}

void Settings::setPictureOptions(const QString& options) {
  set(pictureKey, options);
}

std::set<std::string> Settings::favourites() {
  readAgain();
  std::set<std::string> names;
  for (const auto& [key, value] : m_values)
    if (key.starts_with(favouritePrefix))
      names.insert(key.substr(favouritePrefix.size()));
  return names;
}

void Settings::setFavourite(const std::string& preset, bool isFavourite) {
  change([&](SettingsDocument& values) {
    if (isFavourite)
      values[favouritePrefix + preset] = written(true).toStdString();
    else
      values.erase(favouritePrefix + preset);
  });
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
