// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/EngineChoice.h"
#include "app/core/naming/UserFolders.h"
#include "io/scenefile/SettingsFile.h"
#include "scene/view/FigureSettings.h"
#include "scene/view/HistogramView.h"

#include <QByteArray>
#include <QDateTime>
#include <QList>
#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace limn {

/// Something opened before: where it is, and what it is without naming anybody.
struct RecentSource {
  QString path;
  QString label;
  QString opened; ///< when, ISO 8601 in UTC
  int series = 0; ///< of a folder of several the number of the one that was chosen; 0: none was
  QDateTime openedAt() const { return QDateTime::fromString(opened, Qt::ISODateWithMs); }
};

/// What the program remembers between runs: window, theme, recent files. The only thing about patients in it
/// is where their data lie. Every change is written at once: under a lock, the file is read again, one item
/// changed, and the file replaced; so that of two windows none undoes what the other changed, and whoever is
/// killed leaves the last state.
class Settings {
public:
  explicit Settings(std::filesystem::path file = UserFolders::ofThisUser().settings);

  /// Called with a sentence where a change cannot be written; it then holds for this run.
  void setOnProblem(std::function<void(const QString& sentence)> tell) { m_tell = std::move(tell); }

  QByteArray windowGeometry() const;
  QByteArray windowState() const;
  void setWindow(const QByteArray& geometry, const QByteArray& state);

  /// Most recent first, at most ten; those of other windows too.
  QList<RecentSource> recentSources();
  void addRecentSource(const QString& path, const QString& label, int series = 0);
  void removeRecentSource(const QString& path); ///< and what was dismissed of it
  /// Forgets where volumes were opened, and the folder of the dialogs, too.
  void clearRecentSources();

  /// Where volumes lie that were opened before, most recent first, at most a hundred: a scene, session or
  /// picture of one finds it there.
  std::vector<std::filesystem::path> knownVolumes();
  void addKnownVolume(const std::string& path);

  /// In which something was opened last; empty where it is none any more.
  QString dialogFolder() const;
  void setDialogFolder(const QString& folder);

  /// In which something was saved last, likewise: what is saved does not belong beside patients' files.
  QString saveFolder() const;
  void setSaveFolder(const QString& folder);

  /// In which a picture was saved last, likewise: sessions may lie beside the patient's files, pictures go
  /// out.
  QString pictureFolder() const;
  void setPictureFolder(const QString& folder);

  /// Of the kind of file that a look was exported as last, with its dot; empty at first.
  QString lookEnding() const;
  void setLookEnding(const QString& ending);

  /// A name that stands for a path which must not be written elsewhere, the same each time. A new one begins
  /// with `kind`.
  std::string referenceTo(const std::string& path, const std::string& kind);
  /// Paths by the names that stand for them.
  std::map<std::string, std::filesystem::path> references();

  /// "system", "light" or "dark".
  QString theme() const;
  void setTheme(const QString& theme);

  /// What `useLanguage` is asked for: "system" or the code of a language.
  QString language() const;
  void setLanguage(const QString& language);

  /// The drawing time of a picture aimed at while something moves, ms; 40 at first.
  double movingMs() const;
  void setMovingMs(double ms);

  /// What figures look like: those made last.
  FigureSettings figure() const;
  void setFigure(const FigureSettings& settings);

  /// Whether resting pictures go on to smaller steps; true at first.
  bool refinesAtRest() const;
  void setRefinesAtRest(bool refines);

  /// Whether a cube in the picture shows how it lies; true at first.
  bool cubeIsShown() const;
  void setCubeIsShown(bool isShown);

  /// What stands behind the curve; the logarithm of all voxels at first.
  HistogramView histogramView() const;
  void setHistogramView(const HistogramView& view);

  /// The ray caster or the CPU engine; absent at first: whichever is faster.
  std::optional<Engine> engine() const;
  void setEngine(std::optional<Engine> engine);

  /// Whether presets are shown as a gallery; false at first.
  bool presetsAreGallery() const;
  void setPresetsAreGallery(bool areGallery);

  /// Whether presets leave the light as it is; false at first.
  bool presetsKeepLight() const;
  void setPresetsKeepLight(bool keepLight);

  /// How a picture was saved last, as PictureDialog writes it; empty at first.
  QString pictureOptions() const;
  void setPictureOptions(const QString& options);

  /// Whether somebody has dismissed what is said of a volume, so that it need not be said again; of the last
  /// hundred that were.
  bool isDismissed(const std::string& volumePath, const QString& sentence);
  void setDismissed(const std::string& volumePath, const QString& sentence);

  /// Whether the tour of the window was taken or declined; false at first.
  bool tourIsKnown() const;
  void setTourIsKnown(bool isKnown);

  /// The presets, by name, that are listed first; those of other windows too.
  std::set<std::string> favourites();
  void setFavourite(const std::string& preset, bool isFavourite);

  /// The outcome of trials on this machine and others that share the file. Valid while this lives.
  EngineMemory engineMemory();

  /// Whether the title bar may name the patient; absent until somebody has chosen.
  std::optional<bool> patientIsShown() const;
  void setPatientIsShown(bool shown);

private:
  QString folderAt(const std::string& key) const;
  QString text(const std::string& key, const QString& otherwise = {}) const;
  void set(const std::string& key, const QString& value);
  void change(const std::function<void(SettingsDocument&)>& edit);
  SettingsDocument readFile() const;
  void readAgain();

  std::filesystem::path m_file;
  SettingsDocument m_values;
  std::function<void(const QString&)> m_tell;
  bool m_isWritable = true; ///< false: the last change could not be written
};

} // namespace limn
