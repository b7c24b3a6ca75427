// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/TableEntries.h"

#include "io/reading/ReadError.h"

#include <dcmtk/dcmdata/dcelem.h>

#include <cmath>

namespace limn::dicom {
namespace {

using Words = std::vector<std::uint16_t>;

[[noreturn]] void failLength(const std::string& name, const DcmTagKey& tag, std::size_t is,
                             std::size_t should) {
  failReading(name,
              Message::tr("the table %1 has %2 entries, where its descriptor announces %3")
                  .arg(nameOf(tag))
                  .arg(is)
                  .arg(should),
              exportAgain);
}

// The values of a table of 8 or 16 bits; 8-bit ones are packed two to a word, the first in its lower half.
Words valuesIn(DcmItem& item, const DcmTagKey& tag, int bits) {
  DcmElement* element = nullptr;
  if (item.findAndGetElement(tag, element).bad())
    return {};
  Uint8* bytes = nullptr;
  Uint16* words = nullptr;
  const std::size_t length = element->getLengthField();
  Words values;
  if (element->getUint16Array(words).good() && words)
    values.assign(words, words + length / 2);
  else if (element->getUint8Array(bytes).good() && bytes)
    for (std::size_t i = 0; i + 1 < length; i += 2)
      values.push_back(static_cast<std::uint16_t>(bytes[i] | bytes[i + 1] << 8));
  if (bits == 16)
    return values;
  Words halves;
  for (const std::uint16_t word : values) {
    halves.push_back(word & 0xFF);
    halves.push_back(word >> 8);
  }
  return halves;
}

// Runs of values, and straight lines from the value before to the one named.
Words unfolded(const Words& segments, const DcmTagKey& tag, std::size_t wanted, const std::string& name) {
  Words values;
  std::size_t at = 0;
  while (at + 2 < segments.size() && values.size() < wanted) {
    const int kind = segments[at];
    const std::size_t length = segments[at + 1];
    at += 2;
    if (kind == 0) {
      if (at + length > segments.size())
        break;
      values.insert(values.end(), segments.begin() + static_cast<std::ptrdiff_t>(at),
                    segments.begin() + static_cast<std::ptrdiff_t>(at + length));
      at += length;
    } else if (kind == 1 && !values.empty()) {
      const double from = values.back(), to = segments[at++];
      for (std::size_t i = 1; i <= length; ++i)
        values.push_back(static_cast<std::uint16_t>(
            std::lround(from + (to - from) * static_cast<double>(i) / static_cast<double>(length))));
    } else {
      failReading(name, Message::tr("the table %1 is made of segments that refer to others").arg(nameOf(tag)),
                  Message::tr("export the look with plain tables"));
    }
  }
  return values;
}

} // namespace

const std::array<TableChannel, 4>& tableChannels() {
  static const std::array<TableChannel, 4> channels{
      TableChannel{DCM_RedPaletteColorLookupTableDescriptor, DCM_RedPaletteColorLookupTableData,
                   DCM_SegmentedRedPaletteColorLookupTableData},
      {DCM_GreenPaletteColorLookupTableDescriptor, DCM_GreenPaletteColorLookupTableData,
       DCM_SegmentedGreenPaletteColorLookupTableData},
      {DCM_BluePaletteColorLookupTableDescriptor, DCM_BluePaletteColorLookupTableData,
       DCM_SegmentedBluePaletteColorLookupTableData},
      {DCM_AlphaPaletteColorLookupTableDescriptor, DCM_AlphaPaletteColorLookupTableData,
       DCM_SegmentedAlphaPaletteColorLookupTableData}};
  return channels;
}

TableDescriptor tableDescriptorIn(DcmItem& item, const DcmTagKey& tag, const std::string& name) {
  DcmElement* element = nullptr;
  std::vector<int> numbers;
  if (item.findAndGetElement(tag, element).good())
    for (unsigned long i = 0; i < 3; ++i) {
      Uint16 word = 0;
      Sint16 number = 0;
      if (element->ident() == EVR_SS ? element->getSint16(number, i).good()
                                     : element->getUint16(word, i).good())
        numbers.push_back(element->ident() == EVR_SS ? number : word);
    }
  if (numbers.size() != 3 || (numbers[2] != 8 && numbers[2] != 16))
    failReading(name,
                Message::tr("the descriptor %1 does not give the length, first value and bits (8 or 16) of "
                            "its table")
                    .arg(nameOf(tag)),
                exportAgain);
  const int entries = numbers[0] & 0xFFFF; // 0 stands for 65536
  return {entries == 0 ? std::size_t{65536} : static_cast<std::size_t>(entries), numbers[1], numbers[2]};
}

std::vector<std::uint16_t> tableEntriesIn(DcmItem& item, const TableChannel& channel,
                                          const TableDescriptor& descriptor, const std::string& name) {
  const bool isPlain = holds(item, channel.plain);
  const DcmTagKey& tag = isPlain || !holds(item, channel.segmented) ? channel.plain : channel.segmented;
  Words values = valuesIn(item, tag, descriptor.bits);
  if (!isPlain)
    values = unfolded(values, tag, descriptor.entries, name);
  // One byte of padding behind an odd number of 8-bit entries.
  if (isPlain && descriptor.bits == 8 && values.size() == descriptor.entries + 1)
    values.pop_back();
  if (values.size() != descriptor.entries)
    failLength(name, tag, values.size(), descriptor.entries);
  return values;
}

} // namespace limn::dicom
