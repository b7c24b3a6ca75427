// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/ReadError.h"

namespace limn {
namespace {

Message sentence(const std::filesystem::path& file, const Message& rest) {
  return Message::tr("Cannot read %1: %2").arg(plainText(file.string()), rest);
}

} // namespace

std::string plainText(std::string text, std::size_t most) {
  for (char& c : text)
    c = static_cast<unsigned char>(c) < ' ' || c == 0x7f ? '?' : c; // whether or not char has a sign
  if (text.size() <= most)
    return text;
  // Not within a letter of several bytes.
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80)
    --most;
  return text.substr(0, most) + "…";
}

Message plainMessage(const Message& message, std::size_t most) {
  return message.withVerbatim([most](const std::string& text) { return plainText(text, most); });
}

void failReading(const std::filesystem::path& file, const Message& reason, const Message& wayOut) {
  constexpr std::size_t longestPart = 200;
  throw Error(Error::Kind::input,
              sentence(file, Message::tr("%1; %2.").arg(plainMessage(reason, longestPart), wayOut)));
}

void failReading(const std::filesystem::path& file, const Error& cause) {
  throw Error(cause.kind(), sentence(file, cause.sentence()));
}

} // namespace limn
