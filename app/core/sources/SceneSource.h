// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/NamedFiles.h"
#include "io/VolumeReader.h"
#include "io/dicom/DicomFolder.h"
#include "io/scenefile/FigureFile.h"
#include "io/scenefile/SessionFile.h"
#include "scene/Scene.h"
#include "scene/basics/Error.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// A folder holds several series, none was chosen, and the options ask for that to be told.
class SeveralSeries : public Error {
public:
  explicit SeveralSeries(std::shared_ptr<const DicomFolder> dicom)
      : Error(Error::Kind::input, Message::tr("The folder holds several series; choose one by its number.")),
        m_dicom(std::move(dicom)) {}

  const std::shared_ptr<const DicomFolder>& dicom() const { return m_dicom; }

private:
  std::shared_ptr<const DicomFolder> m_dicom;
};

/// What a person adds when naming a source.
struct SourceOptions {
  ReadOptions read;
  /// Replaces the volume that a scene or picture names; where its view looks past this one, what is visible
  /// is framed, and `notes` say so.
  std::optional<std::filesystem::path> volume;
  /// Where files of a scene's labels are that lie elsewhere than the scene says, by what it says; others of
  /// its labels are looked for beside them.
  std::map<std::string, std::filesystem::path> labels{};
  bool leavesLabelsOut = false; ///< of a scene, which is shown without them
  /// Where else a scene's volume may be: files and folders opened before. The one of the same name is taken;
  /// of several none, because they may be of several patients.
  std::vector<std::filesystem::path> knownVolumes;
  /// Volumes by the names that stand for them in scenes, because their own may name the patient.
  std::map<std::string, std::filesystem::path> references;
  bool hidesTable = false;       ///< of a CT volume whose body is sure, that alone is kept at first
  bool smoothsSlices = false;    ///< of a volume whose slices are thick: normals are smooth at first
  bool wantsVolumeAlone = false; ///< the scene is another's: what would be found out for it is left away
  bool bringsView = false;       ///< whoever asks says from where to look: nothing is framed
  bool asksForSeries = false;    ///< of several in the folder that is the source: throws SeveralSeries
  /// A DICOM file or folder that was opened already: its headers are not read again.
  std::shared_ptr<const DicomFolder> dicom;
  /// Volumes that were read already, by their absolute path or built-in name: they are not read again.
  std::map<std::string, std::shared_ptr<const Volume>> opened;
};

/// A scene ready to draw, and where its volume came from.
struct LoadedScene {
  Scene scene;               ///< with volume, camera and transfer function
  std::string volumePath;    ///< absolute path, or the built-in name ("phantom:1")
  bool hasOwnCamera = false; ///< the source says from where to look
  std::string preset;        ///< the preset the program chose, empty where the source says how to show it
  std::vector<Measurement> measurements; ///< of the volume
  std::vector<NamedView> views;          ///< that the source keeps beside the scene's camera
  std::vector<Message> notes;            ///< one sentence each: what else was noteworthy
  ReadOptions read;                      ///< with which the volume was read
  /// Where the volume is of DICOM and was read for this scene.
  std::shared_ptr<const DicomFolder> dicom;
  std::optional<SessionDocument> session; ///< where the source is one
  std::string sessionDigest{};            ///< then of the file as it was read (digestOf)
  bool isOfAnotherVolume = false;         ///< than the file that named one was saved with
  bool lacksLabels = false;               ///< that the file has: somebody asked for it without them
  /// A session file that holds what is not shown: saving leaves it as it is.
  bool sparesSession() const { return session && (isOfAnotherVolume || lacksLabels); }
  /// Where it is a figure, what of its other panels a window shows beside the scene: a second model, slices.
  std::optional<SessionDocument> beside;
  std::optional<ShownSides> sides; ///< where it is a picture that tells them
  /// What `notes` say of its panels where a window could show more of them than it does, and then which
  /// command does; else empty.
  std::vector<Message> morePanels;
};

/// A figure ready to draw.
struct LoadedFigure {
  struct Panel {
    std::string name;
    std::optional<PatientPlane> plane;
    PlaneSettings planes;
    LoadedScene scene;
  };
  FigureSettings settings;
  std::vector<Panel> panels;
};

/// Loads anything that names a scene: a volume (see readVolume), a scene or session file, a picture or figure
/// written by Limn (of a figure the first panel), a DICOM look (LookSource.h), `sample` (the CT head of an
/// installed example, otherwise the phantom) or `phantom[:spacing in mm]`. A volume gets its first view and
/// the best-fitting preset. Throws Error and Cancelled.
LoadedScene loadScene(const std::string& source, const SourceOptions& options, const Progress& progress);

/// Loads every panel of a figure that Limn wrote; nothing where the source is none. Panels of one volume
/// share it. Throws as loadScene does.
std::optional<LoadedFigure> loadFigure(const std::string& source, const SourceOptions& options,
                                       const Progress& progress);

/// What a picture or figure that Limn wrote says of its scenes, as it stands in the file (FigureFile.h,
/// SceneFile.h); empty of any other source. Throws Error.
std::string carriedBy(const std::string& source);

/// How a source is called from wherever: a path becomes absolute, what is built in (`sample`, `phantom:1`)
/// keeps its name.
std::string absoluteSource(const std::string& source);

} // namespace limn
