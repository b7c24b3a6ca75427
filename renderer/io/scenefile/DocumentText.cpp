// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneFile.h"

#include "io/reading/ReadError.h"

#include <fstream>

namespace limn {

std::string readTextFile(const std::filesystem::path& path, std::size_t limit) {
  // Settings and scenes may lie where only their owner looks: the name says enough.
  const std::filesystem::path name = path.filename();
  std::error_code failed;
  const auto size = std::filesystem::file_size(path, failed);
  if (failed)
    failReading(name, Message::tr("there is no such file"), Message::tr("check the path"));
  if (size > limit)
    failReading(name, Message::tr("it is far larger than any file of this kind"),
                Message::tr("choose another file"));
  std::ifstream file(path, std::ios::binary);
  std::string text(size, '\0');
  if (!file.read(text.data(), static_cast<std::streamsize>(size)))
    failReading(name, Message::tr("it cannot be opened"), Message::tr("check that you may read it"));
  return text;
}

} // namespace limn
