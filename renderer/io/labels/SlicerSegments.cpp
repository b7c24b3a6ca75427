// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/SlicerSegments.h"

#include "io/reading/ReadError.h"

#include <charconv>
#include <sstream>

namespace limn {
namespace {

constexpr std::size_t longestName = 200;

std::optional<int> wholeNumber(const std::string& text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failed == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<glm::dvec3> colorIn(const std::string& text) {
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  glm::dvec3 color;
  if (!(numbers >> color.r >> color.g >> color.b))
    return std::nullopt;
  return glm::clamp(color, 0.0, 1.0);
}

std::string keyIn(const NrrdHeader& header, const std::string& key) {
  const auto found = header.keys.find(key);
  return found == header.keys.end() ? std::string() : found->second;
}

} // namespace

std::vector<Label> slicerSegments(const NrrdHeader& header) {
  std::vector<Label> labels;
  for (int n = 0; header.keys.contains("Segment" + std::to_string(n) + "_ID") ||
                  header.keys.contains("Segment" + std::to_string(n) + "_Name");
       ++n) {
    const std::string segment = "Segment" + std::to_string(n);
    const std::optional<int> value = wholeNumber(keyIn(header, segment + "_LabelValue"));
    const std::optional<glm::dvec3> color = colorIn(keyIn(header, segment + "_Color"));
    if (value)
      labels.push_back({*value, plainText(keyIn(header, segment + "_Name"), longestName),
                        color.value_or(glm::dvec3(1.0))});
  }
  return labels;
}

} // namespace limn
