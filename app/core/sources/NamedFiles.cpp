// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/NamedFiles.h"

#include "app/core/sources/SceneSource.h"

#include <set>

namespace limn {
namespace {

namespace fs = std::filesystem;

// Each sentence is whole, because its words agree differently in other languages.
Message missingVolume(NamedBy by) {
  if (by == NamedBy::session)
    return Message::tr("The session's volume %1 is not where the session expects it (%2); say where it is "
                       "(--volume PATH).");
  if (by == NamedBy::picture)
    return Message::tr("The volume %1 of this picture is not where the picture expects it (%2); say where "
                       "it is (--volume PATH).");
  return Message::tr("The scene's volume %1 is not where the scene expects it (%2); say where it is "
                     "(--volume PATH).");
}

} // namespace

std::optional<std::filesystem::path> installedSampleHead() {
  const fs::path head = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  return fs::exists(head) ? std::optional(head) : std::nullopt;
}

std::string volumeOf(const SceneDocument& document, const SourceOptions& options, NamedBy by) {
  if (options.volume)
    return options.volume->string();
  if (std::filesystem::exists(document.volume))
    return document.volume;
  // Built-in volumes are named without a folder; reading made the name absolute.
  std::string name = std::filesystem::path(document.volume).filename().string();
  if (name == "phantom" || name == "sample" || name.starts_with("phantom:"))
    return name;
  if (const auto referred = options.references.find(name); referred != options.references.end())
    if (std::filesystem::exists(referred->second))
      return referred->second.string();
  if (const auto head = installedSampleHead(); head && head->filename() == name)
    return head->string(); // as `sample` was called when the scene was written
  std::set<std::filesystem::path> found;
  for (const std::filesystem::path& known : options.knownVolumes)
    if (known.filename() == name && std::filesystem::exists(known))
      found.insert(known);
  if (found.size() == 1)
    return found.begin()->string();
  throw VolumeMissing(document.volume, by, missingVolume(by).arg(name).arg(document.volume));
}

std::string labelsOf(const std::string& written, const std::string& volume, const SourceOptions& options) {
  std::error_code unknown;
  const std::filesystem::path name = std::filesystem::path(written).filename();
  if (const auto told = options.labels.find(written); told != options.labels.end())
    return told->second.string();
  if (written.empty() || std::filesystem::exists(written, unknown))
    return written;
  const auto referred = options.references.find(name.string());
  const std::filesystem::path expected =
      referred != options.references.end() ? referred->second : std::filesystem::path(written);
  if (std::filesystem::exists(expected, unknown))
    return expected.string();
  // Volume and labels may have one name, in folders of their own.
  const auto isThere = [&](const std::filesystem::path& file) {
    return std::filesystem::exists(file, unknown) && !std::filesystem::equivalent(file, volume, unknown);
  };
  if (const std::filesystem::path beside = std::filesystem::path(volume).parent_path() / expected.filename();
      isThere(beside))
    return beside.string();
  for (const auto& [said, told] : options.labels)
    if (const std::filesystem::path other = told.parent_path() / expected.filename(); isThere(other))
      return other.string();
  throw LabelsMissing(written,
                      Message::tr("The labels %1 are not where they are expected (%2); put them there "
                                  "or beside the volume.")
                          .arg(expected.filename().string())
                          .arg(expected.string()));
}

} // namespace limn
