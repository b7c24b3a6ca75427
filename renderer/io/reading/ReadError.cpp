// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/ReadError.h"

#include "io/reading/PlainText.h"

namespace limn {
namespace {

std::string sentence(const std::filesystem::path& file, const std::string& rest) {
  return "Cannot read " + plainText(file.string()) + ": " + rest;
}

} // namespace

void failReading(const std::filesystem::path& file, const std::string& reason, const std::string& wayOut) {
  constexpr std::size_t longestReason = 300;
  throw Error(Error::Kind::input, sentence(file, plainText(reason, longestReason) + "; " + wayOut + "."));
}

void failReading(const std::filesystem::path& file, const Error& cause) {
  throw Error(cause.kind(), sentence(file, cause.what()));
}

} // namespace limn
