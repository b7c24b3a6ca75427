// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"
#include "scene/presets/Preset.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// What some formats leave to the volume that a look is for.
struct LookTarget {
  double low = 0.0;           ///< the volume's lowest and highest value, low < high
  double high = 1.0;          //
  double meanSpacingMm = 1.0; ///< mean of the three distances between voxels: the unit of VTK's gradients

  /// A DICOM series, with which looks for an archive are filed.
  struct Series {
    std::shared_ptr<const Volume> volume;
    std::filesystem::path path; ///< as readVolume took it
    int number = 1;             ///< as DicomFolder numbers it
  };
  std::optional<Series> series = {};
};

/// What a volume gives such formats; a constant one has a range of 1.
LookTarget lookTargetOf(const Volume& volume);

/// A look of a file as Limn shows it.
struct ReadLook {
  Preset preset;
  std::vector<Message> changes; ///< what was changed or lost on the way, a sentence each
};

/// A look as another program reads it.
struct WrittenLook {
  std::string text;
  std::vector<Message> changes; ///< what the format cannot hold, a sentence each
};

/// A family of files with looks in them. `read` and `write` throw Error (input); `name` is how sentences call
/// the file. Without a target, relative values stay so and gradients are taken for voxels of 1 mm, and a
/// sentence says how to have it otherwise (`--for VOLUME`).
struct LookFormat {
  Message name; ///< "3D Slicer volume property"
  std::vector<std::string>
      endings; ///< of files to write and to offer, ".vp.json"; the first is the usual one
  bool (*isMine)(std::string_view text); ///< told by content, never throws
  std::vector<ReadLook> (*read)(std::string_view text, const std::string& name,
                                const std::optional<LookTarget>&);
  WrittenLook (*write)(const Preset&, const std::optional<LookTarget>&); ///< null: only read
  bool isScene = false; ///< its files say what is seen from where, too: they are opened rather than imported
};

/// Every family, in the order in which a file is asked for its own.
const std::vector<LookFormat>& lookFormats();

/// The kind that is written under a file's name, by its ending in any case; null where none is.
const LookFormat* writtenLookFormat(const std::string& fileName);

/// The family that a text is of; null where none knows it. Never throws.
const LookFormat* lookFormatOf(std::string_view text);

/// What a look is called that has no name of its own: the file, without its folder and its ending. Of several
/// in a file, all but the first (`index` 0) have their number behind it.
std::string lookNameOf(const std::string& file, std::size_t index = 0);

/// The text in which a file keeps its looks: all of it, or what Limn wrote into a picture. Throws Error
/// (input) where it cannot be read, or is a picture that holds none.
std::string lookText(const std::filesystem::path& path);

/// Reads the looks in a text, at least one; a byte order mark before it is passed over. Throws Error (input)
/// where no family knows it, or where it is damaged, contradictory or empty.
std::vector<ReadLook> parseLooks(std::string_view text, const std::string& name,
                                 const std::optional<LookTarget>& target = {});

/// Reads the looks of a file. Throws Error (input).
std::vector<ReadLook> readLooks(const std::filesystem::path& path,
                                const std::optional<LookTarget>& target = {});

/// Throws Error (usage) where no family is written under the ending of `path`, with the endings that are.
void requireLookEnding(const std::filesystem::path& path);

/// Whether a text ends as files of some family do that hold looks alone, such as "bone.vp.json".
bool hasLookEnding(const std::string& fileName);

/// A look in the format that the ending of `path` asks for. Throws Error (usage) where no family is written
/// under that ending, with those that are.
WrittenLook lookAs(const std::filesystem::path& path, const Preset& preset,
                   const std::optional<LookTarget>& target = {});

} // namespace limn
