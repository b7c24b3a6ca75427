// SPDX-License-Identifier: GPL-3.0-or-later
#include "documentation/Tree.h"
#include "support/Places.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

const char* const folders[] = {"app", "renderer", "shaders", "tests", "widgets"};

// Every file below the folders of the project, and those that lie in its root.
const std::vector<fs::path>& paths() {
  static const std::vector<fs::path> all = [] {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(projectRoot()))
      if (entry.is_regular_file())
        found.push_back(entry.path().filename());
    for (const char* folder : folders)
      for (const auto& entry : fs::recursive_directory_iterator(projectRoot() / folder))
        if (entry.is_regular_file())
          found.push_back(fs::relative(entry.path(), projectRoot()));
    std::sort(found.begin(), found.end());
    return found;
  }();
  return all;
}

} // namespace

fs::path projectRoot() {
  return sourceFolder();
}

TextFile fileAt(const fs::path& path) {
  std::ifstream stream(projectRoot() / path, std::ios::binary);
  return {path, std::string(std::istreambuf_iterator<char>(stream), {})};
}

std::vector<TextFile> filesEnding(const std::vector<std::string>& extensions) {
  std::vector<TextFile> files;
  for (const fs::path& path : paths())
    if (std::find(extensions.begin(), extensions.end(), path.extension().string()) != extensions.end())
      files.push_back(fileAt(path));
  return files;
}

bool isNameOfAFile(const std::string& name) {
  static const std::set<std::string> names = [] {
    std::set<std::string> all;
    for (const fs::path& path : paths())
      all.insert(path.filename().string());
    return all;
  }();
  return names.contains(name);
}

} // namespace limn::test
