// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"

// What words in a description or a name tell of a scan; the hints themselves are a volume's (Volume.h).

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace limn {
namespace {

using Words = std::initializer_list<const char*>;

// A word that hints begins so, or is it where it is short: "ct" must not be found in "sector".
bool isAny(const std::string& word, const Words& words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view known) {
    return known.size() > 4 ? word.starts_with(known) : word == known;
  });
}

void readWord(const std::string& word, ScanHints& hints) {
  using BodyPart = ScanHints::BodyPart;
  using Weighting = ScanHints::Weighting;
  if (isAny(word, {"ct", "cta", "ctpa", "ccta", "hrct"}))
    hints.modality = "CT";
  if (isAny(word, {"mr", "mri", "mra", "mrv", "tof", "mprage", "flair", "spgr"}))
    hints.modality = "MR";
  if (isAny(word, {"pt", "pet", "suv"}))
    hints.modality = "PT";
  if (isAny(word, {"cta", "ctpa", "ccta", "mra", "mrv", "tof", "angio", "angiography", "avm", "vessel",
                   "aneurysm"}))
    hints.isAngiography = true;
  if (isAny(word, {"head", "brain", "skull", "cranium", "cerebr", "neuro"}))
    hints.bodyPart = BodyPart::head;
  if (isAny(word, {"chest", "thorax", "lung", "lungs", "hrct"}))
    hints.bodyPart = BodyPart::chest;
  if (isAny(word, {"abdomen", "abdominal", "liver", "pelvis"}))
    hints.bodyPart = BodyPart::abdomen;
  if (isAny(word, {"t1", "t1w", "mprage", "spgr"}))
    hints.weighting = Weighting::t1;
  if (isAny(word, {"t2", "t2w", "flair"}))
    hints.weighting = Weighting::t2;
  if (isAny(word, {"pd", "pdw"}))
    hints.weighting = Weighting::pd;
}

} // namespace

ScanHints withHintsOf(ScanHints hints, std::string_view text) {
  std::string word;
  const auto end = [&] {
    readWord(word, hints);
    word.clear();
  };
  for (const char letter : text)
    if (std::isalnum(static_cast<unsigned char>(letter)))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    else
      end();
  end();
  return hints;
}

ScanHints::Weighting weightingBy(double repetitionMs, double echoMs) {
  if (repetitionMs < 1000.0)
    return echoMs < 40.0 ? ScanHints::Weighting::t1 : ScanHints::Weighting::unknown;
  if (repetitionMs < 1800.0)
    return ScanHints::Weighting::unknown;
  return echoMs < 40.0 ? ScanHints::Weighting::pd : ScanHints::Weighting::t2;
}

} // namespace limn
