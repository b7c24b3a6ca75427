// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DisplayModule.h"

#include "io/looks/dicom/SrgbProfile.h"
#include "io/looks/dicom/TableEntries.h"

#include <dcmtk/dcmdata/dcvrus.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace limn::dicom {
namespace {

/// A decimal string has 16 characters.
constexpr std::size_t longestDecimal = 16;

// The shortest text that reads as the number, or the nearest one of 16 characters.
std::string decimal(double number) {
  char text[40];
  const auto shortest = std::to_chars(text, text + sizeof text, number);
  int digits = 16;
  std::string written(text, shortest.ptr);
  while (written.size() > longestDecimal) {
    std::snprintf(text, sizeof text, "%.*g", digits--, number);
    written = text;
  }
  return written;
}

void putChannel(DcmItem& component, const TableChannel& channel, const ColourTable& table, std::size_t c) {
  // The dictionary leaves its VR to the pixels' sign, and a look has no pixels.
  const std::array<Uint16, 3> descriptor{static_cast<Uint16>(table.entries.size()), 0, 16};
  auto* element = new DcmUnsignedShort(DcmTag(channel.descriptor, EVR_US)); // the item owns it
  const bool isFilled = element->putUint16Array(descriptor.data(), descriptor.size()).good();
  require(component.insert(element, true).good() && isFilled, channel.descriptor);
  std::vector<Uint16> words;
  for (const auto& entry : table.entries)
    words.push_back(entry[c]);
  require(component
              .putAndInsertUint16Array(DcmTag(channel.plain, EVR_OW), words.data(),
                                       static_cast<unsigned long>(words.size()))
              .good(),
          channel.plain);
}

} // namespace

WrittenWindow windowOver(const ValueRange& range) {
  // One value alone still needs a window of some width.
  double centre = 0.5 * range.lowest + 0.5 * range.highest;
  double width = range.highest > range.lowest ? range.highest - range.lowest : 1.0;
  WrittenWindow window{decimal(centre), decimal(width), {}};
  const double written = std::strtod(window.centre.c_str(), nullptr);
  const double needed = width + 2.0 * std::abs(written - centre);
  if (std::strtod(window.width.c_str(), nullptr) < needed)
    window.width = decimal(needed * (1.0 + 1e-8));
  centre = written;
  width = std::strtod(window.width.c_str(), nullptr);
  window.range = {centre - 0.5 * width, centre + 0.5 * width};
  return window;
}

void putWindow(DcmItem& input, const WrittenWindow& window) {
  putText(input, DCM_WindowCenter, window.centre);
  putText(input, DCM_WindowWidth, window.width);
  putText(input, DCM_VOILUTFunction, "LINEAR_EXACT");
}

void putDisplay(DcmItem& object, const std::string& inputSet, const ColourTable& table) {
  putText(object, DCM_PixelPresentation, "TRUE_COLOR");
  DcmItem& stream = addItem(object, DCM_VolumeStreamSequence);
  putText(stream, DCM_VolumetricPresentationInputSetUID, inputSet);
  DcmItem& component = addItem(stream, DCM_PresentationStateClassificationComponentSequence);
  putText(component, DCM_ComponentType, "ONE_TO_RGBA");
  putCount(addItem(component, DCM_ComponentInputSequence), DCM_VolumetricPresentationInputIndex, 1);
  putText(component, DCM_RGBLUTTransferFunction, "TABLE");
  putText(component, DCM_AlphaLUTTransferFunction, "TABLE");
  for (std::size_t c = 0; c < tableChannels().size(); ++c)
    putChannel(component, tableChannels()[c], table, c);
  putNothing(object, DCM_PresentationStateCompositorComponentSequence); // one volume: nothing to composite
  putSrgb(object);
}

} // namespace limn::dicom
