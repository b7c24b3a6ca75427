// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/Look.h"
#include "io/looks/dicom/DicomLook.h"
#include "io/looks/dicom/DicomObjects.h"
#include "io/looks/dicom/Losses.h"
#include "io/looks/families/Families.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"

#include <algorithm>

namespace limn {
namespace {

bool isLimnPreset(std::string_view text) {
  return text.find("\"limn_preset\"") != std::string_view::npos;
}

std::vector<ReadLook> readLimnPreset(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>&) {
  return {{parsePreset(text, name), {}}};
}

WrittenLook writeLimnPreset(const Preset& preset, const std::optional<LookTarget>&) {
  return {presetToJson(preset), {}};
}

// The longest ending of a family that a file's name has.
std::size_t endingLength(const std::string& fileName) {
  std::size_t longest = std::filesystem::path(fileName).extension().string().size();
  for (const LookFormat& format : lookFormats())
    for (const std::string& ending : format.endings)
      if (ending.size() > longest && fileName.size() > ending.size() && lowerCase(fileName).ends_with(ending))
        longest = ending.size();
  return longest;
}

std::string_view withoutMark(std::string_view text) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  return text.starts_with(byteOrderMark) ? text.substr(byteOrderMark.size()) : text;
}

std::string writtenEndings() {
  std::string list;
  for (const LookFormat& format : lookFormats())
    if (format.write)
      for (const std::string& ending : format.endings)
        list += (list.empty() ? "" : " ") + ending;
  return list;
}

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

LookFormat limnPresetFormat() {
  return {Message::tr("Limn preset"), {".json"}, isLimnPreset, readLimnPreset, writeLimnPreset};
}

const std::vector<LookFormat>& lookFormats() {
  static const std::vector<LookFormat> formats{
      limnSceneFormat(),      limnPresetFormat(),   dicomFormat(),         slicerJsonFormat(),
      weasisJsonFormat(),     weasisMapsFormat(),   paraViewJsonFormat(),  niivueMapFormat(),
      osirixPlistFormat(),    mrmlFormat(),         mitkFunctionFormat(),  inviwoFunctionFormat(),
      voreenFunctionFormat(), mricroglClutFormat(), imageVisTableFormat(), slicerTextFormat()};
  return formats;
}

LookTarget lookTargetOf(const Volume& volume) {
  const ValueRange& range = volume.range();
  const glm::dvec3& spacing = volume.grid().spacingMm;
  return {range.lowest, range.highest > range.lowest ? range.highest : range.lowest + 1.0,
          (spacing.x + spacing.y + spacing.z) / 3.0};
}

std::string lookNameOf(const std::string& file, std::size_t index) {
  const std::string whole = std::filesystem::path(file).filename().string();
  const std::string name = plainText(whole.substr(0, whole.size() - endingLength(whole)), 200);
  return index == 0 ? name : name + " " + std::to_string(index + 1);
}

const LookFormat* lookFormatOf(std::string_view text) {
  text = withoutMark(text);
  for (const LookFormat& format : lookFormats())
    if (format.isMine(text))
      return &format;
  return nullptr;
}

std::vector<ReadLook> parseLooks(std::string_view text, const std::string& name,
                                 const std::optional<LookTarget>& target) {
  if (const LookFormat* format = lookFormatOf(text))
    return format->read(withoutMark(text), name, target);
  failReading(name, Message::tr("it is no look that Limn knows"),
              Message::tr("choose a preset or picture of Limn, or a look that 3D Slicer, OsiriX, Horos, "
                          "InVesalius, ParaView, "
                          "Weasis, MITK, Inviwo, Voreen, MRIcroGL, NiiVue or ImageVis3D saved"));
}

std::vector<ReadLook> readLooks(const std::filesystem::path& path, const std::optional<LookTarget>& target) {
  return parseLooks(lookText(path), path.filename().string(), target);
}

// The longest ending wins (".vp.json" before ".json").
const LookFormat* writtenLookFormat(const std::string& fileName) {
  const std::string name = lowerCase(fileName);
  const LookFormat* found = nullptr;
  std::size_t longest = 0;
  for (const LookFormat& format : lookFormats())
    for (const std::string& ending : format.endings)
      if (format.write && ending.size() > longest && name.size() > ending.size() && name.ends_with(ending)) {
        found = &format;
        longest = ending.size();
      }
  return found;
}

void requireLookEnding(const std::filesystem::path& path) {
  if (!writtenLookFormat(path.filename().string()))
    throw Error(Error::Kind::usage,
                Message::tr("The ending of %1 names no kind of look that Limn writes; these do: %2.")
                    .arg(path.filename().string(), writtenEndings()));
}

bool hasLookEnding(const std::string& fileName) {
  const std::string name = lowerCase(fileName);
  for (const LookFormat& format : lookFormats())
    for (const std::string& ending : format.endings)
      if (!format.isScene && name.size() > ending.size() && name.ends_with(ending))
        return true;
  return false;
}

WrittenLook lookAs(const std::filesystem::path& path, const Preset& preset,
                   const std::optional<LookTarget>& target) {
  requireLookEnding(path);
  return writtenLookFormat(path.filename().string())->write(preset, target);
}

LookFormat dicomFormat() {
  return {Message::tr("DICOM presentation state of a volume"),
          {".dcm"},
          isDicomLook,
          readDicomState,
          writeDicomState,
          true};
}

} // namespace limn
