// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace limn {

class CommandSyntax;
class ProgramSyntax;

// The commands of the program; each adds itself to the program's own words.

/// `limn info`: what a volume is, or with --system what a bug report needs; that names nobody, no folder and
/// no file.
void addInfoCommand(CommandSyntax& root);

/// `limn render`: a picture of a scene, or of two shading models side by side.
void addRenderCommand(CommandSyntax& root);
std::vector<std::string> renderEngineWords(); ///< what its --engine takes

/// `limn dicom SOURCE -o FOLDER`: picture and look of a DICOM series as objects for an archive.
void addDicomCommand(CommandSyntax& root);

/// `limn figure SCENE…`: a labelled figure of one to four pictures.
void addFigureCommand(CommandSyntax& root);

/// `limn turntable`: pictures from all around, as frames or a video.
void addTurntableCommand(CommandSyntax& root);

/// `limn jobs VOLUME… -o DIR`: the commands of many pictures, one a line.
void addJobsCommand(CommandSyntax& root);

/// `limn surface SOURCE --value V -o OUT`: the isosurface as a mesh.
void addSurfaceCommand(CommandSyntax& root);

/// `limn effects`: what a picture simulates, why, and what each effect costs.
void addEffectsCommand(CommandSyntax& root);

/// `limn presets list`, `limn presets show NAME` and `limn presets convert IN OUT`.
void addPresetsCommand(CommandSyntax& root);

/// `limn accuracy SOURCE -o DIR`: error against time of a scene.
void addAccuracyCommand(CommandSyntax& root);

/// `limn stability`: the hard cases and random scenes on this machine's driver. Its exit status is 1 where
/// one fails.
void addStabilityCommand(CommandSyntax& root);

/// `limn guide [WORDS]`: the guide, in a window (`show`), as a page or as text.
void addGuideCommand(CommandSyntax& root, const std::function<void(const std::string& words)>& show);

/// `limn bench`: milliseconds per frame by renderer, scene and step.
void addBenchCommand(CommandSyntax& root);

/// `limn help [COMMAND]`: what --help behind the command prints (ProgramSyntax::run). `program` is asked when
/// completions are made.
void addHelpCommand(CommandSyntax& root, const ProgramSyntax& program);

/// `limn describe`, hidden: manual page and completions, made from `program`'s own words. `version` and
/// `program` are asked when it runs.
void addDescribeCommand(CommandSyntax& root, const ProgramSyntax& program, const std::string& version);

} // namespace limn
