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
    int number = 1;             ///< as listSeries numbers it there
  };
  std::optional<Series> series = {};
};

/// A look of another program as Limn shows it.
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
/// the file. Without a target, what needs one is refused with what to do (`--for VOLUME`).
struct LookFormat {
  const char* name; ///< "3D Slicer volume property"
  std::vector<std::string>
      endings; ///< of files to write and to offer, ".vp.json"; the first is the usual one
  bool (*isMine)(std::string_view text); ///< told by content, never throws
  std::vector<ReadLook> (*read)(std::string_view text, const std::string& name,
                                const std::optional<LookTarget>&);
  WrittenLook (*write)(const Preset&, const std::optional<LookTarget>&); ///< null: only read
};

/// Every family, in the order in which a file is asked for its own.
const std::vector<LookFormat>& lookFormats();

/// Reads the looks in a text, at least one. Throws Error (input) where no family knows it, or where it is
/// damaged, contradictory or empty.
std::vector<ReadLook> parseLooks(std::string_view text, const std::string& name,
                                 const std::optional<LookTarget>& target = {});

/// Reads the looks of a file. Throws Error (input).
std::vector<ReadLook> readLooks(const std::filesystem::path& path,
                                const std::optional<LookTarget>& target = {});

/// A look in the format that the ending of `path` asks for. Throws Error (usage) where no family is written
/// under that ending, with those that are.
WrittenLook lookAs(const std::filesystem::path& path, const Preset& preset,
                   const std::optional<LookTarget>& target = {});

} // namespace limn
