// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneFile.h"

#include "scene/Error.h"

#include <fstream>

namespace limn {

std::string readTextFile(const std::filesystem::path& path, std::size_t limit) {
  const auto refuse = [&](const std::string& why) {
    throw Error(Error::Kind::input, "Cannot read " + path.filename().string() + ": " + why);
  };
  std::error_code failed;
  const auto size = std::filesystem::file_size(path, failed);
  if (failed)
    refuse("there is no such file; check the path.");
  if (size > limit)
    refuse("it is far larger than any file of this kind; choose another file.");
  std::ifstream file(path, std::ios::binary);
  std::string text(size, '\0');
  if (!file.read(text.data(), static_cast<std::streamsize>(size)))
    refuse("it cannot be opened; check that you may read it.");
  return text;
}

} // namespace limn
