// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/CommandLine.h"

#include "app/commands/Arguments.h"
#include "app/commands/Commands.h"
#include "app/commands/Syntax.h"
#include "app/commands/describe/Slips.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"

#include <QCoreApplication>
#include <QLocale>

#include <exception>

namespace limn {
namespace {

int statusOf(Error::Kind kind) {
  switch (kind) {
  case Error::Kind::usage:
    return 2;
  case Error::Kind::input:
    return 3;
  case Error::Kind::openGl:
    return 4;
  case Error::Kind::other:
    return 1;
  }
  return 1;
}

struct RootArguments {
  WindowArguments window;
  SourceArguments source;
};

} // namespace

int statusOf(const std::function<int()>& work) {
  try {
    return work();
  } catch (const Error& error) {
    note(error.what());
    return statusOf(error.kind());
  } catch (const std::bad_alloc&) {
    note("There is not enough memory for this; close other programs or use a smaller volume or picture.");
    return 1;
  } catch (const std::exception& error) {
    note(std::string("Something unexpected failed: ") + error.what() +
         ". Please report it with `limn info --system`.");
    return 1;
  }
}

std::string versionOfProgram() {
  return LIMN_VERSION;
}

void nameProgram() {
  QCoreApplication::setApplicationName(QStringLiteral("limn"));
  QCoreApplication::setOrganizationName(QStringLiteral("limn"));
  QCoreApplication::setApplicationVersion(QStringLiteral(LIMN_VERSION));
  // What commands print and write is the same everywhere; the window asks for the user's locale.
  QLocale::setDefault(QLocale::c());
}

bool hasDisplay() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

int runCommandLine(int argc, char** argv, const Windows& windows) {
  nameProgram();
  ProgramSyntax program("limn",
                        "Limn shows CT and MR volumes: shape a transfer function, compare classic and "
                        "gradient-enhanced Blinn-Phong. Not for diagnosis.",
                        LIMN_VERSION);
  RootArguments arguments;
  WindowArguments& window = arguments.window;
  CommandSyntax syntax = program.words();
  syntax
      .option(
          "PATH", window.path,
          "open the window on this volume, DICOM folder, session, scene or Limn picture, or on the `sample`")
      .words({"sample"})
      .file();
  syntax
      .option("--screenshot", window.screenshot,
              "save a PNG of the window once its picture is refined, then quit")
      .file({".png"});
  syntax.option("--theme", window.theme, "light, dark or contrast (high), for this run")
      .oneOf({"light", "dark", "contrast"});
  syntax.option("--language", window.language, "of the window for this run: en or de").oneOf({"en", "de"});
  addSourceOptions(syntax, arguments.source);
  syntax.footer("Example: limn head.nii.gz");
  addInfoCommand(syntax);
  addRenderCommand(syntax);
  addDicomCommand(syntax);
  addFigureCommand(syntax);
  addTurntableCommand(syntax);
  addJobsCommand(syntax);
  addSurfaceCommand(syntax);
  addEffectsCommand(syntax);
  addPresetsCommand(syntax);
  addAccuracyCommand(syntax);
  addStabilityCommand(syntax);
  addBenchCommand(syntax);
  addGuideCommand(syntax, windows.showGuide);
  addHelpCommand(syntax, program);
  addDescribeCommand(syntax, program, LIMN_VERSION);
  return statusOf([&] {
    if (const std::optional<int> status = program.run(argc, argv))
      return *status;
    // A word that is no file may be a command that was misspelt.
    if (const std::string slip = slipIn(program.described(), {window.path}); !slip.empty())
      throw Error(Error::Kind::usage, slip);
    if (!window.screenshot.empty())
      requireWritable(window.screenshot);
    window.options = sourceOptions(arguments.source);
    return windows.run(argc, argv, window);
  });
}

} // namespace limn
