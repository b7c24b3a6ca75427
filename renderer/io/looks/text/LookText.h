// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pugi {
class xml_document;
}

namespace limn {

/// A number with which a text starts, as C's atof takes "-250.0.0" for -250, in the C locale; "nan" and "inf"
/// too. `used`, if given, receives how many letters it takes. Nothing where the text starts otherwise.
std::optional<double> leadingNumber(std::string_view text, std::size_t* used = nullptr);

/// The shortest text that reads back as the same number, in the C locale.
std::string shortest(double number);

/// Adds a sentence that is not yet among them.
void tell(std::vector<Message>& changes, const Message& sentence);

/// Sentences as scripts read them: {"changes": [{"what": "…"}]}.
std::string changesJson(const std::vector<Message>& changes);

/// The text of a document, indented by spaces.
std::string xmlText(const pugi::xml_document& document);

} // namespace limn
