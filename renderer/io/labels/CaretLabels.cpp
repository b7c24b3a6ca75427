// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/CaretLabels.h"

#include "io/reading/ReadError.h"

#include <pugixml.hpp>

#include <cstring>

namespace limn {
namespace {

constexpr std::size_t longestLabelName = 200;

std::string trimmed(const std::string& text) {
  constexpr const char* white = " \t\r\n";
  const std::size_t first = text.find_first_not_of(white);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(white) - first + 1);
}

Label labelOf(const pugi::xml_node& node) {
  const auto channel = [&](const char* name) { return node.attribute(name).as_double(1.0); };
  const glm::dvec3 color(channel("Red"), channel("Green"), channel("Blue"));
  return {node.attribute("Key").as_int(), plainText(trimmed(node.child_value()), longestLabelName),
          glm::clamp(color, 0.0, 1.0)};
}

} // namespace

std::vector<Label> caretLabels(const std::string& bytes) {
  const std::size_t end = bytes.find_last_of('>');
  if (end == std::string::npos || bytes.find("<CaretExtension") == std::string::npos)
    return {};
  pugi::xml_document document;
  if (!document.load_buffer(bytes.data(), end + 1))
    return {};
  const pugi::xml_node table = document.find_node(
      [](const pugi::xml_node& node) { return std::strcmp(node.name(), "LabelTable") == 0; });
  std::vector<Label> labels;
  for (const pugi::xml_node& node : table.children("Label"))
    if (Label label = labelOf(node); label.value != 0)
      labels.push_back(std::move(label));
  return labels;
}

} // namespace limn
