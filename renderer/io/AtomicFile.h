// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace limn {

/// Where a file lies: where somebody chose, or where the program keeps it, which nobody can choose; there it
/// may be such that only this user may read it.
enum class FilePlace { chosen, fixed, fixedPrivate };

/// Replaces `target` by what `write` puts into the temporary file it is given: a new name in the same folder
/// with the same ending. The target is complete or untouched: on any failure the temporary file is removed,
/// and what processes left that were killed while they wrote is removed at the next writing into that folder.
/// Throws Error, and whatever `write` throws.
void replaceAtomically(const std::filesystem::path& target,
                       const std::function<void(const std::filesystem::path& temporary)>& write,
                       FilePlace place = FilePlace::chosen);

/// Throws the Error that writing `target` would end with: the folder is missing or takes no files, or the
/// name is a folder's. It is tried with an empty file, which is removed again; to be asked before long work,
/// not in the place of the other functions.
void requireWritable(const std::filesystem::path& target);

/// Whether a file is, by its name, one that is being written or was when its process ended.
bool isTemporary(const std::filesystem::path& file);

/// Replaces `target` by a file of these bytes; complete or untouched. Throws Error.
void writeFileAtomically(const std::filesystem::path& target, std::string_view bytes,
                         FilePlace place = FilePlace::chosen);

/// Makes a folder, and those above it that are missing; an empty path is the current folder. Why that fails,
/// in words within a sentence; empty where the folder is there.
Message makeFolders(const std::filesystem::path& folder);

/// A folder for files of the moment, which goes with all that is in it.
class ScratchFolder {
public:
  /// Below the system's folder for temporary files, or in `parent` as a hidden one. Throws Error whose
  /// sentence is the reason alone.
  explicit ScratchFolder(const std::filesystem::path& parent = {});
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

} // namespace limn
