// SPDX-License-Identifier: GPL-3.0-or-later
#include "Corpus.h"

#include "support/FileBytes.h"

#include <algorithm>

namespace limn::test {

std::filesystem::path Corpus::newFolder() {
  const std::filesystem::path folder = m_folder / std::to_string(m_inputs.size());
  std::filesystem::create_directories(folder);
  return folder;
}

MalformedInput& Corpus::add(const std::string& flaw, const std::filesystem::path& path,
                            const Outcomes& allowed, const std::string& says) {
  m_inputs.push_back({flaw, path, allowed, says});
  return m_inputs.back();
}

MalformedInput& Corpus::addFile(const std::string& flaw, const std::string& name, const std::string& bytes,
                                const Outcomes& allowed, const std::string& says) {
  const std::filesystem::path file = newFolder() / name;
  writeBytes(file, bytes);
  return add(flaw, file, allowed, says);
}

void Corpus::addCuts(const std::string& name, const std::string& bytes, std::size_t complete,
                     std::size_t places) {
  std::set<std::size_t> lengths = {0, 1, 2, 4, complete - 1};
  for (std::size_t i = 1; i <= places; ++i)
    lengths.insert(bytes.size() * i / (places + 1));
  for (const std::size_t length : lengths)
    if (length < bytes.size())
      addFile("truncated", name, bytes.substr(0, length),
              length < complete ? Outcomes{Outcome::refused} : anyOutcome);
}

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {"NIfTI", addNiftiInputs},
      {"NRRD", addNrrdInputs},
      {"MetaImage", addMetaImageInputs},
      {"VTK legacy", addVtkLegacyInputs},
      {"VTI", addVtkXmlInputs},
      {"TIFF", addTiffInputs},
      {"PNG stack", addPngInputs},
      {"JPEG stack", addJpegInputs},
      {"DICOM file", addDicomFileInputs},
      {"DICOM series", addDicomSeriesInputs},
      {"DICOM, compressed", addCompressedDicomInputs},
      {"DICOM, odd", addOddDicomInputs},
      {"InVesalius", addInVesaliusInputs},
      {"no format", addOtherInputs},
  };
  return all;
}

} // namespace limn::test
