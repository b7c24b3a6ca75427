// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/XmlText.h"

#include "io/looks/curves/LookCurves.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <sstream>

namespace limn {

pugi::xml_document parsedXml(std::string_view text, const std::string& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result)
    failReading(file, Message::tr("its XML is cut off or damaged (near byte %1)").arg(result.offset),
                saveLookAgain);
  return document;
}

std::optional<double> attributeIn(const pugi::xml_node& node, const char* attribute,
                                  const std::string& file) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found)
    return std::nullopt;
  const std::string_view text = trimmed(found.value());
  const std::optional<double> number = numberIn(text);
  if (!number)
    failReading(file,
                Message::tr("its attribute \"%1\" of <%2> is \"%3\" and no number")
                    .arg(attribute, node.name(), std::string(text.substr(0, 40))),
                saveLookAgain);
  return number;
}

double attributeOf(const pugi::xml_node& node, const char* attribute, const std::string& file) {
  const std::optional<double> number = attributeIn(node, attribute, file);
  if (!number)
    failReading(file, Message::tr("<%1> has no attribute \"%2\"").arg(node.name(), attribute), saveLookAgain);
  return *number;
}

std::string textOf(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

} // namespace limn
