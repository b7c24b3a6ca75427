// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the inputs of a format and judges how each attempt ended.
#include "Attempt.h"

#include "support/TemporaryFolder.h"

#include <algorithm>

#include <malloc.h>

namespace limn::test {
namespace {

// What a reader may take beside twice the decoded volume and what its libraries take for a sound file:
// buffers of reading (1 MiB each) and of headers (64 MiB of DICOM attributes would be a refusal).
constexpr std::uint64_t slackBytes = std::uint64_t{24} << 20;

// What the sound files of a format show.
struct Standing {
  std::set<std::string> warnings;
  std::uint64_t peakBytes = 0;
};

const char* nameOf(Outcome outcome) {
  return outcome == Outcome::correct ? "correct" : outcome == Outcome::warned ? "warned" : "refused";
}

Outcome outcomeOf(const Attempt& attempt, const Standing& standing) {
  if (!attempt.isVolume)
    return Outcome::refused;
  const bool saysMore = std::any_of(attempt.warnings.begin(), attempt.warnings.end(),
                                    [&](const auto& w) { return !standing.warnings.contains(w); });
  return saysMore ? Outcome::warned : Outcome::correct;
}

// Whether the sentence names what was opened, a file inside it, or one that belongs to it.
bool names(const std::string& sentence, const std::filesystem::path& path) {
  const auto isNamed = [&](const std::filesystem::path& file) {
    std::string name = file.filename().string();
    std::replace(name.begin(), name.end(), '\n', '?');
    return sentence.find(name) != std::string::npos;
  };
  if (isNamed(path))
    return true;
  std::error_code problem;
  const bool isFolder = std::filesystem::is_directory(path, problem);
  if (path.string().find("limn-test") != std::string::npos)
    for (const auto& entry :
         std::filesystem::directory_iterator(isFolder ? path : path.parent_path(), problem))
      if (isNamed(entry.path()))
        return true;
  return false;
}

bool isSaid(const Attempt& attempt, const std::string& text) {
  const auto holds = [&](const std::string& said) { return said.find(text) != std::string::npos; };
  return holds(attempt.refusal) || std::any_of(attempt.warnings.begin(), attempt.warnings.end(), holds);
}

// Everything about an attempt that must not be.
std::vector<std::string> flawsOf(const MalformedInput& input, const Attempt& attempt,
                                 const Standing& standing) {
  if (!attempt.isWell)
    return {attempt.trouble.empty() ? "ended without a word" : attempt.trouble};
  std::vector<std::string> flaws;
  const Outcome outcome = outcomeOf(attempt, standing);
  if (!input.allowed.contains(outcome))
    flaws.push_back(std::string("was ") + nameOf(outcome) + ": " + attempt.refusal);
  if (outcome == Outcome::refused && !isOneSentence(attempt.refusal))
    flaws.push_back("is refused by no single sentence: " + attempt.refusal);
  if (outcome == Outcome::refused && !names(attempt.refusal, input.path))
    flaws.push_back("is refused without its name: " + attempt.refusal);
  if (!input.says.empty() && !isSaid(attempt, input.says))
    flaws.push_back("does not say \"" + input.says + "\": " + attempt.refusal +
                    (attempt.warnings.empty() ? "" : attempt.warnings.back()));
  if (attempt.isVolume && input.hasGoodDimensions && attempt.dims != glm::ivec3(2, 3, 4))
    flaws.push_back("became another volume");
  else if (attempt.isVolume && input.hasGoodVoxels && !attempt.hasGoodVoxels)
    flaws.push_back("became a volume of other values");
  if (!isSanitised && standing.peakBytes > 0 &&
      attempt.peakBytes >
          standing.peakBytes + slackBytes + 2 * std::max(attempt.decodedBytes, input.heldBytes))
    flaws.push_back("took " + std::to_string((attempt.peakBytes - standing.peakBytes) >> 20) +
                    " MiB more than a sound file, for " + std::to_string(attempt.decodedBytes >> 20) +
                    " MiB of voxels");
  return flaws;
}

void record(FormatReport& report, const MalformedInput& input, const Attempt& attempt,
            const Standing& standing) {
  report.rows.push_back({input.flaw, outcomeOf(attempt, standing)});
  report.worstSeconds = std::max(report.worstSeconds, attempt.seconds);
  if (attempt.peakBytes > standing.peakBytes && input.flaw != "sound")
    report.worstExtraBytes = std::max(report.worstExtraBytes, attempt.peakBytes - standing.peakBytes);
  for (const std::string& flaw : flawsOf(input, attempt, standing))
    report.failures.push_back(report.format + " #" + input.path.parent_path().filename().string() + "/" +
                              input.path.filename().string() + " (" + input.flaw + ") " + flaw);
}

} // namespace

FormatReport triedFormat(const Format& format) {
  const TemporaryFolder folder;
  Corpus corpus(folder.path());
  format.addInputs(corpus);
  malloc_trim(0); // what made the inputs is no memory of reading them
  FormatReport report;
  report.format = format.name;
  Standing standing;
  for (const MalformedInput& input : corpus.inputs()) {
    if (input.flaw != "sound")
      continue;
    const Attempt first = attempt(input.path);
    standing.warnings.insert(first.warnings.begin(), first.warnings.end());
    standing.peakBytes = std::max(standing.peakBytes, first.peakBytes);
  }
  for (const MalformedInput& input : corpus.inputs())
    record(report, input, attempt(input.path), standing);
  return report;
}

} // namespace limn::test
