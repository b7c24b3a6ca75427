// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/Arguments.h"
#include "app/core/drawing/ProcessCost.h"
#include "app/lab/stability/StabilityText.h"
#include "cpu/CpuRenderer.h"
#include "gl/DriverHealth.h"
#include "gl/HeadlessContext.h"
#include "io/AtomicFile.h"
#include "io/reports/ReportJson.h"
#include "scene/basics/Error.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <QDate>
#include <QString>
#include <QSysInfo>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace limn {
namespace {

// Random scenes of a report that asks for no number of them.
constexpr int usualSeeds = 200;

struct StabilityArguments {
  std::string folder;
  std::vector<std::string> only;
  int seeds = -1; ///< -1: not given
  std::uint64_t firstSeed = 1;
  bool quiet = false;
};

// As people type them: "h9, H12".
std::string caseId(const std::string& typed) {
  return QString::fromStdString(typed).trimmed().toUpper().toStdString();
}

std::vector<HardCase> chosenCases(const std::vector<std::string>& only) {
  std::vector<HardCase> cases = hardCases();
  if (only.empty())
    return cases;
  std::vector<HardCase> chosen;
  for (const std::string& given : only) {
    const std::string id = caseId(given);
    const auto found = std::ranges::find_if(cases, [&](const HardCase& one) { return one.id == id; });
    if (found == cases.end())
      throw Error(Error::Kind::usage, "There is no hard case " + given + "; they are called " +
                                          cases.front().id + " to " + cases.back().id + ".");
    chosen.push_back(*found);
  }
  return chosen;
}

// `from`: the share of the whole work that is done before.
FuzzReport fuzzed(const StabilityArguments& arguments, int seeds, FuzzedBy fuzzedBy, const Progress& progress,
                  double from) {
  const auto report = [&](int done) {
    if (progress.report && done % 10 == 0)
      progress.report(from + (1.0 - from) * done / seeds, "random scenes");
    return true;
  };
  return runFuzz(seeds, arguments.firstSeed, report, fuzzedBy);
}

// What draws here: a context with its driver, or the processor alone and why.
struct Drivers {
  std::optional<HeadlessContext> context;
  std::string withoutOpenGl; ///< one sentence where there is no context
};

// A machine without OpenGL is measured with the processor; no case is to blame for a driver that is too old.
void openDrivers(Drivers& drivers) {
  try {
    drivers.context.emplace();
  } catch (const Error& error) {
    drivers.withoutOpenGl = error.what();
    return;
  }
  requireOpenGl3();
}

std::string driverText() {
  const DriverFacts driver = driverFacts();
  return "OpenGL " + driver.version + ", GLSL " + driver.shadingLanguage + ", 3D textures up to " +
         std::to_string(driver.largest3dTexture) + " texels along an edge";
}

// What measures the same again, into any folder.
std::string commandFor(const StabilityArguments& arguments, int seeds) {
  std::string command = "limn stability -o DIR";
  for (std::size_t i = 0; i < arguments.only.size(); ++i)
    command += (i == 0 ? " --only " : ",") + caseId(arguments.only[i]);
  return command + " --fuzz " + std::to_string(seeds) + " --seed " + std::to_string(arguments.firstSeed);
}

void writeReport(const StabilityReport& report, const std::filesystem::path& folder) {
  makeReportFolder(folder);
  writeFileAtomically(folder / "stability.json", stabilityJson(report));
  writeFileAtomically(folder / "stability.html", stabilityPage(report));
}

void runStability(const StabilityArguments& arguments) {
  if (arguments.folder.empty() && arguments.seeds < 1 && arguments.only.empty())
    throw Error(Error::Kind::usage, "Where shall the report go? Give a folder with -o, or --fuzz N or --only "
                                    "H1 for figures on the terminal alone.");
  if (!arguments.folder.empty())
    requireReportFolder(arguments.folder);
  const bool hasCases = !arguments.folder.empty() || !arguments.only.empty();
  const std::vector<HardCase> cases = hasCases ? chosenCases(arguments.only) : std::vector<HardCase>();
  const Progress progress = terminalProgress(arguments.quiet);
  Drivers drivers;
  openDrivers(drivers);
  const bool hasOpenGl = drivers.context.has_value();
  const int seeds = arguments.seeds >= 0 ? arguments.seeds : arguments.only.empty() ? usualSeeds : 0;
  const double share = !hasCases ? 0.0 : seeds == 0 ? 1.0 : 0.5;
  StabilityReport report{LIMN_VERSION,
                         hasOpenGl ? rendererName() : CpuRenderer().name(),
                         hasOpenGl ? driverText() : drivers.withoutOpenGl,
                         machineName() + ", " + QSysInfo::prettyProductName().toStdString(),
                         QDate::currentDate().toString(Qt::ISODate).toStdString(),
                         commandFor(arguments, seeds),
                         {},
                         {}};
  if (hasCases) {
    Workbench bench(drivers.withoutOpenGl);
    report.cases = measure(cases, bench, [&](double fraction, const std::string& doing) {
      if (progress.report)
        progress.report(share * fraction, doing);
    });
  }
  if (seeds > 0)
    report.fuzz = fuzzed(arguments, seeds, hasOpenGl ? FuzzedBy::everyRenderer : FuzzedBy::processorAlone,
                         progress, share);
  if (!arguments.folder.empty())
    writeReport(report, arguments.folder);
  std::cout << stabilityTable(report);
  if (!holds(report))
    throw Error(
        Error::Kind::other,
        "Something above does not hold on this driver; please report it with the page that -o writes.");
}

} // namespace

void addStabilityCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<StabilityArguments>();
  CommandSyntax command = root.command("stability", "hard cases and random scenes on this driver");
  command.option("-o,--output", arguments->folder, "folder for stability.json and stability.html").folder();
  command.option("--only", arguments->only, "these cases alone, e.g. H9,H12").separatedByCommas();
  command
      .option("--fuzz", arguments->seeds,
              "how many random scenes to draw (default: 200 beside a report); alone: nothing else")
      .within(0, 100000000);
  command.option("--seed", arguments->firstSeed, "the first random scene (default 1)");
  command.flag("--quiet", arguments->quiet, "no progress");
  command.footer("Without OpenGL the processor draws alone, and rows that need OpenGL say so.\nEvery row has "
                 "a figure, a bound and a verdict; the exit status is 1 where one fails.\n"
                 "Example: limn stability -o report");
  command.runs([arguments] { runStability(*arguments); });
}

} // namespace limn
