// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limn::test {

/// A text file of the project.
struct TextFile {
  std::filesystem::path path; ///< relative to the root
  std::string text;
};

/// The project's root.
std::filesystem::path projectRoot();

/// The files of the project whose names end in one of `extensions` (".md"), sorted by path; what is built is
/// no part of it.
std::vector<TextFile> filesEnding(const std::vector<std::string>& extensions);

/// The same file read alone; `path` is relative to the root.
TextFile fileAt(const std::filesystem::path& path);

/// Whether some file of the project has this name, whatever its folder.
bool isNameOfAFile(const std::string& name);

} // namespace limn::test
