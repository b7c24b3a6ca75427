// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace limn {

/// A text as XML, also with several roots. Throws Error (input), naming `file`, where it is damaged.
pugi::xml_document parsedXml(std::string_view text, const std::string& file);

/// A number in an attribute, in the C locale, "nan" and "inf" too; absent where there is no such attribute.
/// Throws Error (input), naming `file`, where it is no number.
std::optional<double> attributeIn(const pugi::xml_node& node, const char* attribute, const std::string& file);

/// The same of an attribute that there must be.
double attributeOf(const pugi::xml_node& node, const char* attribute, const std::string& file);

/// The text of a document, indented by spaces.
std::string textOf(const pugi::xml_document& document);

} // namespace limn
