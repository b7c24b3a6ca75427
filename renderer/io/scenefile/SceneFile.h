// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/KeptPart.h"
#include "scene/Scene.h"
#include "scene/presets/Preset.h"
#include "scene/view/CompareLayout.h"
#include "scene/view/Measurement.h"
#include "scene/view/NamedView.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// What a look is called whose own name a picture does not tell: it is the user's, or was modified.
inline constexpr const char* lookWithoutName = "(look)";

/// How the pictures of a scene stand in the file of a picture: one of it, two models of it, or the scene at
/// the right of another look of it.
struct ShownSides {
  CompareLayout layout = CompareLayout::single;
  ShadingModel left = ShadingModel::classic; ///< of two
  ShadingModel right = ShadingModel::enhanced;
  double wipe = 0.5;            ///< where the border lies, as a fraction of the picture's width, 0..1
  std::optional<Preset> look{}; ///< at the left, whole, with the model `left`; absent: models are compared
  bool operator==(const ShownSides&) const = default;
};

/// A scene file as read: the scene without its volume, and what the file left to the program.
struct SceneDocument {
  std::string volume;                    ///< path as written in the file, relative to its folder
  Scene scene;                           ///< `volume` is empty and `keep` keeps all
  KeptPart keep;                         ///< what `scene.keep` becomes once the volume is read
  std::vector<Measurement> measurements; ///< of its volume
  std::string orientation; ///< axis letters given by hand (Orientation.h), empty: the volume's own file tells
  std::vector<NamedView> views;     ///< cameras kept under names, beside the scene's own
  std::optional<ShownSides> sides;  ///< of a picture of one or two; absent: nothing is known of them
  bool hasCamera = false;           ///< false: place the default camera once the volume is read
  bool hasTransferFunction = false; ///< false: choose the best-fitting preset
  bool operator==(const SceneDocument&) const = default;
};

/// Reads the text of a scene file. `name` is how errors call it. Unknown keys are refused by name, numbers
/// outside their range with the range. Throws Error (input).
SceneDocument parseScene(std::string_view text, const std::string& name);

/// Reads a scene file from disk; `volume` and `keep.labels` become absolute. Throws Error (input).
SceneDocument readSceneFile(const std::filesystem::path& path);

/// A document with absolute paths, which are written relative to the folder of its `file`.
SceneDocument located(SceneDocument document, const std::filesystem::path& file);

/// What is to be written of a scene; `volume` is stored as given, and so is the source of labels.
SceneDocument documentOf(const Scene& scene, const std::string& volume);

/// What random paths tell of their picture, 255 levels.
struct AccuracyOfPaths {
  int count = 0; ///< of each pixel
  std::optional<double> rmsLevels;
  // What filtering the noise changed; absent where it was not.
  std::optional<double> filterRms, filterLargest;
  bool operator==(const AccuracyOfPaths&) const = default;
};

/// How far a saved picture of a scene lies from the exact one. Says nothing of the scene: who reads it as one
/// passes it over.
struct PictureAccuracy {
  std::optional<double> levels;           ///< of 255, within which the pixels lie, where that is known
  std::string sentence;                   ///< how many of them, and how sure that is
  std::optional<AccuracyOfPaths> paths{}; ///< of a picture of physical light
  bool operator==(const PictureAccuracy&) const = default;
};

/// What the text of a scene says of the accuracy of its picture; nothing where it says none. `name` is how
/// errors call it. Throws Error (input).
std::optional<PictureAccuracy> accuracyIn(std::string_view text, const std::string& name);

/// A scene as JSON with every key written out; `volume` is stored as given, and so is the source of labels.
std::string sceneToJson(const Scene& scene, const std::string& volume,
                        const std::optional<PictureAccuracy>& accuracy = {});

/// The same of a document, with its measurements, named views and sides.
std::string sceneToJson(const SceneDocument& document, const std::optional<PictureAccuracy>& accuracy = {});

/// Reads the text of a preset file. Throws Error (input).
Preset parsePreset(std::string_view text, const std::string& name);

/// A preset as JSON; keys that it leaves open are absent.
std::string presetToJson(const Preset& preset);

/// Whether a text is the JSON of a scene. Never throws.
bool looksLikeScene(std::string_view text);

/// The whole of a file as text. Throws Error (input) where it is missing, unreadable or over `limit` bytes.
std::string readTextFile(const std::filesystem::path& path, std::size_t limit = 16u << 20);

} // namespace limn
