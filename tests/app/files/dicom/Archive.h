// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <sys/types.h>

namespace limn::test {

/// What is missing here of an archive and the tools that talk to it; empty where all is there.
std::string missingForArchive();

/// An Orthanc with DICOMweb on free ports of this machine's loopback, which keeps everything in a folder; it
/// ends with its owner.
class Archive {
public:
  explicit Archive(const std::filesystem::path& folder);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// Waits until it answers, up to the tests' time limit; false where it ended before.
  bool answers();

  /// Sends every file below a folder by DICOM's own protocol (storescu).
  bool store(const std::filesystem::path& folder) const;

  /// What DICOMweb answers to a request for this media type.
  std::string get(const std::string& path, const std::string& accept) const;

  /// One instance by WADO-RS: the file in the only part of the answer; empty where there is none.
  std::string instance(const std::string& study, const std::string& series, const std::string& uid) const;

  std::string log() const;

private:
  std::filesystem::path m_folder;
  int m_httpPort = 0;
  int m_dicomPort = 0;
  pid_t m_process = -1;
};

} // namespace limn::test
