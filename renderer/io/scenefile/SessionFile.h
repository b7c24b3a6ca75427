// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SceneFile.h"
#include "scene/view/CompareLayout.h"
#include "scene/view/PlaneSettings.h"

#include <array>
#include <optional>

namespace limn {

/// How the volume is cut open to the crosshair of the slices: by a face of its crop, or at a corner, which is
/// the last of its cuts.
struct CutOpening {
  int axis = 0; ///< of the grid; with `isUpper` the face
  bool isUpper = false;
  CropBox before;                            ///< what the crop was
  std::optional<std::array<bool, 3>> corner; ///< of each axis whether it is its upper end; then no face is
  bool operator==(const CutOpening&) const = default;
};

/// By what a volume is told from another one without naming anybody.
struct VolumeTraits {
  glm::ivec3 voxels{0};
  bool isHounsfield = false; ///< its values are Hounsfield units
  bool operator==(const VolumeTraits&) const = default;
};

/// A session file as read: the scene, how its volume is read, and what the window showed beside it.
struct SessionDocument {
  enum class Panel { none, properties, effects, accuracy };

  SceneDocument scene;                  ///< `scene.scene.volume` is empty
  std::optional<int> series;            ///< of the volume's folder, as DicomFolder numbers them
  std::optional<glm::dvec3> spacingMm;  ///< given by the user, > 0
  std::optional<VolumeTraits> traits{}; ///< of the volume; absent in a file that does not tell them

  CompareLayout layout = CompareLayout::sideBySide;
  bool layoutIsAsked = true; ///< for by somebody: two pictures stay two where they have little room
  ShadingModel leftModel = ShadingModel::classic;
  ShadingModel rightModel = ShadingModel::enhanced;
  std::optional<ShadingModel>
      ownModel{};                 ///< of the scene's own look beside a compared one; absent: the scene's
  std::optional<Preset> snapshot; ///< a look that was put by, to compare with
  std::optional<Preset>
      comparedLook; ///< at the left, compared with the scene's own; absent: models are compared
  std::optional<Preset> comparedFrom{}; ///< the preset that it was made from, where it was changed since
  double wipe = 0.5;                    ///< where the border lies, as a fraction of the picture's width, 0..1

  PlaneSettings planes; ///< the slices beside the picture

  Panel panel = Panel::properties;       ///< on top of those at the right
  std::string preset;                    ///< the one whose curves are shown, empty where there is none
  std::optional<Preset> changedPreset{}; ///< the one that the scene was made from, where it was changed since
  bool cropBoxIsShown = false;
  std::optional<CutOpening> opening;
  bool gradientCurveIsShown = false; ///< instead of the curve over the value
  std::optional<int> labelInHand{}; ///< whose curve is shown, by its place in the list; absent: of all tissue

  std::string label;   ///< what it shows, for a list of sessions that nobody saved; names nobody
  std::string savedAs; ///< absolute path of the file it was saved to, empty where there is none
  /// Of that file as it was read or written last (digestOf); empty where that is not known.
  std::string savedDigest{};
  bool isUnsaved = false; ///< the scene was edited since it was opened or saved

  bool operator==(const SessionDocument&) const = default;
};

/// Whether the text of a JSON file is that of a session (rather than of a scene). Never throws.
bool looksLikeSession(std::string_view text);

/// Reads the text of a session file, as strictly as parseScene. `name` is how errors call it. Throws Error
/// (input).
SessionDocument parseSession(std::string_view text, const std::string& name);

/// The same of the text of the file at `path`; the volume's path becomes absolute.
SessionDocument sessionIn(std::string_view text, const std::filesystem::path& path);

/// Reads a session file from disk; the volume's path becomes absolute. Throws Error (input).
SessionDocument readSessionFile(const std::filesystem::path& path);

/// Tells texts of session files apart: two that differ have two digests, but for one case in 2⁶⁴.
std::string digestOf(std::string_view text);

/// A session as JSON: the scene under the scene file's own keys, the rest beside it; paths are stored as
/// given.
std::string sessionToJson(const SessionDocument& session);

} // namespace limn
