// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneFile.h"
#include "io/scenefile/SceneJson.h"

#include "scene/Error.h"

#include <fstream>

namespace limn {

nlohmann::json parsedJson(std::string_view text, const std::string& name) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(Error::Kind::input, name + " is not valid JSON (the mistake is near byte " +
                                        std::to_string(error.byte) +
                                        "); open it in a text editor to repair it.");
  } catch (const nlohmann::json::out_of_range&) {
    throw Error(Error::Kind::input,
                name + " holds a number too large to be one; open it in a text editor to repair it.");
  }
}

void requireVersion(JsonFields& fields, const std::string& key, const std::string& what) {
  int version = 0;
  if (!fields.integer(key, version, 1, 1000000))
    fields.fail(key, "is missing, so this is not a Limn " + what);
  if (version != 1)
    fields.fail(key,
                "is " + std::to_string(version) + "; this Limn reads version 1, a newer one may read it");
}

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
