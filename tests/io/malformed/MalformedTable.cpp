// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what opening malformed volumes came to: `limn_malformed_table [MUTATIONS PER FORMAT [SEED]]`. With
// `--seeds FOLDER` it writes the sound files as the first inputs of the fuzz targets instead.
#include "Attempt.h"

#include "support/TemporaryFolder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace {

using namespace limn::test;

struct Counts {
  int inputs = 0;
  std::map<Outcome, int> by;
};

Counts countsOf(const FormatReport& report) {
  Counts counts;
  for (const auto& row : report.rows) {
    ++counts.inputs;
    ++counts.by[row.outcome];
  }
  return counts;
}

void print(const std::string& name, Counts counts, double seconds, double mebibytes) {
  std::printf("| %s | %d | %d | %d | %d | %.2f s | %.0f MiB |\n", name.c_str(), counts.inputs,
              counts.by[Outcome::correct], counts.by[Outcome::warned], counts.by[Outcome::refused], seconds,
              mebibytes);
}

double mebibytes(std::uint64_t bytes) {
  return static_cast<double>(bytes) / (1 << 20);
}

// Which fuzz target starts from the sound files of which format.
constexpr std::pair<const char*, const char*> targets[] = {
    {"NIfTI", "nifti"},       {"NRRD", "nrrd"}, {"MetaImage", "metaimage"}, {"VTK legacy", "vtk"},
    {"VTI", "vti"},           {"TIFF", "tiff"}, {"DICOM file", "dicom"},    {"DICOM, compressed", "dicom"},
    {"InVesalius", "archive"}};

int writeSeeds(const std::filesystem::path& folder) {
  for (const auto& [name, target] : targets) {
    const auto format =
        std::find_if(formats().begin(), formats().end(),
                     [&, wanted = std::string(name)](const Format& f) { return f.name == wanted; });
    const TemporaryFolder made;
    Corpus corpus(made.path());
    format->addInputs(corpus);
    for (const MalformedInput& input : corpus.inputs())
      if (input.flaw == "sound") {
        std::filesystem::create_directories(folder / target);
        std::string label = target;
        label.append("-").append(input.path.parent_path().filename().string());
        label.append(input.path.extension().string());
        std::filesystem::copy_file(input.path, folder / target / label,
                                   std::filesystem::copy_options::overwrite_existing);
      }
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--seeds")
    return writeSeeds(argv[2]);
  const int mutations = argc > 1 ? std::atoi(argv[1]) : 400;
  const auto seed = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 20251);
  std::vector<std::string> failures;
  std::map<std::string, Counts> byFlaw;
  std::printf("| format | inputs | correct | with a warning | refused | longest | most memory |\n"
              "|---|---|---|---|---|---|---|\n");
  for (const Format& format : formats()) {
    const FormatReport named = triedFormat(format);
    const FormatReport random = triedMutations(format, mutations, seed);
    print(named.format, countsOf(named), named.worstSeconds, mebibytes(named.worstExtraBytes));
    print(named.format + ", randomly damaged", countsOf(random), random.worstSeconds,
          mebibytes(random.worstExtraBytes));
    for (const FormatReport* report : {&named, &random}) {
      failures.insert(failures.end(), report->failures.begin(), report->failures.end());
      for (const auto& row : report->rows) {
        ++byFlaw[row.flaw].inputs;
        ++byFlaw[row.flaw].by[row.outcome];
      }
    }
    std::fflush(stdout);
  }
  std::printf("\n| flaw | inputs | correct | with a warning | refused |\n|---|---|---|---|---|\n");
  for (auto& [flaw, counts] : byFlaw)
    std::printf("| %s | %d | %d | %d | %d |\n", flaw.c_str(), counts.inputs, counts.by[Outcome::correct],
                counts.by[Outcome::warned], counts.by[Outcome::refused]);
  for (const std::string& failure : failures)
    std::printf("FAILED %s\n", failure.c_str());
  return failures.empty() ? 0 : 1;
}
