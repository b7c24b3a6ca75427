// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DicomLook.h"
#include "io/looks/dicom/DicomObjects.h"
#include "io/looks/dicom/Losses.h"
#include "io/looks/families/Families.h"
#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

// A state has no modality of its own; the classes of its images tell (PS3.4 B.5).
std::string modalityOf(const DicomLook& look) {
  const std::string& kind = look.images.front().sopClass;
  const auto isOneOf = [&](std::initializer_list<const char*> classes) {
    return std::ranges::any_of(
        classes, [&](const char* end) { return kind == std::string("1.2.840.10008.5.1.4.1.1.") + end; });
  };
  if (isOneOf({"2", "2.1", "2.2"}))
    return "CT";
  if (isOneOf({"4", "4.1", "4.3", "4.4"}))
    return "MR";
  if (isOneOf({"128", "130", "128.1"}))
    return "PT";
  return "OT";
}

// Curve and light alone: camera, crop and projection belong to the picture.
std::vector<ReadLook> readDicomState(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>&) {
  const DicomLook look = parseDicomLook(text, name);
  Preset preset;
  preset.name = std::filesystem::path(name).stem().string();
  preset.modality = modalityOf(look);
  preset.transferFunction = look.own ? look.own->scene.transferFunction : look.transferFunction;
  preset.shading = look.own ? look.own->scene.shading : look.shading;
  if (look.own)
    preset.gradientOpacity = look.own->scene.gradientOpacity;
  return {{preset, look.changes}};
}

// Curve and light alone make no state: it is seen from the front, and filed with a series.
WrittenLook writeDicomState(const Preset& preset, const std::optional<LookTarget>& target) {
  const auto refuse = [] {
    throw Error(Error::Kind::usage, Message::tr("A DICOM look is filed with the series that it is for; name "
                                                "the folder of one (--for FOLDER)."));
  };
  if (!target || !target->series || target->series->volume->info().format != "DICOM")
    refuse();
  const LookTarget::Series& series = *target->series;
  const auto dicom = openDicom(series.path, {});
  const std::vector<SeriesImages> all = dicom ? dicom->images() : std::vector<SeriesImages>();
  if (series.number < 1 || static_cast<std::size_t>(series.number) > all.size())
    refuse();
  Scene scene;
  scene.volume = series.volume;
  scene.camera = defaultCamera(series.volume->grid());
  scene = withPreset(scene, preset);
  return {dicomLookOf(scene, all[static_cast<std::size_t>(series.number - 1)], LIMN_VERSION),
          lossesOf(scene)};
}

} // namespace

LookFormat dicomFormat() {
  return {Message::tr("DICOM presentation state of a volume"),
          {".dcm"},
          isDicomLook,
          readDicomState,
          writeDicomState,
          true};
}

} // namespace limn
