// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/Items.h"

#include <array>

namespace limn::dicom {

/// Where one channel of a table stands.
struct TableChannel {
  DcmTagKey descriptor, plain, segmented;
};

/// Red, green, blue, alpha.
const std::array<TableChannel, 4>& tableChannels();

/// What a descriptor of a table says (PS3.3 C.7.6.3.1.5).
struct TableDescriptor {
  std::size_t entries = 0;
  int first = 0; ///< the value that the first entry is of
  int bits = 16; ///< 8 or 16
  bool operator==(const TableDescriptor&) const = default;
};

/// Reads a descriptor. Throws Error (input).
TableDescriptor tableDescriptorIn(DcmItem& item, const DcmTagKey& tag, const std::string& name);

/// The entries of a table, plain or segmented (C.7.9.2). Throws Error (input) where their number is not the
/// descriptor's.
std::vector<std::uint16_t> tableEntriesIn(DcmItem& item, const TableChannel& channel,
                                          const TableDescriptor& descriptor, const std::string& name);

} // namespace limn::dicom
