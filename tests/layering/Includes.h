// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/Places.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace limn::test {

/// A line #include of a source.
struct Include {
  std::filesystem::path file; ///< relative to the root
  std::string header;         ///< as written
};

inline const std::filesystem::path sourceRoot = sourceFolder();

/// Every include of the sources below a folder, which is relative to the root.
inline std::vector<Include> includesBelow(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  static const std::regex include(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(sourceRoot / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp" && extension != ".inl")
      continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (std::regex_search(line, match, include))
        found.push_back({fs::relative(entry.path(), sourceRoot), match[1]});
    }
  }
  return found;
}

} // namespace limn::test
