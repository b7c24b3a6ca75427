// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/Look.h"

#include "io/looks/Families.h"
#include "io/reading/ReadError.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

std::string lower(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z')
      letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

/// The family written under a file's ending; the longest ending wins (".vp.json" before ".json").
const LookFormat* writtenAs(const std::string& fileName) {
  const LookFormat* found = nullptr;
  std::size_t longest = 0;
  for (const LookFormat& format : lookFormats())
    for (const std::string& ending : format.endings)
      if (format.write && ending.size() > longest && fileName.size() > ending.size() &&
          fileName.ends_with(ending)) {
        found = &format;
        longest = ending.size();
      }
  return found;
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

const std::vector<LookFormat>& lookFormats() {
  static const std::vector<LookFormat> formats{limnPresetFormat(), dicomFormat()};
  return formats;
}

std::vector<ReadLook> parseLooks(std::string_view text, const std::string& name,
                                 const std::optional<LookTarget>& target) {
  for (const LookFormat& format : lookFormats())
    if (format.isMine(text))
      return format.read(text, name, target);
  failReading(
      name, Message::tr("it is no look that Limn knows"),
      Message::tr("open a preset of Limn or another program that `limn presets convert --help` lists"));
}

std::vector<ReadLook> readLooks(const std::filesystem::path& path, const std::optional<LookTarget>& target) {
  return parseLooks(readTextFile(path), path.string(), target);
}

WrittenLook lookAs(const std::filesystem::path& path, const Preset& preset,
                   const std::optional<LookTarget>& target) {
  if (const LookFormat* format = writtenAs(lower(path.filename().string())))
    return format->write(preset, target);
  throw Error(Error::Kind::usage,
              Message::tr("The ending of %1 names no kind of look that Limn writes; these do: %2.")
                  .arg(path.filename().string())
                  .arg(writtenEndings()));
}

} // namespace limn
