// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <filesystem>
#include <optional>
#include <string>

namespace limn {

struct SourceOptions;

/// What names a volume and says how it is shown.
enum class NamedBy { scene, session, picture, look };

/// A scene, session, picture or look was read, but its volume is not where it says.
class VolumeMissing : public Error {
public:
  /// `expected` is where the file or folder should be.
  VolumeMissing(const std::filesystem::path& expected, NamedBy by, const Message& sentence)
      : Error(Error::Kind::input, sentence), m_expected(expected), m_by(by) {}

  const std::filesystem::path& expected() const { return m_expected; }
  NamedBy by() const { return m_by; }

private:
  std::filesystem::path m_expected;
  NamedBy m_by;
};

/// A scene, session or picture was read, but a file of its labels is not where it says or cannot be shown
/// with its volume.
class LabelsMissing : public Error {
public:
  /// `expected` is where the scene says the file is, also where another was told in its place.
  LabelsMissing(const std::filesystem::path& expected, const Message& sentence)
      : Error(Error::Kind::input, sentence), m_expected(expected) {}

  const std::filesystem::path& expected() const { return m_expected; }

private:
  std::filesystem::path m_expected;
};

/// Where a scene's volume is now: as told, as the scene says, built in, or known under the same name. Throws
/// VolumeMissing.
std::string volumeOf(const SceneDocument& document, const SourceOptions& options, NamedBy by);

/// Where a scene's label map is now: as told, as the scene says, referred to, or beside the volume or others.
/// Throws LabelsMissing.
std::string labelsOf(const std::string& written, const std::string& volume, const SourceOptions& options);

/// The CT head that Debian's invesalius-examples installs, where it is installed.
std::optional<std::filesystem::path> installedSampleHead();

} // namespace limn
