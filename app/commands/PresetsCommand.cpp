// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/Arguments.h"
#include "app/commands/NamedLook.h"
#include "app/commands/SceneArguments.h"
#include "app/core/sources/SceneSource.h"
#include "app/presets/PresetStore.h"
#include "io/AtomicFile.h"
#include "io/looks/text/LookText.h"
#include "io/scenefile/SceneFile.h"
#include "scene/presets/PresetFit.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

namespace limn {
namespace {

constexpr std::size_t mostOfColumn = 32; // longer names have a line of their own before the rest

void listPresets() {
  const PresetStore::Contents own = PresetStore::ofThisUser().read();
  std::size_t width = 0;
  for (const std::vector<Preset>& presets : {builtInPresets(), own.presets})
    for (const Preset& preset : presets)
      if (preset.name.size() <= mostOfColumn)
        width = std::max(width, preset.name.size());
  const auto list = [width](const std::vector<Preset>& presets, const char* whose) {
    for (const Preset& preset : presets) {
      const bool isLong = preset.name.size() > width;
      if (isLong)
        std::printf("%s\n", preset.name.c_str());
      std::printf("%-*s %-4s %-8s  %s\n", static_cast<int>(width), isLong ? "" : preset.name.c_str(),
                  preset.modality.c_str(), whose, preset.note.c_str());
    }
  };
  list(builtInPresets(), "built-in");
  list(own.presets, "own");
  for (const Message& problem : own.problems)
    note(problem.english());
}

void showPreset(const std::string& name) {
  if (!namesLookFile(name)) {
    std::cout << presetToJson(presetNamed(allPresets(PresetStore::ofThisUser()), name));
    return;
  }
  const ReadLook look = lookIn(name, {});
  for (const Message& change : look.changes)
    note(change.english());
  std::cout << presetToJson(look.preset);
}

struct ConvertArguments {
  std::string in;
  std::string out;
  std::string volume; ///< for which the look is meant; empty: none
  std::string look;   ///< of several in a file; empty: the first
  bool json = false;
};

/// The volume that a look is for, and what that gives formats.
struct Meant {
  std::shared_ptr<const Volume> volume; ///< null: none was named
  std::optional<LookTarget> target;
};

Meant meantFor(const std::string& named) {
  if (named.empty())
    return {};
  const LoadedScene loaded = loadScene(named, {}, terminalProgress(false));
  Meant meant{loaded.scene.volume, lookTargetOf(*loaded.scene.volume)};
  if (loaded.scene.volume->info().format == "DICOM")
    meant.target->series = {loaded.scene.volume, loaded.volumePath, loaded.read.series.value_or(1)};
  return meant;
}

// A look that knows the data it was shaped on is fitted to the volume: other programs' files cannot move.
void fitTo(const Volume& volume, ReadLook& read) {
  if (!read.preset.landmarks)
    return;
  read.preset = fittedTo(read.preset, histogramOf(volume), volume.grid());
  tell(read.changes, Message::tr("The look was fitted to the volume's values."));
}

ReadLook lookToConvert(const ConvertArguments& arguments, const std::optional<LookTarget>& target) {
  if (std::filesystem::exists(arguments.in) || namesLookFile(arguments.in))
    return lookIn(arguments.in, target, arguments.look);
  return {presetNamed(allPresets(PresetStore::ofThisUser()), arguments.in), {}};
}

// Nothing is written before everything is known to be right.
void convertLook(const ConvertArguments& arguments) {
  requireLookEnding(arguments.out);
  requireWritable(arguments.out);
  const auto [volume, target] = meantFor(arguments.volume);
  ReadLook read = lookToConvert(arguments, target);
  if (volume)
    fitTo(*volume, read);
  const WrittenLook written = lookAs(arguments.out, read.preset, target);
  writeFileAtomically(arguments.out, written.text);
  std::vector<Message> changes = read.changes;
  for (const Message& change : written.changes)
    tell(changes, change);
  for (const Message& change : changes)
    note(change.english());
  if (arguments.json)
    std::cout << changesJson(changes);
}

std::string formatList() {
  std::string list;
  for (const LookFormat& format : lookFormats()) {
    std::string endings;
    for (const std::string& ending : format.endings)
      endings += " " + ending;
    list += "\n  " + format.name.english() + (format.write ? ":" + endings : " (only read)");
  }
  return list;
}

void addConvert(CommandSyntax& presets) {
  auto arguments = std::make_shared<ConvertArguments>();
  CommandSyntax command = presets.command("convert", "a look from one program's format to another's");
  command.option("IN", arguments->in, "a file with a look, told by its content, or the name of a preset")
      .required()
      .words(presetWords)
      .file(lookEndings());
  command.option("OUT", arguments->out, "the file to write, in the format of its ending")
      .required()
      .file(lookEndings());
  command
      .option("--for", arguments->volume,
              "the volume for which it is meant: gives spacing and range where a format needs them")
      .words({"sample"})
      .file();
  command.option("--look", arguments->look, "its name, of several looks in IN (default: the first)");
  command.flag("--json", arguments->json, "what was changed or lost as one JSON object on stdout");
  command.footer("Reads and writes:" + formatList() +
                 "\nExample: limn presets convert skull.vp skull.weasis.json");
  command.runs([arguments] { convertLook(*arguments); });
}

} // namespace

void addPresetsCommand(CommandSyntax& root) {
  CommandSyntax command =
      root.command("presets", "the built-in presets and your own, and looks of other programs");
  command.needsCommand();
  command.footer("Example: limn presets show \"CT bone\"");
  command.command("list", "names, modality and what each shows").runs(listPresets);
  auto name = std::make_shared<std::string>();
  CommandSyntax show = command.command("show", "one preset, or the look in a file, as JSON");
  show.option("NAME", *name, "the preset's name, or a file")
      .required()
      .words(presetWords)
      .file(lookEndings());
  show.footer("Example: limn presets show \"CT bone\"");
  show.runs([name] { showPreset(*name); });
  addConvert(command);
}

} // namespace limn
