// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomDataset.h"

#include "io/reading/HeaderText.h"

#include <bit>
#include <cmath>

namespace limn {
namespace {

const std::string* bytesOf(const DicomDataset& dataset, DicomTag tag) {
  const auto found = dataset.elements.find(tag);
  return found == dataset.elements.end() || found->second.bytes.empty() ? nullptr : &found->second.bytes;
}

std::string trimmed(const std::string& text) {
  const auto isPadding = [](char c) { return c == ' ' || c == '\0' || c == '\t' || c == '\r' || c == '\n'; };
  std::size_t first = 0;
  std::size_t last = text.size();
  while (first < last && isPadding(text[first]))
    ++first;
  while (last > first && isPadding(text[last - 1]))
    --last;
  return text.substr(first, last - first);
}

std::optional<double> finiteIn(const std::string& text) {
  const auto value = numberIn(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::uint64_t binary(const std::string& bytes, std::size_t offset, std::size_t count, bool bigEndian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[offset + (bigEndian ? i : count - 1 - i)]);
    value = value << 8 | byte;
  }
  return value;
}

} // namespace

bool has(const DicomDataset& dataset, DicomTag tag) {
  const auto found = dataset.elements.find(tag);
  return found != dataset.elements.end() && !(found->second.bytes.empty() && found->second.items.empty());
}

std::string textOf(const DicomDataset& dataset, DicomTag tag) {
  const std::string* bytes = bytesOf(dataset, tag);
  return bytes ? trimmed(*bytes) : std::string();
}

std::vector<std::string> textsOf(const DicomDataset& dataset, DicomTag tag) {
  const std::string* bytes = bytesOf(dataset, tag);
  std::vector<std::string> values;
  if (!bytes)
    return values;
  std::size_t start = 0;
  while (true) {
    const std::size_t end = bytes->find('\\', start);
    values.push_back(trimmed(bytes->substr(start, end == std::string::npos ? end : end - start)));
    if (end == std::string::npos)
      return values;
    start = end + 1;
  }
}

std::vector<double> decimalsOf(const DicomDataset& dataset, DicomTag tag) {
  std::vector<double> numbers;
  for (const std::string& text : textsOf(dataset, tag)) {
    const auto number = finiteIn(text);
    if (!number)
      return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<double> decimalOf(const DicomDataset& dataset, DicomTag tag) {
  const std::vector<std::string> texts = textsOf(dataset, tag);
  return texts.empty() ? std::nullopt : finiteIn(texts.front());
}

std::optional<glm::dvec3> decimalVectorOf(const DicomDataset& dataset, DicomTag tag) {
  const std::vector<double> numbers = decimalsOf(dataset, tag);
  if (numbers.size() != 3)
    return std::nullopt;
  return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

std::optional<std::uint32_t> unsignedOf(const DicomDataset& dataset, DicomTag tag) {
  const std::string* bytes = bytesOf(dataset, tag);
  if (!bytes || bytes->size() < 2)
    return std::nullopt;
  return static_cast<std::uint32_t>(binary(*bytes, 0, bytes->size() == 4 ? 4 : 2, dataset.bigEndian));
}

std::vector<std::uint16_t> wordsOf(const DicomDataset& dataset, DicomTag tag) {
  const std::string* bytes = bytesOf(dataset, tag);
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; bytes && i + 2 <= bytes->size(); i += 2)
    words.push_back(static_cast<std::uint16_t>(binary(*bytes, i, 2, dataset.bigEndian)));
  return words;
}

std::optional<double> floatOf(const DicomDataset& dataset, DicomTag tag) {
  const std::string* bytes = bytesOf(dataset, tag);
  std::optional<double> value;
  if (bytes && bytes->size() >= 8)
    value = std::bit_cast<double>(binary(*bytes, 0, 8, dataset.bigEndian));
  else if (bytes && bytes->size() >= 4)
    value = std::bit_cast<float>(static_cast<std::uint32_t>(binary(*bytes, 0, 4, dataset.bigEndian)));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

const DicomDataset* firstItemOf(const DicomDataset& dataset, DicomTag tag) {
  const auto found = dataset.elements.find(tag);
  return found == dataset.elements.end() || found->second.items.empty() ? nullptr
                                                                        : &found->second.items.front();
}

} // namespace limn
