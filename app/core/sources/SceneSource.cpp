// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/SceneSource.h"

#include "app/core/naming/MeantWord.h"
#include "app/core/sources/BuiltInPresets.h"
#include "app/core/sources/KeptRegion.h"
#include "app/core/sources/LookSource.h"
#include "io/ImageFile.h"
#include "io/scenefile/ForeignJson.h"
#include "io/scenefile/SceneFile.h"
#include "scene/effects/EffectPlan.h"
#include "scene/framing/Framing.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/presets/PresetFit.h"
#include "scene/view/FirstView.h"
#include "scene/volume/Orientation.h"
#include "scene/volume/Phantom.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostSceneBytes = 16u << 20;

std::string lowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool isPhantom(const std::string& source) {
  std::error_code unknown;
  return (source == "phantom" || source.starts_with("phantom:")) && !fs::exists(source, unknown);
}

struct OpenedVolume {
  std::shared_ptr<const Volume> volume;
  std::string path;
  std::shared_ptr<const DicomFolder> dicom = nullptr;
};

std::shared_ptr<const Volume> phantomNamed(const std::string& source, const Progress& progress) {
  PhantomSpec spec;
  if (const auto colon = source.find(':'); colon != std::string::npos) {
    const std::string number = source.substr(colon + 1);
    const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), spec.spacingMm);
    if (failed != std::errc() || end != number.data() + number.size())
      throw Error(
          Error::Kind::usage,
          Message::tr("\"%1\" is not a phantom; write phantom:SPACING, such as phantom:1.5.").arg(source));
  }
  if (progress.report)
    progress.report(0.0, Message::tr("Making the phantom"));
  return phantomVolume(spec, progress.isCancelled);
}

// A built-in volume whose name was misspelt is no file that is missing.
void refuseMisspeltName(const std::string& source) {
  std::error_code unknown;
  const std::string meant = meantBy(source.substr(0, source.find(':')), {"sample", "phantom"});
  if (!meant.empty() && !fs::exists(source, unknown))
    throw Error(Error::Kind::input,
                Message::tr("Cannot read %1: there is no such file or folder; did you mean %2?")
                    .arg(source)
                    .arg(meant));
}

OpenedVolume readSource(const std::string& source, const SourceOptions& options, const Progress& progress,
                        std::vector<Message>& notes) {
  if (source == "sample") {
    if (const auto head = installedSampleHead())
      return {readVolume(*head, options.read, progress), head->string()};
    notes.push_back(Message::tr(
        "No example head is installed (package invesalius-examples), so the built-in phantom is shown."));
    return {phantomNamed("phantom", progress), "phantom"};
  }
  if (isPhantom(source))
    return {phantomNamed(source, progress), source};
  refuseMisspeltName(source);
  const std::string path = absoluteSource(source);
  const bool isOpen = options.dicom && absoluteSource(options.dicom->path().string()) == path;
  const std::shared_ptr<const DicomFolder> dicom = isOpen ? options.dicom : dicomAt(source, progress);
  if (options.asksForSeries && !options.read.series && dicom && fs::is_directory(source) &&
      dicom->summaries().size() > 1)
    throw SeveralSeries(dicom);
  return {readVolume(source, dicom, options.read, progress), path, dicom};
}

OpenedVolume openVolume(const std::string& source, const SourceOptions& options, const Progress& progress,
                        std::vector<Message>& notes) {
  OpenedVolume opened = readSource(source, options, progress, notes);
  if (const auto series = options.read.series; series && opened.volume->info().format != "DICOM")
    notes.push_back(Message::tr("This is no DICOM series; its number %1 was ignored.").arg(*series));
  return opened;
}

OpenedVolume openedBefore(const std::string& source, const SourceOptions& options, const Progress& progress,
                          std::vector<Message>& notes) {
  const auto known = options.opened.find(absoluteSource(source));
  return known != options.opened.end() ? OpenedVolume{known->second, known->first}
                                       : openVolume(source, options, progress, notes);
}

// The text of a scene or session, which is told by what it holds: a file may have lost its ending. What has
// the ending is taken for one, so that an error can say what is wrong with it.
std::optional<std::string> sceneText(const fs::path& path) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown))
    return std::nullopt;
  if (lowerExtension(path) == ".json") {
    std::string text = readTextFile(path);
    refuseForeignJson(text, path.filename().string());
    return text;
  }
  char first = 0;
  std::ifstream(path, std::ios::binary) >> first; // behind white space
  if (first != '{' || fs::file_size(path, unknown) > mostSceneBytes || unknown)
    return std::nullopt;
  std::string text = readTextFile(path);
  if (!looksLikeSession(text) && !looksLikeScene(text))
    return std::nullopt;
  return text;
}

// What a picture that Limn wrote says of its scenes; any other image is a slice of a stack.
std::string descriptionIn(const fs::path& path) {
  const std::string extension = lowerExtension(path);
  const bool mayCarry = extension == ".png" || extension == ".tif" || extension == ".tiff" ||
                        extension == ".exr" || extension == ".pdf";
  if (!mayCarry || !fs::is_regular_file(path))
    return {};
  std::string description = readImageDescription(path);
  if (extension == ".pdf" && !looksLikeFigure(description))
    throw Error(Error::Kind::input,
                Message::tr("Cannot open %1: it is no figure of Limn; choose a volume, a scene or a picture.")
                    .arg(path.filename().string()));
  return description;
}

std::optional<SceneDocument> sceneInPicture(const fs::path& path) {
  const std::string description = descriptionIn(path);
  if (description.find("\"limn_scene\"") == std::string::npos || looksLikeFigure(description))
    return std::nullopt;
  return located(parseScene(description, path.filename().string()), path);
}

std::optional<FigureDocument> figureIn(const fs::path& path) {
  const std::string description = descriptionIn(path);
  if (!looksLikeFigure(description))
    return std::nullopt;
  FigureDocument figure = parseFigure(description, path.filename().string());
  for (FigurePanelDocument& panel : figure.panels)
    panel.scene = located(std::move(panel.scene), path);
  return figure;
}

// The second panel as the other side of a comparison where it differs in the model alone, and slices.
SessionDocument besideFirst(const FigureDocument& figure) {
  SessionDocument beside;
  beside.layout = CompareLayout::single;
  const FigurePanelDocument& first = figure.panels.front();
  for (const FigurePanelDocument& panel : figure.panels) {
    SceneDocument other = panel.scene;
    other.scene.shading.model = first.scene.scene.shading.model;
    if (other != first.scene)
      continue;
    if (panel.plane) {
      beside.planes = panel.planes;
      beside.planes.layout = PlaneLayout::pictureAndThree;
    } else if (&panel != &first && beside.layout == CompareLayout::single) {
      beside.layout = CompareLayout::sideBySide;
      beside.leftModel = first.scene.scene.shading.model;
      beside.rightModel = panel.scene.scene.shading.model;
    }
  }
  return beside;
}

// What a window cannot hold of a figure.
Message remarkOn(const FigureDocument& figure, const SessionDocument& beside) {
  const auto isHeld = [&](const FigurePanelDocument& panel) {
    SceneDocument other = panel.scene;
    const ShadingModel model = other.scene.shading.model;
    other.scene.shading.model = figure.panels.front().scene.scene.shading.model;
    const bool isSide = model == other.scene.shading.model ||
                        (beside.layout == CompareLayout::sideBySide && model == beside.rightModel);
    return other == figure.panels.front().scene && (panel.plane || isSide);
  };
  const auto held = std::ranges::count_if(figure.panels, isHeld);
  const auto all = static_cast<std::ptrdiff_t>(figure.panels.size());
  if (held == all)
    return {};
  if (held == 1)
    return Message::tr("The figure has %1 panels, of which the window shows the first.").arg(all);
  return Message::tr("The figure has %1 panels, of which the window shows %2.").arg(all).arg(held);
}

void keepPart(LoadedScene& loaded, const KeptPart& written, const SourceOptions& options,
              const Progress& progress) {
  KeptPart part = written;
  part.labels = labelsOf(part.labels, loaded.volumePath, options);
  for (std::string& mask : part.moreLabels)
    mask = labelsOf(mask, loaded.volumePath, options);
  FoundRegion kept = regionOf(part, written, *loaded.scene.volume, progress);
  loaded.scene.keep = std::move(kept.region);
  if (!kept.remark.empty())
    loaded.notes.push_back(kept.remark);
}

// Places of one volume mean nothing in another that is shown in its stead.
bool isOfAnotherVolume(const SceneDocument& document, const SourceOptions& options) {
  if (!options.volume)
    return false;
  const std::string name = fs::path(document.volume).filename().string();
  const auto referred = options.references.find(name);
  const fs::path meant = referred != options.references.end() ? referred->second.filename() : fs::path(name);
  return options.volume->filename() != meant;
}

bool isOnAnotherGrid(const std::optional<VolumeTraits>& own, const Volume& shown) {
  return own && own->voxels != shown.grid().dims;
}

// Labels on another grid mean nothing, and reading them would say so instead of which volume this is.
void leaveLabelsOut(LoadedScene& loaded, KeptPart& keep, bool areOfAnother) {
  if (keep.kind != Region::Kind::labels)
    return;
  KeptPart left;
  left.cuts = keep.cuts;
  keep = left;
  loaded.lacksLabels = true;
  loaded.notes.push_back(areOfAnother
                             ? Message::tr("The labels were left out: they are of another volume.")
                             : Message::tr("The labels were left out, as you asked; the file keeps them."));
}

void takeMeasurements(LoadedScene& loaded, const SceneDocument& document) {
  if (!loaded.isOfAnotherVolume)
    loaded.measurements = document.measurements;
  else if (!document.measurements.empty())
    loaded.notes.push_back(Message::tr("The measurements were left out: they are of another volume."));
}

// `own` is what is known of the document's own volume.
LoadedScene loadDocument(SceneDocument document, const SourceOptions& options, const Progress& progress,
                         NamedBy by, const std::optional<VolumeTraits>& own = {}) {
  LoadedScene loaded;
  loaded.hasOwnCamera = document.hasCamera;
  loaded.views = std::move(document.views);
  loaded.sides = document.sides;
  loaded.scene = std::move(document.scene);
  const std::string source = volumeOf(document, options, by);
  const OpenedVolume opened = openedBefore(source, options, progress, loaded.notes);
  loaded.scene.volume =
      document.orientation.empty() ? opened.volume : orientedByHand(*opened.volume, document.orientation);
  loaded.volumePath = opened.path;
  loaded.dicom = opened.dicom;
  loaded.read = options.read;
  if (options.wantsVolumeAlone)
    return loaded;
  const bool isElsewhere = isOnAnotherGrid(own, *opened.volume);
  loaded.isOfAnotherVolume = isElsewhere || isOfAnotherVolume(document, options);
  if (isElsewhere || options.leavesLabelsOut)
    leaveLabelsOut(loaded, document.keep, isElsewhere);
  keepPart(loaded, document.keep, options, progress);
  takeMeasurements(loaded, document);
  if (!document.hasCamera)
    loaded.scene.camera = defaultCamera(opened.volume->grid());
  if (!document.hasTransferFunction) {
    // Only the curve: the scene's other keys have values of their own.
    const Preset preset = bestFitting(builtInPresets(), *opened.volume, effortOf(progress, countingVoxels));
    loaded.scene.transferFunction = preset.transferFunction;
    loaded.preset = preset.name;
  }
  return loaded;
}

LoadedScene loadSession(const fs::path& path, SourceOptions options, const Progress& progress) {
  const std::string text = readTextFile(path);
  const SessionDocument session = sessionIn(text, path);
  const bool isOtherSeries = options.read.series && session.series && options.read.series != session.series;
  if (!options.read.series)
    options.read.series = session.series;
  if (!options.read.spacingMm)
    options.read.spacingMm = session.spacingMm;
  LoadedScene loaded = loadDocument(session.scene, options, progress, NamedBy::session, session.traits);
  if (isOtherSeries && !loaded.measurements.empty()) {
    loaded.measurements.clear();
    loaded.notes.push_back(Message::tr("The measurements were left out: they are of another series."));
  }
  loaded.session = session;
  loaded.sessionDigest = digestOf(text);
  return loaded;
}

// A look names its images, not where they lie, and measures in millimetres what a scene measures in voxels.
LoadedScene loadLook(const fs::path& path, SourceOptions options, const Progress& progress) {
  PlacedLook placed = placedLook(path, options, progress);
  options.volume = placed.dicom->path();
  options.dicom = placed.dicom;
  options.read.series = placed.series;
  options.opened.clear(); // they may be of other series of the folder
  std::vector<Message> changes = placed.look.changes;
  const OpenedVolume opened = openVolume(options.volume->string(), options, progress, changes);
  options.opened.emplace(opened.path, opened.volume);
  const SceneDocument document = sceneOf(placed.look, opened.volume->grid(), changes);
  LoadedScene loaded = loadDocument(document, options, progress, NamedBy::look);
  loaded.dicom = opened.dicom;
  loaded.notes.insert(loaded.notes.begin(), changes.begin(), changes.end());
  return loaded;
}

} // namespace

std::string carriedBy(const std::string& source) {
  const std::string description = descriptionIn(source);
  const bool isScene = description.find("\"limn_scene\"") != std::string::npos;
  return isScene || looksLikeFigure(description) ? description : std::string();
}

std::string absoluteSource(const std::string& source) {
  if (source == "sample" || isPhantom(source))
    return source;
  const fs::path path = fs::absolute(source).lexically_normal();
  // A folder may be written with a slash behind it.
  return (path.has_filename() ? path : path.parent_path()).string();
}

// Why surfaces of such a volume show bands; no look can take them away. An image has no other slice.
static Message thickSlices(const Grid& grid, bool isSmoothed) {
  constexpr double muchThicker = 4.0;
  const double thickest = std::max({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
  const double ratio = thickest / smallestSpacingMm(grid);
  if (ratio < muchThicker || imageNormalAxis(grid))
    return {};
  return (isSmoothed
              ? Message::tr("The slices lie %1 mm apart, %2 times as far as the pixels within them: surfaces "
                            "show a band for each slice, though smooth normals take most of it out of the "
                            "light.")
              : Message::tr("The slices lie %1 mm apart, %2 times as far as the pixels within them: surfaces "
                            "show a band for each slice."))
      .arg(Message::rounded(thickest, 2))
      .arg(Message::fixed(ratio, 0));
}

static LoadedScene loadUnframed(const std::string& source, const SourceOptions& options,
                                const Progress& progress) {
  SourceOptions named = options; // for the volume that a file names
  named.asksForSeries = false;
  if (const std::optional<std::string> text = sceneText(source))
    return looksLikeSession(*text) ? loadSession(source, named, progress)
                                   : loadDocument(readSceneFile(source), named, progress, NamedBy::scene);
  if (isDicomLookFile(source))
    return loadLook(source, named, progress);
  if (auto document = sceneInPicture(source))
    return loadDocument(std::move(*document), named, progress, NamedBy::picture);
  if (auto figure = figureIn(source)) {
    LoadedScene first = loadDocument(figure->panels.front().scene, named, progress, NamedBy::picture);
    first.beside = besideFirst(*figure);
    if (const Message remark = remarkOn(*figure, *first.beside); !remark.empty()) {
      const Message command = Message::tr("The command limn figure draws all of them again.");
      first.notes.insert(first.notes.begin(), {remark, command});
      if (std::ranges::all_of(figure->panels, [&](const FigurePanelDocument& panel) {
            return panel.scene.volume == figure->panels.front().scene.volume;
          }))
        first.morePanels = {remark, command};
    }
    return first;
  }
  LoadedScene loaded;
  const OpenedVolume opened = openedBefore(source, options, progress, loaded.notes);
  loaded.scene.volume = opened.volume;
  loaded.volumePath = opened.path;
  loaded.dicom = opened.dicom;
  loaded.read = options.read;
  if (options.wantsVolumeAlone)
    return loaded;
  const Grid& grid = opened.volume->grid();
  loaded.scene.camera = firstView(defaultCamera(grid), grid, opened.volume->info().orientationKnown);
  const Preset preset = bestFitting(builtInPresets(), *opened.volume, effortOf(progress, countingVoxels));
  loaded.scene = withPreset(loaded.scene, preset);
  loaded.preset = preset.name;
  if (options.smoothsSlices)
    loaded.scene.shading.gradientSmoothing = smoothingOfSlices(grid);
  if (options.hidesTable && !imageNormalAxis(grid))
    loaded.scene.keep = sureBodyOf(*opened.volume, progress);
  return loaded;
}

static bool mayLookPast(const LoadedScene& loaded, const SourceOptions& options) {
  return options.volume && loaded.hasOwnCamera && !options.wantsVolumeAlone && !options.bringsView;
}

// A scene for another patient may look to where that one lay: what is there is framed, from the same side.
static void frameWhatIsPassed(LoadedScene& loaded, const Progress& progress) {
  const Grid& grid = loaded.scene.volume->grid();
  const ImageSettings& image = loaded.scene.image;
  const double aspect = 1.0 * image.width / image.height;
  const VisibleVoxels visible =
      visibleVoxels(loaded.scene, effortOf(progress, Message::tr("Finding what is visible")));
  if (seesAny(loaded.scene.camera, grid, visible, aspect))
    return;
  loaded.scene.camera = framed(loaded.scene.camera, grid, visible, aspect);
  loaded.hasOwnCamera = false;
  loaded.notes.insert(loaded.notes.begin(),
                      Message::tr("The saved view looks past this volume: the look was taken over, and the "
                                  "view is fitted to this volume."));
}

std::optional<LoadedFigure> loadFigure(const std::string& source, const SourceOptions& options,
                                       const Progress& progress) {
  const std::optional<FigureDocument> figure = figureIn(source);
  if (!figure)
    return std::nullopt;
  LoadedFigure loaded{figure->settings, {}};
  SourceOptions more = options;
  for (const FigurePanelDocument& panel : figure->panels) {
    loaded.panels.push_back(
        {panel.name, panel.plane, panel.planes, loadDocument(panel.scene, more, progress, NamedBy::picture)});
    LoadedScene& scene = loaded.panels.back().scene;
    if (!panel.plane && mayLookPast(scene, options)) // slices look from nowhere
      frameWhatIsPassed(scene, progress);
    // One that was turned by hand is another volume.
    if (panel.scene.orientation.empty())
      more.opened.emplace(scene.volumePath, scene.scene.volume);
  }
  return loaded;
}

// How another volume than a session's is told from its own.
static Message otherVolume(const std::optional<VolumeTraits>& own, const Volume& shown) {
  const glm::ivec3& now = shown.grid().dims;
  if (!own || own->voxels == now)
    return Message::tr("This may be another volume than the session's: its file has another name.");
  return Message::tr("This is another volume than the session's: %1 × %2 × %3 voxels in place of "
                     "%4 × %5 × %6.")
      .arg(now.x)
      .arg(now.y)
      .arg(now.z)
      .arg(own->voxels.x)
      .arg(own->voxels.y)
      .arg(own->voxels.z);
}

// Before all else that is said: the rest is judged by it.
static void noteOtherVolume(LoadedScene& loaded) {
  const std::optional<VolumeTraits>& own = loaded.session->traits;
  const Volume& shown = *loaded.scene.volume;
  if (own && !(own->isHounsfield && looksLikeHounsfield(shown)))
    loaded.notes.insert(
        loaded.notes.begin(),
        Message::tr("The session's values may mean other tissue here: not both volumes are in "
                    "Hounsfield units."));
  loaded.notes.insert(loaded.notes.begin(), otherVolume(own, shown));
}

LoadedScene loadScene(const std::string& source, const SourceOptions& options, const Progress& progress) {
  LoadedScene loaded = loadUnframed(source, options, progress);
  if (options.wantsVolumeAlone)
    return loaded;
  if (const Message remark = thickSlices(loaded.scene.volume->grid(), smoothsNormals(loaded.scene));
      !remark.empty())
    loaded.notes.push_back(remark);
  const ImageSettings& image = loaded.scene.image;
  if (mayLookPast(loaded, options))
    frameWhatIsPassed(loaded, progress);
  else if (!loaded.hasOwnCamera && !options.bringsView)
    loaded.scene.camera = framedCamera(loaded.scene, 1.0 * image.width / image.height,
                                       effortOf(progress, Message::tr("Finding what is visible")));
  if (loaded.session && loaded.isOfAnotherVolume)
    noteOtherVolume(loaded);
  return loaded;
}

} // namespace limn
