// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/PdfDescription.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace limn {
namespace {

constexpr std::string_view before = "<limn:description>";
constexpr std::string_view behind = "</limn:description>";
constexpr std::size_t longestDescription = 16u << 20;

// Outside of markup and comments; a quotation mark may stand as it is.
constexpr std::array<std::pair<std::string_view, char>, 3> entities{
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}}};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) {
    const auto entity = std::ranges::find(entities, character, &decltype(entities)::value_type::second);
    if (entity != entities.end())
      result += entity->first;
    else
      result += character;
  }
  return result;
}

std::string unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto entity = std::ranges::find_if(
        entities, [&](const auto& candidate) { return text.starts_with(candidate.first); });
    result += entity == entities.end() ? text.front() : entity->second;
    text.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
  }
  return result;
}

// What stands from the stream's place up to a mark, which is passed; nothing where it is not there or lies
// beyond `limit`. Reads pieces, because a figure can be large.
std::optional<std::string> upTo(std::istream& stream, std::string_view mark, std::size_t limit, bool keeps) {
  std::string passed;
  std::size_t read = 0;
  std::vector<char> piece(1u << 16);
  while (read < limit) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (count == 0)
      return std::nullopt;
    const std::size_t from = passed.size() < mark.size() ? 0 : passed.size() - mark.size();
    passed.append(piece.data(), count);
    read += count;
    if (const std::size_t found = passed.find(mark, from); found != std::string::npos) {
      const std::size_t behindMark = passed.size() - found - mark.size();
      stream.clear();
      stream.seekg(-static_cast<std::streamoff>(behindMark), std::ios::cur);
      return passed.substr(0, found);
    }
    if (!keeps && passed.size() > mark.size())
      passed.erase(0, passed.size() - mark.size());
  }
  return std::nullopt;
}

} // namespace

std::string pdfMetadata(const std::string& description) {
  return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
         "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\" xmlns:limn=\"urn:limn:figure\">\n" +
         std::string(before) + escaped(description) + std::string(behind) +
         "\n</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>\n";
}

bool isPdf(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown))
    return false;
  std::array<char, 5> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return std::string_view(start.data(), start.size()) == "%PDF-";
}

std::string readPdfDescription(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!upTo(file, before, std::string::npos, false))
    return {};
  const std::optional<std::string> found = upTo(file, behind, longestDescription, true);
  return found ? unescaped(*found) : std::string();
}

} // namespace limn
