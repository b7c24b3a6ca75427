// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Descriptor.h"

#include <filesystem>
#include <optional>

namespace limn {

/// An exclusive lock by means of a file, among windows and processes. The kernel keeps it (flock) and lets go
/// when the object or its process ends, however it ends: no lock is ever stale, no process number is guessed
/// at. The file itself stays.
class FileLock {
public:
  /// Waits until it is free. Throws Error where the file cannot be made.
  static FileLock waitFor(const std::filesystem::path& file);

  /// Absent where somebody else holds it. Throws Error where the file cannot be made.
  static std::optional<FileLock> tryFor(const std::filesystem::path& file);

private:
  explicit FileLock(Descriptor file) : m_file(std::move(file)) {}
  Descriptor m_file;
};

} // namespace limn
