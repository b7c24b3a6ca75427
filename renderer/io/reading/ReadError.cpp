// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/ReadError.h"

namespace limn {
namespace {

std::string sentence(const std::filesystem::path& file, const std::string& rest) {
  return "Cannot read " + plainText(file.string()) + ": " + rest;
}

} // namespace

std::string plainText(std::string text, std::size_t most) {
  for (char& c : text)
    c = (c >= 0 && c < ' ') || c == 0x7f ? '?' : c;
  if (text.size() <= most)
    return text;
  // Not within a letter of several bytes.
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80)
    --most;
  return text.substr(0, most) + "…";
}

void failReading(const std::filesystem::path& file, const std::string& reason, const std::string& wayOut) {
  constexpr std::size_t longestReason = 300;
  throw Error(Error::Kind::input, sentence(file, plainText(reason, longestReason) + "; " + wayOut + "."));
}

void failReading(const std::filesystem::path& file, const Error& cause) {
  throw Error(cause.kind(), sentence(file, cause.what()));
}

} // namespace limn
