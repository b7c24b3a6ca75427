// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/Look.h"
#include "io/looks/families/Families.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"

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

} // namespace

LookFormat limnPresetFormat() {
  return {Message::tr("Limn preset"), {".json"}, isLimnPreset, readLimnPreset, writeLimnPreset};
}

const std::vector<LookFormat>& lookFormats() {
  static const std::vector<LookFormat> formats{
      limnPresetFormat(),   dicomFormat(),         slicerJsonFormat(),     weasisJsonFormat(),
      weasisMapsFormat(),   paraViewJsonFormat(),  niivueMapFormat(),      osirixPlistFormat(),
      mrmlFormat(),         mitkFunctionFormat(),  inviwoFunctionFormat(), voreenFunctionFormat(),
      mricroglClutFormat(), imageVisTableFormat(), slicerTextFormat()};
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
  failReading(
      name, Message::tr("it is no look that Limn knows"),
      Message::tr("open a preset of Limn or another program that `limn presets convert --help` lists"));
}

std::vector<ReadLook> readLooks(const std::filesystem::path& path, const std::optional<LookTarget>& target) {
  return parseLooks(readTextFile(path), path.filename().string(), target);
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
      if (name.size() > ending.size() && name.ends_with(ending))
        return true;
  return false;
}

WrittenLook lookAs(const std::filesystem::path& path, const Preset& preset,
                   const std::optional<LookTarget>& target) {
  requireLookEnding(path);
  return writtenLookFormat(path.filename().string())->write(preset, target);
}

} // namespace limn
