// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/Arguments.h"
#include "app/commands/describe/Slips.h"
#include "engine/Engine.h"
#include "scene/basics/Error.h"

#include <map>

namespace limn {

/// The options that commands share which draw one scene.
struct SceneArguments {
  SourceArguments source;
  std::string size;
  std::string model;
  std::string preset;
  std::string light;
  std::string view;
  std::string turn; ///< "I/N": after I of N parts of a turn about the patient
  std::string keep;
  double stepVoxels = 0.0;      ///< 0: not given
  double toleranceLevels = 0.0; ///< 0: not given
};

/// Adds SOURCE and the options; `models` says which models `--model` takes.
void addSceneArguments(CommandSyntax& command, SceneArguments& arguments, const std::string& models);

/// Adds those of the options that change how a scene looks, but for its model.
void addLookOptions(CommandSyntax& command, SceneArguments& arguments);

// What completions offer: names of shading models, lights, standard views, what is kept of a volume, built-in
// presets, and endings of files with looks.
std::vector<std::string> modelWords();
std::vector<std::string> modelWordsAndCompare();
std::vector<std::string> lightWords();
std::vector<std::string> viewWords();
std::vector<std::string> keepWords();
std::vector<std::string> presetWords();
std::vector<std::string> lookEndings();

/// Loads the source, whose view matters only where none is given.
LoadedScene loadScene(const SceneArguments& arguments, const Progress& progress);

/// The scene with everything that was given but the model; framed anew where it has no camera of its own, on
/// half the picture where two models are compared. Throws Error (usage).
Scene adjusted(const LoadedScene& loaded, const SceneArguments& arguments);

/// The standard view of that name. Throws Error (usage).
StandardView viewNamed(const std::string& word);

/// The camera of a standard view, named by --view, framed for a picture of this width over height. Throws
/// Error (usage).
Camera viewOf(const Scene& scene, const std::string& view, double aspect);

/// The shading model of that name; `option` is named where there is none. Throws Error (usage).
ShadingModel modelNamed(const std::string& word, const std::string& option);

/// The words of a choice.
template <class Value>
std::vector<std::string> wordsOf(const std::map<std::string, Value>& choices) {
  std::vector<std::string> words;
  words.reserve(choices.size());
  for (const auto& [name, value] : choices)
    words.push_back(name);
  return words;
}

/// The value chosen by a word. Throws Error (usage) with the words that there are.
template <class Value>
Value chosen(const std::map<std::string, Value>& choices, const std::string& word,
             const std::string& option) {
  if (const auto found = choices.find(word); found != choices.end())
    return found->second;
  throw Error(Error::Kind::usage,
              option + " cannot be \"" + word + "\"; " + choiceAmong(wordsOf(choices), word) + ".");
}

/// Engines by the words of --engine; an absent one by "auto".
using EngineWords = std::map<std::string, std::optional<Engine>>;

inline EngineWords engineWords(const std::vector<Engine>& engines) {
  EngineWords words{{nameOf(std::optional<Engine>()), std::nullopt}};
  for (const Engine engine : engines)
    words.emplace(nameOf(engine), engine);
  return words;
}

} // namespace limn
