// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace limn {

/// The names of the slices of a folder, to tell a lost slice by its name from a foreign file.
class NameLikeness {
public:
  /// Adds the name of a slice.
  void add(const std::filesystem::path& slice);

  /// Whether a file is called as a slice is: the same letters around other numbers, or the same ending (one
  /// of letters). Hidden files never are, because systems leave such beside the files they copy.
  bool isLike(const std::filesystem::path& file) const;

private:
  std::set<std::string> m_patterns;
  std::set<std::string> m_endings;
};

} // namespace limn
