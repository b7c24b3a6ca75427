// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"
#include "app/commands/FontsWithoutDisplay.h"
#include "app/commands/NamedLook.h"
#include "app/commands/SceneArguments.h"
#include "app/core/naming/MeantWord.h"
#include "app/document/PrivateNames.h"
#include "app/document/Settings.h"
#include "app/figures/FigureFiles.h"
#include "io/AtomicFile.h"
#include "scene/framing/Framing.h"
#include "scene/light/Shading.h"
#include "widgets/ValueText.h"
#include "widgets/figure/FigureText.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <locale>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace limn {
namespace {

// What may be said on the command line of a figure beside its scenes. Empty or 0: not given.
struct FigureArguments {
  std::string size;
  double dotsPerInch = 0.0;
  double textPoints = 0.0;
  std::string page;
  std::vector<std::string> marks;
};

[[noreturn]] void failSize(const std::string& text) {
  throw Error(Error::Kind::usage, "--size cannot be \"" + text +
                                      "\"; write a width or WIDTHxHEIGHT in pixels or centimetres, such as "
                                      "2000x1500, 17cm or 17x11cm.");
}

template <class Value, std::size_t count>
std::map<std::string, Value> byName(const std::array<Value, count>& values) {
  std::map<std::string, Value> words;
  for (const Value value : values)
    words.emplace(nameOf(value), value);
  return words;
}

std::vector<std::string> markWords() {
  std::vector<std::string> words = wordsOf(byName(figureMarks));
  words.insert(words.end(), {"all", "none"});
  return words;
}

// A figure's size as it is typed: "17cm", "17x11cm", "2000", "2000x1500" (pixels).
FigureSettings withSize(FigureSettings settings, const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  settings.height.reset();
  if (!(stream >> settings.width) || !(settings.width > 0.0))
    failSize(text);
  if (stream.peek() == 'x') {
    stream.get();
    if (!(stream >> settings.height.emplace()) || !(*settings.height > 0.0))
      failSize(text);
  }
  std::string unit;
  stream >> unit;
  if (!unit.empty() && unit != "cm" && unit != "px")
    failSize(text);
  settings.unit = unit == "cm" ? FigureSettings::Unit::centimetres : FigureSettings::Unit::pixels;
  return settings;
}

// The settings with everything that was given.
FigureSettings adjusted(FigureSettings settings, const FigureArguments& arguments) {
  if (!arguments.size.empty())
    settings = withSize(settings, arguments.size);
  if (arguments.dotsPerInch > 0.0)
    settings.dotsPerInch = arguments.dotsPerInch;
  if (arguments.textPoints > 0.0)
    settings.textPoints = arguments.textPoints;
  if (!arguments.page.empty())
    settings.page = chosen(byName(figurePages), arguments.page, "--page");
  const bool isOneWord = arguments.marks.size() == 1;
  if (isOneWord && (arguments.marks[0] == "all" || arguments.marks[0] == "none")) {
    settings.marks.fill(arguments.marks[0] == "all");
  } else if (!arguments.marks.empty()) {
    settings.marks.fill(false);
    for (const std::string& word : arguments.marks)
      settings.marks[static_cast<std::size_t>(chosen(byName(figureMarks), word, "--marks"))] = true;
  }
  return settings;
}

// What is given is written to `arguments`, which lives until the command has run.
void addFigureOptions(CommandSyntax& command, FigureArguments& arguments) {
  command.option(
      "--size", arguments.size,
      "of the whole figure: a width or WIDTHxHEIGHT in pixels, or in centimetres: 2000x1500, 17cm, "
      "17x11cm (default: 8.5cm for one panel, 17cm for more; the height follows from the pictures)");
  command.option("--dpi", arguments.dotsPerInch, "dots per inch (default 300)")
      .within(fewestDotsPerInch, mostDotsPerInch);
  command.option("--text", arguments.textPoints, "height of the text in points (default 8)")
      .within(1.0, 200.0);
  command.option("--page", arguments.page, "white, black or transparent (PNG, TIFF, EXR, PDF)")
      .words(wordsOf(byName(figurePages)));
  command
      .option("--marks", arguments.marks,
              "all, none or a list of letters, names, orientation, scale, curve, labels, measurements, "
              "accuracy, region, note")
      .separatedByCommas()
      .words(markWords);
}

struct FigureRequest {
  SceneArguments scene; ///< but for the source and the size
  std::vector<std::string> sources;
  FigureArguments figure;
  std::vector<std::string> panels, names;
  std::string out;
  std::string engine = "auto";
  int threads = 0;
};

/// A panel with what else is known of it.
struct Planned {
  FigurePanel panel;
  std::string volumePath;
  bool hasOwnCamera = false;
};

/// Panels in the order in which they stand.
struct Plan {
  FigureSettings settings;
  bool isReopened = false; ///< `settings` are those of a figure
  std::vector<Planned> panels;
  std::vector<std::string> notes;
};

const EngineWords figureEngines = engineWords({Engine::rayCaster, Engine::cpu, Engine::reference});

void say(Plan& plan, const std::string& sentence) {
  if (!sentence.empty() && std::ranges::find(plan.notes, sentence) == plan.notes.end())
    plan.notes.push_back(sentence);
}

// Two scene files that differ in neither model nor projection are told apart by their own names.
void nameAfterFiles(Plan& plan, const std::vector<std::string>& sources) {
  std::set<QString> names;
  for (const Planned& planned : plan.panels)
    names.insert(planned.panel.name);
  if (names.size() == plan.panels.size() || sources.size() != plan.panels.size())
    return;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const QString stem = QString::fromStdString(std::filesystem::path(sources[i]).stem().string());
    if (!mayNameThePatient(stem, plan.panels[i].panel.scene.volume->info().patient))
      plan.panels[i].panel.name = stem;
  }
}

void addPanel(Plan& plan, FigurePanel panel, const LoadedScene& loaded) {
  if (panel.name.isEmpty())
    panel.name = usualName(panel);
  panel.measurements = loaded.measurements;
  plan.panels.push_back({std::move(panel), loaded.volumePath, loaded.hasOwnCamera});
}

// A scene in one panel, or in one for each model.
void addScene(Plan& plan, const LoadedScene& loaded, const SceneArguments& arguments) {
  FigurePanel panel;
  panel.scene = adjusted(loaded, arguments);
  if (arguments.model.empty())
    return addPanel(plan, panel, loaded);
  const std::vector<ShadingModel> models =
      arguments.model == "compare" ? std::vector{ShadingModel::classic, ShadingModel::enhanced}
                                   : std::vector{modelNamed(arguments.model, "--model (beside compare)")};
  for (const ShadingModel model : models) {
    panel.scene.shading.model = model;
    addPanel(plan, panel, loaded);
  }
}

// What a word of --panels makes of a scene: another model, a slice, or another preset.
void addWord(Plan& plan, const LoadedScene& loaded, SceneArguments arguments, const std::string& word) {
  for (const PatientPlane plane : patientPlanes)
    if (word == nameOf(plane))
      return addPanel(plan, planePanel(adjusted(loaded, arguments), plane, {}), loaded);
  FigurePanel panel;
  const bool isModel =
      std::ranges::any_of(shadingModels, [&](ShadingModel model) { return word == nameOf(model); });
  if (!isModel) {
    arguments.preset = word;
    panel.name = QString::fromStdString(calledName(word));
  }
  panel.scene = adjusted(loaded, arguments);
  if (isModel)
    panel.scene.shading.model = modelNamed(word, "--panels");
  addPanel(plan, panel, loaded);
}

std::vector<std::string> panelWords() {
  std::vector<std::string> words = modelWords();
  for (const PatientPlane plane : patientPlanes)
    words.emplace_back(nameOf(plane));
  const std::vector<std::string> presets = presetWords();
  words.insert(words.end(), presets.begin(), presets.end());
  return words;
}

void requirePanel(const std::string& word) {
  const std::vector<std::string> known = panelWords();
  if (std::ranges::find(known, word) != known.end() || namesPreset(word) || namesLookFile(word))
    return;
  const std::string meant = meantBy(word, known);
  throw Error(Error::Kind::usage, "--panels cannot be \"" + word + "\"; " +
                                      (meant.empty() ? "choose" : "did you mean \"" + meant + "\"? Choose") +
                                      " a model (classic, enhanced, robust, physical, none), a slice (axial, "
                                      "coronal, sagittal) or a preset "
                                      "(limn presets list).");
}

void addReopened(Plan& plan, const LoadedFigure& figure, const SceneArguments& arguments) {
  plan.settings = figure.settings;
  plan.isReopened = true;
  for (const LoadedFigure::Panel& loaded : figure.panels) {
    FigurePanel panel = panelOf(loaded);
    panel.scene = adjusted(loaded.scene, arguments);
    addPanel(plan, panel, loaded.scene);
    for (const Message& note : loaded.scene.notes)
      say(plan, note.english());
  }
}

Plan planned(const FigureRequest& request, const Progress& progress) {
  Plan plan;
  plan.settings.width = 0.0;
  if (!request.panels.empty() && (request.sources.size() > 1 || !request.scene.model.empty()))
    throw Error(Error::Kind::usage,
                "--panels shows one scene in several ways; it takes one SCENE and no --model.");
  for (const std::string& word : request.panels)
    requirePanel(word);
  SourceOptions options = sourceOptions(request.scene.source);
  options.bringsView = !request.scene.view.empty();
  for (const std::string& source : request.sources) {
    if (const auto figure = loadFigure(source, options, progress)) {
      addReopened(plan, *figure, request.scene);
      continue;
    }
    const LoadedScene loaded = loadScene(source, options, progress);
    options.opened.emplace(loaded.volumePath, loaded.scene.volume);
    if (plan.panels.empty() && !plan.isReopened)
      plan.settings.panelAspect = 1.0 * loaded.scene.image.width / loaded.scene.image.height;
    if (request.panels.empty())
      addScene(plan, loaded, request.scene);
    for (const std::string& word : request.panels)
      addWord(plan, loaded, request.scene, word);
    if (request.scene.preset.empty() && !loaded.preset.empty())
      say(plan, "Shown with the preset \"" + loaded.preset + "\".");
    for (const Message& note : loaded.notes)
      say(plan, note.english());
  }
  if (plan.panels.size() > mostPanels)
    throw Error(Error::Kind::usage, "A figure has at most " + std::to_string(mostPanels) + " panels, not " +
                                        std::to_string(plan.panels.size()) + "; make several figures.");
  nameAfterFiles(plan, request.sources);
  return plan;
}

// One column of a journal for one panel, two for more.
Figure figureOf(Plan& plan, const FigureRequest& request) {
  if (plan.settings.width <= 0.0)
    plan.settings.width = plan.panels.size() == 1 ? 8.5 : 17.0;
  Figure figure{adjusted(plan.settings, request.figure), {}};
  if (request.names.size() > plan.panels.size())
    throw Error(Error::Kind::usage, "--names has more names than the figure has panels (" +
                                        std::to_string(plan.panels.size()) + ").");
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    figure.panels.push_back(plan.panels[i].panel);
    if (i < request.names.size())
      figure.panels[i].name = QString::fromStdString(request.names[i]);
  }
  const QSize size = figureLayout(figure).pictureSize();
  const double aspect = 1.0 * size.width() / size.height();
  for (std::size_t i = 0; i < plan.panels.size(); ++i)
    if (!plan.panels[i].hasOwnCamera && request.scene.view.empty())
      figure.panels[i].scene.camera = framedCamera(figure.panels[i].scene, aspect);
    else if (!request.scene.view.empty())
      figure.panels[i].scene.camera = viewOf(figure.panels[i].scene, request.scene.view, aspect);
  return figure;
}

void requireMemory(const Figure& figure, FigurePixels pixels, bool isQuiet) {
  const FigureLayout layout = figureLayout(figure);
  const std::string told = memoryNote(layout, pixels);
  if (!hasMemoryFor(layout, pixels))
    throw Error(Error::Kind::other, told + " Choose a smaller figure or close other programs.");
  if (!told.empty() && !isQuiet)
    note(told);
}

MakingOptions orderOf(const FigureRequest& request, Settings& settings, const Progress& progress) {
  MakingOptions order;
  order.engine = chosen(figureEngines, request.engine, "--engine");
  order.memory = settings.engineMemory();
  order.effort.threads = request.threads;
  if (progress.report)
    order.effort.report = [report = progress.report](double fraction) { report(fraction, "Drawing"); };
  return order;
}

// Of pictures that are not accurate to the screen, how to get such.
std::string coarseNote(const Figure& figure) {
  constexpr double accurateLevels = 1.0;
  double worst = 0.0;
  for (const FigurePanel& panel : figure.panels)
    worst = std::max(worst, panel.errorLevels.value_or(0.0));
  if (worst <= accurateLevels)
    return {};
  return "A picture is up to " + promisedLevels(worst).toStdString() +
         " of 255 levels from the exact one; --tolerance 0.5 draws it to that, and takes longer.";
}

void tell(const MadeFigure& made, const Plan& plan, const std::string& file, double ms,
          bool isWithinTolerance) {
  for (const std::string& sentence : plan.notes)
    note(sentence);
  // Who asked for a tolerance has what was asked for.
  if (const std::string sentence = coarseNote(made.figure); !isWithinTolerance && !sentence.empty())
    note(sentence);
  for (const std::string& sentence : made.notes)
    note(sentence);
  const FigureLayout& layout = made.layout;
  const double cm = 2.54 / made.figure.settings.dotsPerInch;
  char line[200];
  std::snprintf(
      line, sizeof line,
      ": %d x %d pixels (%.1f x %.1f cm at %g dpi), pictures of %d x %d, in %.0f ms (set-up included)%s",
      layout.size.width(), layout.size.height(), cm * layout.size.width(), cm * layout.size.height(),
      made.figure.settings.dotsPerInch, layout.pictureSize().width(), layout.pictureSize().height(), ms,
      made.engine.empty() ? "" : " on ");
  note(file + line + made.engine);
}

void runFigure(const FigureRequest& request) {
  const FigurePixels pixels = pixelsFor(figureFormatOf(request.out));
  requireWritable(request.out);
  const FontsWithoutDisplay fonts;
  const Progress progress = terminalProgress(request.scene.source.quiet);
  Plan plan = planned(request, progress);
  const Figure figure = figureOf(plan, request);
  requireMemory(figure, pixels, request.scene.source.quiet);
  const auto start = std::chrono::steady_clock::now();
  Settings settings;
  const MakingOptions order = orderOf(request, settings, progress);
  const MadeFigure made = makeFigure(figure, order, pixels);
  std::vector<std::string> volumes;
  for (const Planned& planned : plan.panels) {
    requireWhole(planned.volumePath, *planned.panel.scene.volume);
    volumes.push_back(planned.volumePath);
  }
  const NameInFile named = [](const std::string& path, const Volume& volume) {
    return shareableName(QString::fromStdString(path), volume).toStdString();
  };
  writeFigure(request.out, made, figureDescription(made, volumes, named));
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  if (!request.scene.source.quiet)
    tell(made, plan, request.out, ms.count(), request.scene.toleranceLevels > 0.0);
}

} // namespace

void addFigureCommand(CommandSyntax& root) {
  auto request = std::make_shared<FigureRequest>();
  CommandSyntax command = root.command("figure", "a labelled figure of one to four pictures");
  command
      .option(
          "SCENE", request->sources,
          "up to four scene or session files, volumes, DICOM folders, Limn pictures, or one figure of Limn")
      .required()
      .words({"sample"})
      .file();
  command.option("-o,--output", request->out, "figure to write: .png .tif .exr .pdf")
      .required()
      .file({".png", ".tif", ".exr", ".pdf"});
  addFigureOptions(command, request->figure);
  command
      .option("--panels", request->panels,
              "how one SCENE is shown, a panel each: classic, enhanced, robust, none, axial, coronal, "
              "sagittal, or "
              "names of presets")
      .separatedByCommas()
      .words(panelWords);
  command.option("--names", request->names, "what stands above the panels").separatedByCommas();
  command
      .option("--model", request->scene.model,
              "none, classic, enhanced, robust, or compare (classic and enhanced, a panel each)")
      .words(modelWordsAndCompare);
  addLookOptions(command, request->scene);
  addSourceOptions(command, request->scene.source);
  command.flag("--quiet", request->scene.source.quiet, "no progress and no remarks on stderr");
  command.option("--engine", request->engine, "auto (the faster of gl and cpu), gl, cpu or reference")
      .words(wordsOf(figureEngines));
  command
      .option("--threads", request->threads,
              "threads of the CPU engine and the reference (default: every core)")
      .within(1, 4096);
  command.footer("Example: limn figure head.nii.gz --model compare --size 17cm -o figure.pdf");
  command.runs([request] { runFigure(*request); });
}

} // namespace limn
