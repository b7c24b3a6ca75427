// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/Arguments.h"
#include "app/presets/PresetStore.h"
#include "io/scenefile/SceneFile.h"

#include <cstdio>
#include <iostream>
#include <memory>

namespace limn {
namespace {

void listPresets() {
  for (const Preset& preset : builtInPresets())
    std::printf("%-18s %-4s built-in  %s\n", preset.name.c_str(), preset.modality.c_str(),
                preset.note.c_str());
  const PresetStore::Contents own = PresetStore::ofThisUser().read();
  for (const Preset& preset : own.presets)
    std::printf("%-18s %-4s own       %s\n", preset.name.c_str(), preset.modality.c_str(),
                preset.note.c_str());
  for (const Message& problem : own.problems)
    note(problem.english());
}

void showPreset(const std::string& name) {
  std::cout << presetToJson(presetNamed(allPresets(PresetStore::ofThisUser()), name));
}

} // namespace

void addPresetsCommand(CommandSyntax& root) {
  CommandSyntax command = root.command("presets", "the built-in presets and your own");
  command.needsCommand();
  command.footer("Example: limn presets show \"CT bone\"");
  command.command("list", "names, modality and what each shows").runs(listPresets);
  auto name = std::make_shared<std::string>();
  CommandSyntax show = command.command("show", "one preset as JSON");
  show.option("NAME", *name, "the preset's name").required();
  show.footer("Example: limn presets show \"CT bone\"");
  show.runs([name] { showPreset(*name); });
}

} // namespace limn
