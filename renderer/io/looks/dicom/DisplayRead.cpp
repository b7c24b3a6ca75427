// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DisplayModule.h"
#include "io/looks/dicom/TableEntries.h"

#include "io/reading/ReadError.h"

#include <cmath>

namespace limn::dicom {
namespace {

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

} // namespace

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

} // namespace limn::dicom
