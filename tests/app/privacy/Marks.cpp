// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/privacy/Marks.h"

#include "support/DicomBuilder.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace limn::test {
namespace {

constexpr int deepest = 3; // a PNG in a page in …
constexpr std::size_t longestStream = std::size_t{64} << 20;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Every second byte zero: first or second.
std::string utf16(const std::string& text, bool bigEndian) {
  std::string wide;
  for (const char c : text) {
    if (bigEndian)
      wide += '\0';
    wide += c;
    if (!bigEndian)
      wide += '\0';
  }
  return wide;
}

// What a zlib or gzip stream that begins here contains; empty where none does.
std::string inflated(const std::string& bytes, std::size_t from) {
  z_stream stream{};
  if (inflateInit2(&stream, MAX_WBITS + 32) != Z_OK)
    return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + from));
  stream.avail_in = static_cast<uInt>(bytes.size() - from);
  std::string plain;
  int status = Z_OK;
  while (status == Z_OK && plain.size() < longestStream) {
    char block[1 << 14];
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof block;
    status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t made = sizeof block - stream.avail_out;
    plain.append(block, made);
    if (made == 0)
      break;
  }
  inflateEnd(&stream);
  return plain;
}

bool mayBeginStream(const std::string& bytes, std::size_t at) {
  const auto first = static_cast<unsigned char>(bytes[at]);
  const auto second = static_cast<unsigned char>(bytes[at + 1]);
  const bool isZlib = (first & 0x0F) == 8 && (first >> 4) <= 7 && (first * 256 + second) % 31 == 0;
  return isZlib || (first == 0x1F && second == 0x8B);
}

bool isBase64(unsigned char c) {
  return std::isalnum(c) || c == '+' || c == '/';
}

std::string decoded(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string plain;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8)
      plain += static_cast<char>(bits >> (count -= 8));
  }
  return plain;
}

// What is packed inside these bytes.
std::vector<std::string> unpacked(const std::string& bytes) {
  std::vector<std::string> inside;
  for (std::size_t i = 0; i + 2 < bytes.size(); ++i)
    if (mayBeginStream(bytes, i))
      if (std::string plain = inflated(bytes, i); plain.size() >= 8)
        inside.push_back(std::move(plain));
  for (std::size_t i = 0; i < bytes.size();) {
    std::size_t end = i;
    while (end < bytes.size() && isBase64(static_cast<unsigned char>(bytes[end])))
      ++end;
    if (end - i >= 16)
      inside.push_back(decoded(bytes.substr(i, end - i)));
    i = end + 1;
  }
  return inside;
}

void search(const std::string& bytes, int depth, std::set<std::string>& found, std::size_t& searched) {
  searched += bytes.size();
  const std::string plain = lower(bytes);
  for (const std::string& mark : patientMarks())
    for (const std::string& form : {lower(mark), utf16(lower(mark), false), utf16(lower(mark), true)})
      if (plain.find(form) != std::string::npos)
        found.insert(mark);
  if (depth < deepest)
    for (const std::string& inside : unpacked(bytes))
      search(inside, depth + 1, found, searched);
}

// The marked attributes beside what a slice needs.
void mark(DicomBuilder& file, int number) {
  file.text(0x00080018, "UI", "1.2.826.99.55503." + std::to_string(number));
  file.text(0x0020000D, "UI", "1.2.826.99.55501").text(0x0020000E, "UI", "1.2.826.99.55502");
  file.text(0x00200052, "UI", "1.2.826.99.55504").text(0x00081155, "UI", "1.2.826.99.55505");
  file.text(0x00100010, "PN", "ZEBEDEE^QUILLON").text(0x00101001, "PN", "OTTOKAR^VEXLEY");
  file.text(0x00100020, "LO", "PID774411").text(0x00101000, "LO", "OTHERID5150");
  file.text(0x00100030, "DA", "19870615").text(0x00101040, "LO", "WRAXLE LANE 9");
  file.text(0x00102154, "SH", "555019977").text(0x00104000, "LT", "COMMENTFLOXY");
  file.text(0x00080020, "DA", "20230917").text(0x00080021, "DA", "20230918");
  file.text(0x00080022, "DA", "20230919").text(0x00080030, "TM", "112233.445566");
  file.text(0x00080050, "SH", "ACC998877").text(0x00080080, "LO", "MERCYHOLM CLINIC");
  file.text(0x00080090, "PN", "YSOLDE^REFERENT").text(0x00081010, "SH", "STATIONXQ");
  file.text(0x00081030, "LO", "STUDYDESCQV").text(0x00081050, "PN", "QUIGLEY^DOCTOR");
  file.text(0x00181000, "LO", "SERIAL86753").text(0x00200010, "SH", "STID3141");
}

} // namespace

const std::vector<std::string>& patientMarks() {
  static const std::vector<std::string> marks{
      "ZEBEDEE",    "QUILLON",    "OTTOKAR",    "VEXLEY",       "PID774411",   "OTHERID5150",   "19870615",
      "1987-06-15", "15.06.1987", "15/06/1987", "WRAXLE",       "555019977",   "COMMENTFLOXY",  "20230917",
      "2023-09-17", "17.09.2023", "20230918",   "2023-09-18",   "20230919",    "112233.445566", "11:22:33",
      "ACC998877",  "MERCYHOLM",  "YSOLDE",     "STATIONXQ",    "STUDYDESCQV", "QUIGLEY",       "SERIAL86753",
      "STID3141",   "1.2.826.99", "2023-09-19", "June 15, 1987"};
  return marks;
}

void writeMarkedSeries(const std::filesystem::path& folder, int slices) {
  constexpr int columns = 24;
  constexpr int rows = 20;
  for (int k = 0; k < slices; ++k) {
    DicomBuilder file;
    file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2").text(0x00080060, "CS", "CT");
    file.text(0x00200013, "IS", std::to_string(k + 1));
    file.text(0x00200032, "DS", "-12\\-10\\" + std::to_string(k));
    file.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0").text(0x00280030, "DS", "1\\1");
    file.us(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2").us(0x00280010, {rows});
    file.us(0x00280011, {columns}).us(0x00280100, {16}).us(0x00280101, {16}).us(0x00280102, {15});
    file.us(0x00280103, {1}).text(0x00281052, "DS", "-1024").text(0x00281053, "DS", "1");
    mark(file, k + 1);
    // A block of bone in air.
    std::vector<std::int16_t> pixels(columns * rows, 24);
    for (int j = 5; j < rows - 5; ++j)
      for (int i = 6; i < columns - 6; ++i)
        pixels[static_cast<std::size_t>(j * columns + i)] =
            k > 2 && k < slices - 3 ? static_cast<std::int16_t>(2000 + 20 * i) : 24;
    file.pixels(pixels).write(folder / ("slice" + std::to_string(k)));
  }
}

std::set<std::string> marksIn(const std::string& bytes, std::size_t& searched) {
  std::set<std::string> found;
  search(bytes, 0, found, searched);
  return found;
}

} // namespace limn::test
