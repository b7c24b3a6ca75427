// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DicomLook.h"
#include "io/looks/dicom/DisplayModule.h"
#include "io/looks/dicom/GeometryModule.h"
#include "io/looks/dicom/ObjectBytes.h"
#include "io/looks/dicom/OwnBlock.h"
#include "io/looks/dicom/References.h"
#include "io/reading/ReadError.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace limn {
namespace {

std::size_t countHeld(const std::set<std::string>& wanted, const SeriesImages& series) {
  std::set<std::string> held;
  for (const DicomReference& image : series.images)
    if (wanted.contains(image.sopInstance))
      held.insert(image.sopInstance);
  return held.size();
}

// Of a look of several phases one is shown: the others have to be there all the same.
std::size_t countMissing(const std::set<std::string>& wanted, const SeriesImages& series) {
  std::set<std::string> there(series.leftOut.begin(), series.leftOut.end());
  for (const DicomReference& image : series.images)
    there.insert(image.sopInstance);
  return static_cast<std::size_t>(
      std::ranges::count_if(wanted, [&](const std::string& image) { return !there.contains(image); }));
}

std::set<std::string> instancesOf(const DicomLook& look) {
  std::set<std::string> instances;
  for (const DicomReference& image : look.images)
    instances.insert(image.sopInstance);
  return instances;
}

using namespace dicom;

constexpr std::string_view stateClasses = "1.2.840.10008.5.1.4.1.1.11.";
constexpr std::size_t classIsWithin = 1024; // bytes from the start
constexpr std::size_t largestLook = std::size_t{16} << 20;

void requireDrawable(DcmItem& object, const std::string& name) {
  const std::string kind = textIn(object, DCM_SOPClassUID);
  const Message oneVolume = Message::tr("export a look of one volume");
  if (kind == UID_VolumeRenderingVolumetricPresentationStateStorage)
    return;
  if (kind == UID_SegmentedVolumeRenderingVolumetricPresentationStateStorage)
    failReading(name, Message::tr("it shows a segmented volume, whose parts Limn cannot colour separately"),
                oneVolume);
  if (kind == UID_MultipleVolumeRenderingVolumetricPresentationStateStorage)
    failReading(name, Message::tr("it shows several volumes together, which Limn cannot draw"), oneVolume);
  if (kind == UID_GrayscalePlanarMPRVolumetricPresentationStateStorage ||
      kind == UID_CompositingPlanarMPRVolumetricPresentationStateStorage)
    failReading(name, Message::tr("it shows reformatted slices, not a volume"), oneVolume);
  failReading(name, Message::tr("it is no presentation state of a volume"), oneVolume);
}

// What a look may hold beside the picture, and Limn leaves out.
void noteLeftOut(DcmItem& object, std::vector<Message>& changes) {
  if (holds(object, DCM_PresentationAnimationStyle))
    changes.push_back(
        Message::tr("The animation (%1) is not played.").arg(textIn(object, DCM_PresentationAnimationStyle)));
  if (!itemsIn(object, DCM_VolumetricAnnotationSequence).empty())
    changes.push_back(Message::tr("The annotations in the volume are not shown."));
  if (!itemsIn(object, DCM_GraphicAnnotationSequence).empty())
    changes.push_back(Message::tr("The annotations on the picture are not shown."));
}

void readStep(DicomLook& look, const ColourTable& table) {
  constexpr double unitWithoutStepMm = 1.0;
  if (!look.stepMm)
    look.changes.push_back(Message::tr(
        "It does not say over which length its opacities hold (Sampling Step Size); they hold over 1 mm."));
  look.transferFunction = functionOf(table, look.stepMm.value_or(unitWithoutStepMm));
}

// A look clips what lies before and behind; Limn draws it.
void noteClipping(const DicomLook& look, const Grid& grid, std::vector<Message>& changes) {
  const ValueRange depths = depthsOf(look.camera, grid);
  const double tiny = 1e-3 * boxDiagonalMm(grid);
  if (look.nearMm > std::max(depths.lowest, 0.0) + tiny)
    changes.push_back(Message::tr("What the near plane cuts away is shown."));
  if (look.farMm < depths.highest - tiny)
    changes.push_back(Message::tr("What the far plane cuts away is shown."));
}

ImageSettings imageOf(double aspect) {
  ImageSettings image;
  constexpr double widest = 8.0; // a shape beyond is no picture
  const double shape = std::clamp(aspect, 1.0 / widest, widest);
  (shape >= 1.0 ? image.width : image.height) =
      static_cast<int>(std::lround(512.0 * std::max(shape, 1.0 / shape)));
  return image;
}

} // namespace

const SeriesImages& seriesOf(const DicomLook& look, const std::vector<SeriesImages>& all,
                             const std::string& name, const std::filesystem::path& folder) {
  const std::set<std::string> wanted = instancesOf(look);
  const auto best = std::ranges::max_element(
      all, {}, [&](const SeriesImages& series) { return countHeld(wanted, series); });
  const std::size_t held = best == all.end() ? 0 : countHeld(wanted, *best);
  const std::string place = folder.filename().string();
  if (held == 0)
    failReading(
        name,
        Message::tr("it belongs to another series: none of its %1 images is in %2").arg(wanted.size(), place),
        Message::tr("name the folder of its series (--volume PATH)"));
  if (const std::size_t missing = countMissing(wanted, *best); missing > 0)
    failReading(name,
                Message::tr("%1 of the %2 images that it belongs to are missing in %3")
                    .arg(missing, wanted.size(), place),
                Message::tr("fetch the whole series again"));
  return *best;
}

bool belongsToOne(const DicomLook& look, const std::vector<SeriesImages>& all) {
  const std::set<std::string> wanted = instancesOf(look);
  return std::ranges::any_of(all,
                             [&](const SeriesImages& series) { return countMissing(wanted, series) == 0; });
}

bool isDicomLook(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, classIsWithin);
  return start.size() > 132 && start.substr(128, 4) == "DICM" &&
         start.find(stateClasses) != std::string_view::npos;
}

bool isDicomLookFile(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
    return false;
  std::string start(classIsWithin, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return isDicomLook(start);
}

DicomLook parseDicomLook(std::string_view bytes, const std::string& name) {
  const auto state = objectIn(bytes, name);
  DcmItem& object = *state;
  requireDrawable(object, name);
  DicomLook look;
  look.study = textIn(object, DCM_StudyInstanceUID);
  DcmItem& input = inputIn(object, name);
  look.images = dicom::imagesIn(object, input, name);
  const Geometry geometry = geometryIn(object, name, look.changes);
  look.camera = geometry.camera;
  look.aspect = geometry.aspect;
  look.nearMm = geometry.nearMm;
  look.farMm = geometry.farMm;
  look.projection = geometry.projection;
  look.stepMm = geometry.stepMm;
  look.shading = shadingIn(object, name, look.changes);
  look.cropsMm = cropsIn(object, input, name, look.changes);
  readStep(look, displayIn(object, input, name, look.changes));
  noteLeftOut(object, look.changes);
  look.own = ownBlockIn(object, name, look.changes);
  return look;
}

DicomLook readDicomLook(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return parseDicomLook(readTextFile(file, largestLook), name);
}

SceneDocument sceneOf(const DicomLook& look, const Grid& grid, std::vector<Message>& changes) {
  if (look.own)
    return *look.own;
  SceneDocument document;
  document.hasCamera = true;
  document.hasTransferFunction = true;
  Scene& scene = document.scene;
  scene.camera = look.camera;
  scene.transferFunction = look.transferFunction;
  scene.shading = look.shading;
  scene.projection = look.projection;
  scene.image = imageOf(look.aspect);
  if (look.stepMm)
    scene.quality.stepVoxels = std::clamp(*look.stepMm / smallestSpacingMm(grid), 1e-3, 1e4);
  if (const auto crop = cropWithin(look.cropsMm, grid))
    scene.crop = *crop;
  else
    changes.push_back(Message::tr("The crop leaves nothing of the volume; all of it is shown."));
  noteClipping(look, grid, changes);
  return document;
}

} // namespace limn
