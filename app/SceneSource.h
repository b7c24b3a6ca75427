// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/VolumeReader.h"
#include "io/scenefile/SessionFile.h"
#include "scene/Error.h"
#include "scene/Scene.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// A scene or picture was read, but its volume is not where it says.
class VolumeMissing : public Error {
public:
  /// `volume` is the name of the file or folder.
  explicit VolumeMissing(const std::string& volume)
      : Error(Error::Kind::input,
              "The scene's volume " + volume +
                  " is not where the scene expects it; say where it is (--volume PATH).") {}
};

/// What a person adds when naming a source.
struct SourceOptions {
  ReadOptions read;
  std::optional<std::filesystem::path> volume; ///< replaces the volume that a scene or picture names
  /// Where else a scene's volume may be: files and folders opened before. One of the same name is taken.
  std::vector<std::filesystem::path> knownVolumes;
  /// Volumes by the names that stand for them in scenes, because their own may name the patient.
  std::map<std::string, std::filesystem::path> references;
};

/// A scene ready to draw, and where its volume came from.
struct LoadedScene {
  Scene scene;               ///< with volume, camera and transfer function
  std::string volumePath;    ///< absolute path, or the built-in name ("phantom:1")
  bool hasOwnCamera = false; ///< the source says from where to look
  std::string preset;        ///< the preset the program chose, empty where the source says how to show it
  std::vector<std::string> notes;         ///< one sentence each: what else was noteworthy
  ReadOptions read;                       ///< with which the volume was read
  std::optional<SessionDocument> session; ///< where the source is one
};

/// Loads anything that names a scene: a volume (see readVolume), a scene or session file, a picture written
/// by Limn, `sample` (the CT head of an installed example, otherwise the phantom) or `phantom[:spacing in
/// mm]`. A volume gets the default camera and the best-fitting preset. Throws Error and Cancelled.
LoadedScene loadScene(const std::string& source, const SourceOptions& options, const Progress& progress);

/// The CT head that Debian's invesalius-examples installs, where it is installed.
std::optional<std::filesystem::path> installedSampleHead();

} // namespace limn
