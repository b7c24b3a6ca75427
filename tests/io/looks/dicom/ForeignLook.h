// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/DicomBuilder.h"

#include <functional>

namespace limn::test {

/// A look as another program writes it, changed at the places that a test is about.
struct ForeignLook {
  DicomBuilder object, set, image, input, stream, component, componentInput;

  /// Three entries from 0 to 200: transparent black, half red, white. Parallel, 100 mm high, from the front.
  ForeignLook() {
    object.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.11.9").text(0x00080018, "UI", "9.8.7");
    object.text(0x0020000D, "UI", "1.2.3").text(0x00080060, "CS", "PR");
    image.text(0x00081150, "UI", "1.2.840.10008.5.1.4.1.1.2").text(0x00081155, "UI", "1.2.3.4.1");
    set.text(0x00701209, "UI", "5.5").text(0x00701202, "CS", "VOLUME");
    input.us(0x00701207, {1}).text(0x00701209, "UI", "5.5").text(0x00701204, "CS", "NO");
    input.text(0x00281050, "DS", "100").text(0x00281051, "DS", "200").text(0x00281056, "CS", "LINEAR_EXACT");
    object.text(0x0070120B, "CS", "NO");
    object.text(0x00701602, "CS", "ORTHOGRAPHIC").text(0x0070120D, "CS", "VOLUME_RENDERED");
    object.fds(0x00701603, {0, -500, 0}).fds(0x00701604, {0, 0, 0}).fds(0x00701605, {0, 0, 1});
    object.fds(0x00701606, {-100, 100, 50, -50, 1, 1000}).fds(0x00701607, {0.5});
    stream.text(0x00701209, "UI", "5.5");
    componentInput.us(0x00701804, {1});
    component.text(0x00701802, "CS", "ONE_TO_RGBA");
    component.text(0x0028140F, "CS", "TABLE").text(0x00281410, "CS", "TABLE");
    tables(16, {{0, 0x8000, 0xFFFF}, {0, 0, 0xFFFF}, {0, 0, 0xFFFF}, {0, 0x4000, 0xFFFF}});
  }

  /// Red, green, blue, alpha as words.
  ForeignLook& tables(int bits, const std::vector<std::vector<std::uint16_t>>& channels, int entries = 3,
                      std::uint16_t first = 0, const std::string& vr = "US") {
    for (std::uint32_t c = 0; c < 4; ++c) {
      component.words(0x00281101 + c, vr,
                      {static_cast<std::uint16_t>(entries), first, static_cast<std::uint16_t>(bits)});
      component.words(0x00281201 + c, "OW", channels[c]);
    }
    return *this;
  }

  std::string bytes() const {
    ForeignLook whole = *this;
    whole.component.sequence(0x00701803, {componentInput});
    whole.stream.sequence(0x00701801, {whole.component});
    whole.set.sequence(0x00081140, {image});
    whole.object.sequence(0x0070120A, {whole.set}).sequence(0x00701201, {whole.input});
    whole.object.sequence(0x00701A08, {whole.stream});
    return whole.object.bytes();
  }
};

} // namespace limn::test
