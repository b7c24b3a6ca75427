// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/vtk/VtkXmlText.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestXml = 16 << 20;
constexpr std::string_view appendedTag = "<AppendedData";

class Scanner {
public:
  explicit Scanner(const fs::path& file) : m_file(file), m_buffer(1 << 16) {
    m_stream.rdbuf()->pubsetbuf(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
    m_stream.open(file, std::ios::binary);
  }

  VtkXmlText scanned() {
    for (int c = take(); c != end; c = take()) {
      if (c != '<') {
        noteText(c);
        continue;
      }
      writePlace();
      const std::string tag = takeTag();
      if (tag.starts_with(appendedTag)) {
        findAppended(tag);
        return std::move(m_result);
      }
      m_result.xml += tag;
      if (m_result.xml.size() > longestXml)
        failDamaged();
    }
    writePlace();
    return std::move(m_result);
  }

private:
  static constexpr int end = std::char_traits<char>::eof();

  [[noreturn]] void failDamaged() const {
    failReading(m_file, Message::tr("its text is cut off or damaged"), copyAgain);
  }

  int take() {
    const int c = m_stream.rdbuf()->sbumpc();
    m_position += c == end ? 0 : 1;
    return c;
  }

  void noteText(int c) {
    const bool isBlank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (isBlank && m_text.length == 0)
      return;
    if (m_text.length == 0)
      m_text.offset = m_position - 1;
    m_text.length = m_position - m_text.offset;
  }

  void writePlace() {
    if (m_text.length > 0)
      m_result.xml += std::to_string(m_text.offset) + " " + std::to_string(m_text.length);
    m_text = {};
  }

  // A tag, comment or declaration; what is quoted in a tag may hold a closing bracket.
  std::string takeTag() {
    std::string tag = "<";
    char quote = 0;
    while (true) {
      const int c = take();
      if (c == end || tag.size() > longestXml)
        failDamaged();
      tag += static_cast<char>(c);
      const bool isComment = tag.starts_with("<!--");
      if (!isComment && quote == 0 && (c == '"' || c == '\''))
        quote = static_cast<char>(c);
      else if (c == quote)
        quote = 0;
      else if (c == '>' && quote == 0 && (!isComment || (tag.size() >= 7 && tag.ends_with("-->"))))
        return tag;
    }
  }

  // The appended bytes start behind an underscore.
  void findAppended(const std::string& tag) {
    int c = take();
    while (c != end && c != '_')
      c = take();
    if (c == end)
      failReading(m_file, Message::tr("its appended data are missing"), copyAgain);
    m_result.appended = m_position;
    m_result.appendedIsBase64 = tag.find("\"raw\"") == std::string::npos;
  }

  fs::path m_file;
  std::vector<char> m_buffer; // outlives the stream that fills it
  std::ifstream m_stream;
  std::uint64_t m_position = 0;
  VtkXmlRun m_text;
  VtkXmlText m_result;
};

} // namespace

VtkXmlText readVtkXmlText(const fs::path& file) {
  return Scanner(file).scanned();
}

VtkXmlRun runOf(const std::string& placeText) {
  VtkXmlRun run;
  const char* const last = placeText.data() + placeText.size();
  const auto first = std::from_chars(placeText.data(), last, run.offset);
  if (first.ec != std::errc{} || first.ptr == last ||
      std::from_chars(first.ptr + 1, last, run.length).ec != std::errc{})
    return {};
  return run;
}

ByteReader bytesOfRun(const fs::path& file, const VtkXmlRun& run) {
  const ByteReader bytes = openBytes({file, run.offset}, run.length);
  return [bytes, left = run.length](unsigned char* to, std::size_t count) mutable {
    const std::size_t got = bytes(to, static_cast<std::size_t>(std::min<std::uint64_t>(count, left)));
    left -= got;
    return got;
  };
}

} // namespace limn
