// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nrrd/NrrdHeader.h"

#include "io/formats/voxels/Bytes.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

namespace limn {
namespace {

// Names that mean one field.
std::string canonicalName(const std::string& name) {
  if (name == "datafile")
    return "data file";
  if (name == "lineskip")
    return "line skip";
  if (name == "byteskip")
    return "byte skip";
  return name;
}

} // namespace

std::string NrrdHeader::field(const std::string& name) const {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string() : found->second;
}

bool isNrrd(std::string_view bytes) {
  return bytes.starts_with("NRRD000");
}

NrrdHeader readNrrdHeader(const std::filesystem::path& file) {
  const std::string text = firstBytes(file, 1 << 20);
  NrrdHeader header;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = text.find('\n', at);
    const std::string_view line = trimmed(std::string_view(text).substr(at, end - at));
    at = end == std::string::npos ? text.size() : end + 1;
    if (line.empty()) {
      header.end = at;
      return header;
    }
    const std::size_t colon = line.find(": ");
    const std::size_t equals = line.find(":=");
    if (line.starts_with('#') || isNrrd(line))
      continue;
    if (equals < colon) {
      header.keys[std::string(line.substr(0, equals))] = line.substr(equals + 2);
      continue;
    }
    if (colon == std::string_view::npos)
      continue;
    const std::string name = canonicalName(lowerCase(trimmed(line.substr(0, colon))));
    header.fields[name] = trimmed(line.substr(colon + 1));
    // A list of data files goes on to the end of the header.
    if (name == "data file" && header.fields[name].starts_with("LIST"))
      break;
  }
  header.end = text.size();
  if (header.field("data file").empty())
    failReading(file, Message::tr("its NRRD header has no end"), copyAgain);
  return header;
}

} // namespace limn
