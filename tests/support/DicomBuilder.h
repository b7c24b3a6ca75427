// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace limn::test {

/// Writes small DICOM files in Explicit VR Little Endian. Setting an attribute again replaces it.
class DicomBuilder {
public:
  DicomBuilder& text(std::uint32_t tag, const std::string& vr, std::string value) {
    if (value.size() % 2 != 0)
      value += vr == "UI" ? '\0' : ' ';
    m_elements[tag] = {vr, std::move(value)};
    return *this;
  }

  DicomBuilder& us(std::uint32_t tag, const std::vector<std::uint16_t>& words) {
    m_elements[tag] = {"US", littleEndian(words)};
    return *this;
  }

  DicomBuilder& fd(std::uint32_t tag, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    std::string bytes;
    for (int i = 0; i < 8; ++i)
      bytes += static_cast<char>(bits >> (8 * i));
    m_elements[tag] = {"FD", bytes};
    return *this;
  }

  DicomBuilder& fds(std::uint32_t tag, const std::vector<double>& values) {
    std::vector<std::uint64_t> bits;
    for (const double value : values)
      bits.push_back(std::bit_cast<std::uint64_t>(value));
    m_elements[tag] = {"FD", littleEndian(bits)};
    return *this;
  }

  /// 16-bit words of VR OW or SS.
  DicomBuilder& words(std::uint32_t tag, const std::string& vr, const std::vector<std::uint16_t>& words) {
    m_elements[tag] = {vr, littleEndian(words)};
    return *this;
  }

  DicomBuilder& sequence(std::uint32_t tag, const std::vector<DicomBuilder>& items) {
    std::string bytes;
    for (const DicomBuilder& item : items) {
      const std::string inside = item.elements();
      bytes += tagBytes(0xFFFEE000) + number(inside.size(), 4) + inside;
    }
    m_elements[tag] = {"SQ", bytes};
    return *this;
  }

  /// Pixels in the width of T.
  template <class T>
  DicomBuilder& pixels(const std::vector<T>& values) {
    m_elements[0x7FE00010] = {"OW", littleEndian(values)};
    if (m_elements[0x7FE00010].bytes.size() % 2 != 0)
      m_elements[0x7FE00010].bytes += '\0';
    return *this;
  }

  /// Pixels as compressed fragments, one per frame, behind an empty offset table.
  DicomBuilder& fragments(const std::string& transferSyntax, const std::vector<std::string>& streams) {
    m_transferSyntax = transferSyntax;
    m_fragments = tagBytes(0xFFFEE000) + number(0, 4);
    for (const std::string& stream : streams)
      m_fragments += tagBytes(0xFFFEE000) + number(stream.size(), 4) + stream;
    m_fragments += tagBytes(0xFFFEE0DD) + number(0, 4);
    return *this;
  }

  DicomBuilder& without(std::uint32_t tag) {
    m_elements.erase(tag);
    return *this;
  }

  /// The whole file: preamble, group 0002, attributes.
  std::string bytes() const {
    DicomBuilder meta;
    meta.text(0x00020010, "UI", m_transferSyntax);
    std::string pixels;
    if (!m_fragments.empty())
      pixels = tagBytes(0x7FE00010) + "OB" + number(0, 2) + number(0xFFFFFFFF, 4) + m_fragments;
    std::string preamble(128, '\0');
    return preamble.append("DICM") + meta.elements() + elements() + pixels;
  }

  void write(const std::filesystem::path& path) const {
    std::filesystem::create_directories(path.parent_path());
    const std::string content = bytes();
    std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  }

private:
  struct Element {
    std::string vr;
    std::string bytes;
  };

  static std::string number(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
      text += static_cast<char>(value >> (8 * i));
    return text;
  }

  static std::string tagBytes(std::uint32_t tag) { return number(tag >> 16, 2) + number(tag & 0xFFFF, 2); }

  template <class T>
  static std::string littleEndian(const std::vector<T>& values) {
    std::string bytes;
    for (const T value : values)
      bytes += number(static_cast<std::uint64_t>(value), sizeof(T));
    return bytes;
  }

  std::string elements() const {
    std::string text;
    for (const auto& [tag, element] : m_elements) {
      const bool isLong = element.vr == "OW" || element.vr == "OB" || element.vr == "SQ";
      text += tagBytes(tag) + element.vr + (isLong ? number(0, 2) : "") +
              number(element.bytes.size(), isLong ? 4 : 2) + element.bytes;
    }
    return text;
  }

  std::map<std::uint32_t, Element> m_elements;
  std::string m_transferSyntax = "1.2.840.10008.1.2.1";
  std::string m_fragments;
};

} // namespace limn::test
