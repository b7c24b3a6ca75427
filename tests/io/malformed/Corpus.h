// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace limn::test {

/// How reading may end without doing harm.
enum class Outcome {
  correct, ///< the good volume, with no more warnings than the sound files of the format have
  warned,  ///< a volume with a warning of its own
  refused, ///< one sentence
};

using Outcomes = std::set<Outcome>;

/// What a cut, or a change that no reader can see, may lead to: anything but another volume without a word.
inline const Outcomes anyOutcome = {Outcome::correct, Outcome::warned, Outcome::refused};

/// One thing to open, and what must come of it.
struct MalformedInput {
  std::string flaw; ///< its class, e.g. "truncated"; "sound" where there is none
  std::filesystem::path path;
  Outcomes allowed;
  std::string says;              ///< part of the refusal or of a warning
  bool hasGoodDimensions = true; ///< a volume that comes of it is 2 × 3 × 4
  bool hasGoodVoxels = true;     ///< its voxels have the values 0 … 23 in order
  std::uint64_t heldBytes = 0;   ///< what the file truly decodes to where that is no volume

  /// A volume that comes of it is not the good one.
  void becomesAnother() { hasGoodDimensions = hasGoodVoxels = false; }
};

/// Collects the inputs of one format, each in a folder of its own.
class Corpus {
public:
  explicit Corpus(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  /// A fresh folder for the files of one input.
  std::filesystem::path newFolder();

  /// Adds what lies at `path`.
  MalformedInput& add(const std::string& flaw, const std::filesystem::path& path, const Outcomes& allowed,
                      const std::string& says = "");

  /// Writes one file and adds it.
  MalformedInput& addFile(const std::string& flaw, const std::string& name, const std::string& bytes,
                          const Outcomes& allowed, const std::string& says = "");

  /// A file that is as it should be: what the format always warns of, and a start for mutations.
  MalformedInput& addSound(const std::string& name, const std::string& bytes) {
    return addFile("sound", name, bytes, {Outcome::correct});
  }

  /// Cuts a file off at up to `places` places over its length. Cuts before `complete` must be refused; behind
  /// it all voxels are there.
  void addCuts(const std::string& name, const std::string& bytes, std::size_t complete,
               std::size_t places = 40);

  const std::vector<MalformedInput>& inputs() const { return m_inputs; }

private:
  std::filesystem::path m_folder;
  std::vector<MalformedInput> m_inputs;
};

/// A format and how its inputs are made.
struct Format {
  const char* name;
  void (*addInputs)(Corpus& corpus);
};

/// How a test names a format.
inline void PrintTo(const Format& format, std::ostream* out) {
  *out << format.name;
}

/// Every format, in the order of the table.
const std::vector<Format>& formats();

void addNiftiInputs(Corpus& corpus);
void addNrrdInputs(Corpus& corpus);
void addMetaImageInputs(Corpus& corpus);
void addVtkLegacyInputs(Corpus& corpus);
void addVtkXmlInputs(Corpus& corpus);
void addTiffInputs(Corpus& corpus);
void addPngInputs(Corpus& corpus);
void addJpegInputs(Corpus& corpus);
void addDicomFileInputs(Corpus& corpus);
void addDicomSeriesInputs(Corpus& corpus);
void addCompressedDicomInputs(Corpus& corpus);
void addInVesaliusInputs(Corpus& corpus);
void addOtherInputs(Corpus& corpus);
void addOddDicomInputs(Corpus& corpus);

} // namespace limn::test
