// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/pixels/DicomCodestream.h"
#include "scene/basics/Error.h"

namespace limn {
namespace {

constexpr std::size_t headerBytes = 64;

[[noreturn]] void fail(const DicomHeader& header) {
  throw Error(
      Error::Kind::input,
      Message::tr(
          "The run-length encoded pixels of %1 are damaged or cut off; copy the file again from its source.")
          .arg(header.path.string()));
}

std::uint32_t lengthAt(const DicomCodestream& stream, std::size_t at) {
  return stream[at] | stream[at + 1] << 8 | stream[at + 2] << 16 | std::uint32_t{stream[at + 3]} << 24;
}

// Unpacks one segment into every `stride`-th byte from `first`.
void unpack(const DicomHeader& header, const DicomCodestream& stream, std::size_t from, std::size_t to,
            std::vector<unsigned char>& out, std::size_t first, std::size_t stride) {
  std::size_t at = first;
  while (at < out.size()) {
    if (from >= to)
      fail(header);
    const auto control = static_cast<signed char>(stream[from++]);
    if (control == -128)
      continue;
    const bool isLiteral = control >= 0;
    const std::size_t count = static_cast<std::size_t>(isLiteral ? control + 1 : 1 - control);
    if (from + (isLiteral ? count : 1) > to)
      fail(header);
    for (std::size_t i = 0; i < count && at < out.size(); ++i, at += stride)
      out[at] = stream[isLiteral ? from + i : from];
    from += isLiteral ? count : 1;
  }
}

} // namespace

std::vector<unsigned char> decodedRunLengths(const DicomHeader& header, const DicomCodestream& stream) {
  const auto samples = static_cast<std::size_t>(header.format.samples);
  const auto bytesPerSample = static_cast<std::size_t>(header.format.bitsAllocated / 8);
  const std::size_t planes = samples * bytesPerSample;
  if (stream.size() < headerBytes || lengthAt(stream, 0) != planes)
    fail(header);
  std::vector<unsigned char> out(frameBytes(header));
  for (std::size_t plane = 0; plane < planes; ++plane) {
    const std::size_t from = lengthAt(stream, 4 + 4 * plane);
    const std::size_t to = plane + 1 < planes ? lengthAt(stream, 8 + 4 * plane) : stream.size();
    if (from < headerBytes || from >= to || to > stream.size())
      fail(header);
    // Segments run sample by sample, the most significant byte first.
    const std::size_t sample = plane / bytesPerSample;
    const std::size_t byte = bytesPerSample - 1 - plane % bytesPerSample;
    unpack(header, stream, from, to, out, sample * bytesPerSample + byte, planes);
  }
  return out;
}

} // namespace limn
