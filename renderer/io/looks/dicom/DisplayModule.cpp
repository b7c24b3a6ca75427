// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DisplayModule.h"

#include "io/looks/dicom/SrgbProfile.h"
#include "io/reading/ReadError.h"
#include "scene/light/LightingTerms.h"

#include <dcmtk/dcmdata/dcelem.h>
#include <dcmtk/dcmdata/dcvrus.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace limn::dicom {
namespace {

// Where one channel of a table stands.
struct TableChannel {
  DcmTagKey descriptor, plain, segmented;
};

// What a descriptor of a table says (PS3.3 C.7.6.3.1.5).
struct TableDescriptor {
  std::size_t entries = 0;
  int first = 0; ///< the value that the first entry is of
  int bits = 16; ///< 8 or 16
  bool operator==(const TableDescriptor&) const = default;
};

using Words = std::vector<std::uint16_t>;

[[noreturn]] void failLength(const std::string& name, const DcmTagKey& tag, std::size_t is,
                             std::size_t should) {
  failReading(name,
              Message::tr("the table %1 has %2 entries, where its descriptor announces %3")
                  .arg(nameOf(tag), is, should),
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

// Red, green, blue, alpha.
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

// Reads a descriptor. Throws Error (input).
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

// The entries of a table, plain or segmented (C.7.9.2). Throws Error (input) where their number is not the
// descriptor's.
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

/// The values at which a table begins and ends.
struct Span {
  double first = 0.0;
  double last = 0.0;
};

/// The window of an input (PS3.3 C.11.2.1.2-3); none: values are looked up as they are.
struct Window {
  double centre = 0.0;
  double width = 0.0;
  bool isExact = true;
};

std::optional<Window> windowIn(DcmItem& input, const std::string& name, std::vector<Message>& changes) {
  if (holds(input, DCM_VOILUTSequence))
    failReading(name, Message::tr("its window is given by a table, which Limn does not apply"),
                Message::tr("export the look with a window of centre and width"));
  const auto centre = numberIn(input, DCM_WindowCenter), width = numberIn(input, DCM_WindowWidth);
  if (!centre && !width)
    return std::nullopt;
  const std::string function = textIn(input, DCM_VOILUTFunction);
  const bool isExact = function == "LINEAR_EXACT";
  if (!centre || !width || !(*width > (isExact ? 0.0 : 1.0)))
    failReading(name, Message::tr("its window has no centre, or a width that is none"), exportAgain);
  if (!function.empty() && function != "LINEAR" && !isExact)
    changes.push_back(Message::tr("The window's function %1 was read as a straight line.").arg(function));
  return Window{*centre, *width, isExact};
}

// A window fills the table; without one the first value is the value of the first entry.
Span spanOf(const std::optional<Window>& window, const TableDescriptor& table) {
  const auto steps = static_cast<double>(table.entries - 1);
  if (!window)
    return {static_cast<double>(table.first), table.first + steps};
  // y = ((x - c)/w + 1/2)·(n-1) + first, looked up from `first` on: that adds and takes away the same.
  if (window->isExact)
    return {window->centre - 0.5 * window->width, window->centre + 0.5 * window->width};
  const double half = 0.5 * (window->width - 1.0);
  return {window->centre - 0.5 - half, window->centre - 0.5 + half};
}

DcmItem& onlyItem(DcmItem& item, const DcmTagKey& tag, const Message& several, const std::string& name) {
  const std::vector<DcmItem*> items = itemsIn(item, tag);
  if (items.empty())
    failReading(name, Message::tr("%1 is missing").arg(nameOf(tag)), exportAgain);
  if (items.size() > 1)
    failReading(name, several, Message::tr("export a look of one volume"));
  return *items.front();
}

DcmItem& componentIn(DcmItem& object, const std::string& name) {
  DcmItem& stream = onlyItem(object, DCM_VolumeStreamSequence,
                             Message::tr("it shows several volumes together, which Limn cannot draw"), name);
  DcmItem& component =
      onlyItem(stream, DCM_PresentationStateClassificationComponentSequence,
               Message::tr("it classifies its volume several times, which Limn cannot draw"), name);
  const std::string type = textIn(component, DCM_ComponentType);
  if (type == "TWO_TO_RGBA")
    failReading(name,
                Message::tr("its colours depend on two values at a time (TWO_TO_RGBA), which Limn "
                            "cannot draw"),
                Message::tr("export a look whose colours depend on one"));
  if (type != "ONE_TO_RGBA")
    failReading(name, Message::tr("the kind of its colours, \"%1\", is unknown").arg(type), exportAgain);
  return component;
}

using Entries = std::vector<std::uint16_t>;

// Grey, or an alpha that is the value: as many steps as the table beside it has, else of 16 bits.
Entries identity(const TableDescriptor& descriptor) {
  Entries entries(descriptor.entries);
  const double largest = descriptor.bits == 8 ? 255.0 : 65535.0;
  for (std::size_t i = 0; i < entries.size(); ++i)
    entries[i] = static_cast<std::uint16_t>(
        std::lround(largest * static_cast<double>(i) / static_cast<double>(entries.size() - 1)));
  return entries;
}

// The descriptor that all tables there are share.
TableDescriptor sharedDescriptor(DcmItem& component, bool hasColours, bool hasOpacity,
                                 const std::string& name) {
  std::optional<TableDescriptor> shared;
  const auto join = [&](const TableChannel& channel) {
    const TableDescriptor here = tableDescriptorIn(component, channel.descriptor, name);
    if (shared && here != *shared)
      failReading(name, Message::tr("the tables of its colours and opacity differ in length or bits"),
                  exportAgain);
    shared = here;
  };
  for (std::size_t c = 0; c < 4; ++c)
    if (c < 3 ? hasColours : hasOpacity)
      join(tableChannels()[c]);
  const TableDescriptor found = shared.value_or(TableDescriptor{4096, 0, 16});
  if (found.entries < 2)
    failReading(name, Message::tr("its table has a single entry"), exportAgain);
  return found;
}

Entries opacitiesIn(DcmItem& component, const std::string& kind, const TableDescriptor& descriptor,
                    const std::string& name) {
  if (kind == "TABLE")
    return tableEntriesIn(component, tableChannels()[3], descriptor, name);
  if (kind == "IDENTITY")
    return identity(descriptor);
  return Entries(descriptor.entries, static_cast<std::uint16_t>(descriptor.bits == 8 ? 255 : 65535));
}

void requireKnown(const std::string& colour, const std::string& alpha, const std::string& name) {
  if (colour != "TABLE" && colour != "EQUAL_RGB")
    failReading(name, Message::tr("the kind of its colours, \"%1\", is unknown").arg(colour), exportAgain);
  if (alpha != "TABLE" && alpha != "IDENTITY" && alpha != "NONE")
    failReading(name, Message::tr("the kind of its opacities, \"%1\", is unknown").arg(alpha), exportAgain);
}

void putFraction(DcmItem& object, const DcmTagKey& tag, double number) {
  putNumbers(object, tag, {std::clamp(number, 0.0, 1.0)});
}

double fractionIn(DcmItem& object, const DcmTagKey& tag, const std::string& name) {
  const double number = numberIn(object, tag).value_or(0.0);
  if (number < 0.0 || number > 1.0)
    failReading(name, Message::tr("%1 is not within 0 to 1").arg(nameOf(tag)), exportAgain);
  return number;
}

} // namespace

WrittenWindow windowOver(const ValueRange& range) {
  // One value alone still needs a window of some width.
  double centre = 0.5 * range.lowest + 0.5 * range.highest;
  double width = range.highest > range.lowest ? range.highest - range.lowest : 1.0;
  WrittenWindow window{decimalText(centre), decimalText(width), {}};
  const double written = std::strtod(window.centre.c_str(), nullptr);
  const double needed = width + 2.0 * std::abs(written - centre);
  if (std::strtod(window.width.c_str(), nullptr) < needed)
    window.width = decimalText(needed * (1.0 + 1e-8));
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

ColourTable displayIn(DcmItem& object, DcmItem& input, const std::string& name,
                      std::vector<Message>& changes) {
  DcmItem& component = componentIn(object, name);
  const std::string colour = textIn(component, DCM_RGBLUTTransferFunction);
  const std::string alpha = textIn(component, DCM_AlphaLUTTransferFunction);
  requireKnown(colour, alpha, name);
  const bool hasColours = colour == "TABLE", hasOpacity = alpha == "TABLE";
  const TableDescriptor descriptor = sharedDescriptor(component, hasColours, hasOpacity, name);
  const std::optional<Window> window = windowIn(input, name, changes);
  if (!window && !hasColours && !hasOpacity)
    failReading(name, Message::tr("it has neither a window nor a table"), exportAgain);
  const Span span = spanOf(window, descriptor);
  ColourTable table{span.first, span.last, descriptor.bits == 8 ? 255 : 65535, {}};
  std::vector<Entries> columns;
  for (std::size_t c = 0; c < 3; ++c)
    columns.push_back(hasColours ? tableEntriesIn(component, tableChannels()[c], descriptor, name)
                                 : identity(descriptor));
  columns.push_back(opacitiesIn(component, alpha, descriptor, name));
  for (std::size_t i = 0; i < descriptor.entries; ++i)
    table.entries.push_back({columns[0][i], columns[1][i], columns[2][i], columns[3][i]});
  return table;
}

void putShading(DcmItem& object, const Shading& shading, const Camera& camera) {
  if (shading.model == ShadingModel::none)
    return;
  putText(object, DCM_ShadingStyle, shading.twoSided ? "DOUBLESIDED" : "SINGLESIDED");
  putFraction(object, DCM_AmbientReflectionIntensity, shading.ambient * shading.ambientIntensity);
  // However short, a direction is one: scaled first, so that the square of its length is no 0.
  glm::dvec3 travels = lightTravels(shading, camera).value_or(basisOf(camera).forward);
  travels /= std::max({std::abs(travels.x), std::abs(travels.y), std::abs(travels.z)});
  travels = glm::normalize(travels);
  putNumbers(object, DCM_LightDirection, {travels.x, travels.y, travels.z});
  putFraction(object, DCM_DiffuseReflectionIntensity, shading.diffuse * shading.lightIntensity);
  putFraction(object, DCM_SpecularReflectionIntensity, shading.specular * shading.lightIntensity);
  // A highlight of half the angle (Blinn) is as wide as a reflected one of a quarter of the exponent.
  const double exponent = shading.exponent * (shading.reflection == Reflection::blinn ? 0.25 : 1.0);
  putFraction(object, DCM_Shininess, exponent / largestExponent);
}

Shading shadingIn(DcmItem& object, const std::string& name, std::vector<Message>& changes) {
  Shading shading;
  shading.model = ShadingModel::none;
  if (!holds(object, DCM_ShadingStyle) && !holds(object, DCM_AmbientReflectionIntensity))
    return shading;
  shading.model = ShadingModel::classic;
  shading.reflection = Reflection::phong;
  shading.specularColor = SpecularColor::light;
  shading.twoSided = textIn(object, DCM_ShadingStyle) == "DOUBLESIDED";
  shading.ambientIntensity = 1.0;
  shading.lightIntensity = 1.0;
  shading.ambient = fractionIn(object, DCM_AmbientReflectionIntensity, name);
  shading.diffuse = fractionIn(object, DCM_DiffuseReflectionIntensity, name);
  shading.specular = fractionIn(object, DCM_SpecularReflectionIntensity, name);
  shading.exponent = std::max(1.0, largestExponent * fractionIn(object, DCM_Shininess, name));
  const std::vector<double> travels = numbersIn(object, DCM_LightDirection);
  if (travels.size() == 3 && (travels[0] != 0.0 || travels[1] != 0.0 || travels[2] != 0.0))
    shading.lightDirection = glm::dvec3(travels[0], travels[1], travels[2]);
  else if (shading.diffuse > 0.0 || shading.specular > 0.0)
    changes.push_back(Message::tr("The direction of the light is missing; it comes from the viewer."));
  return shading;
}

} // namespace limn::dicom
