// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/PngWriter.h"

#include <zlib.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <utility>
#include <vector>

// PNG as the World Wide Web Consortium has it (PNG Specification, 2nd ed.): chunks of a length, a type, data
// and a checksum, of which IDAT hold the rows, filtered and deflated as one stream.

namespace limn {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Big-endian, as all numbers in the file.
std::string number(std::uint32_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0})
    bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

// The first problem is kept; what is written after it is dropped.
class PngFile {
public:
  explicit PngFile(const std::string& path) : m_file(std::fopen(path.c_str(), "wb")) {
    if (!m_file)
      m_problem = errno;
  }
  ~PngFile() {
    if (m_file)
      std::fclose(m_file);
  }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  void write(const std::string& bytes) {
    if (m_problem == 0 && std::fwrite(bytes.data(), 1, bytes.size(), m_file) != bytes.size())
      m_problem = errno;
  }
  void writeChunk(const std::string& type, const std::string& data) {
    const std::string checked = type + data;
    const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size());
    write(number(static_cast<std::uint32_t>(data.size())) + checked +
          number(static_cast<std::uint32_t>(sum)));
  }
  std::string close() {
    if (m_file && std::fclose(std::exchange(m_file, nullptr)) != 0 && m_problem == 0)
      m_problem = errno;
    return m_problem == 0 ? std::string() : std::strerror(m_problem);
  }

private:
  std::FILE* m_file;
  int m_problem = 0;
};

// Deflates what it is given into chunks.
class DataChunks {
public:
  explicit DataChunks(PngFile& file) : m_file(file) {
    if (deflateInit(&m_stream, Z_DEFAULT_COMPRESSION) != Z_OK)
      throw std::bad_alloc();
  }
  ~DataChunks() { deflateEnd(&m_stream); }
  DataChunks(const DataChunks&) = delete;
  DataChunks& operator=(const DataChunks&) = delete;

  void add(Bytes& bytes) {
    m_stream.next_in = bytes.data();
    m_stream.avail_in = static_cast<uInt>(bytes.size());
    deflateInto(Z_NO_FLUSH);
  }
  void end() {
    m_stream.avail_in = 0;
    deflateInto(Z_FINISH);
  }

private:
  void deflateInto(int flush) {
    do {
      std::string deflated(std::size_t{1} << 16, '\0');
      m_stream.next_out = reinterpret_cast<Bytef*>(deflated.data());
      m_stream.avail_out = static_cast<uInt>(deflated.size());
      deflate(&m_stream, flush);
      deflated.resize(deflated.size() - m_stream.avail_out);
      if (!deflated.empty())
        m_file.writeChunk("IDAT", deflated);
    } while (m_stream.avail_out == 0);
  }

  PngFile& m_file;
  z_stream m_stream{};
};

// Of the bytes at the left, above, and above at the left the one that is nearest to left + above - both.
int paeth(int left, int above, int corner) {
  const int toLeft = std::abs(above - corner);
  const int toAbove = std::abs(left - corner);
  const int toCorner = std::abs(left + above - 2 * corner);
  if (toLeft <= toAbove && toLeft <= toCorner)
    return left;
  return toAbove <= toCorner ? above : corner;
}

template <int filter>
int predicted(int left, int above, int corner) {
  if constexpr (filter == 1)
    return left;
  else if constexpr (filter == 2)
    return above;
  else if constexpr (filter == 3)
    return (left + above) / 2;
  else if constexpr (filter == 4)
    return paeth(left, above, corner);
  else
    return 0;
}

// A row and the one above it, with zeros where nothing is.
struct Rows {
  const Bytes& row;
  const Bytes& above;
  std::size_t channels;
};

struct Filtered {
  Bytes bytes;                                                   ///< the filter's number comes first
  std::uint64_t sum = std::numeric_limits<std::uint64_t>::max(); ///< of what is left of each byte
};

template <int filter>
void filterWhereLessIsLeft(const Rows& rows, Filtered& least) {
  Filtered tried{Bytes(rows.row.size() + 1), 0};
  tried.bytes[0] = filter;
  for (std::size_t n = 0; n < rows.row.size(); ++n) {
    const bool isFirst = n < rows.channels;
    const int left = isFirst ? 0 : rows.row[n - rows.channels];
    const int corner = isFirst ? 0 : rows.above[n - rows.channels];
    const int rest = static_cast<std::int8_t>(rows.row[n] - predicted<filter>(left, rows.above[n], corner));
    tried.bytes[n + 1] = static_cast<std::uint8_t>(rest);
    tried.sum += static_cast<std::uint64_t>(std::abs(rest));
  }
  if (tried.sum < least.sum)
    least = std::move(tried);
}

Bytes filtered(const Rows& rows) {
  Filtered least;
  filterWhereLessIsLeft<0>(rows, least);
  filterWhereLessIsLeft<1>(rows, least);
  filterWhereLessIsLeft<2>(rows, least);
  filterWhereLessIsLeft<3>(rows, least);
  filterWhereLessIsLeft<4>(rows, least);
  return std::move(least.bytes);
}

void writeColorSpace(PngFile& file) {
  file.writeChunk("gAMA", number(45455)); // 1 / 2.2
  file.writeChunk("sRGB", std::string(1, '\3'));
  // Places of white, red, green and blue in the plane of CIE 1931, times 100,000.
  std::string places;
  for (const std::uint32_t place : {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})
    places += number(place);
  file.writeChunk("cHRM", places);
}

} // namespace

std::string writePng(const std::string& path, const PictureToWrite& picture) {
  PngFile file(path);
  file.write("\x89PNG\r\n\x1A\n");
  // 8 bits a channel, as colours with alpha or without; nothing interlaced.
  file.writeChunk("IHDR", number(static_cast<std::uint32_t>(picture.width)) +
                              number(static_cast<std::uint32_t>(picture.height)) + '\x08' +
                              (picture.hasAlpha ? '\x06' : '\x02') + std::string(3, '\0'));
  writeColorSpace(file);
  if (picture.dotsPerInch > 0.0) {
    const auto dotsPerMetre = static_cast<std::uint32_t>(std::lround(picture.dotsPerInch / 0.0254));
    file.writeChunk("pHYs", number(dotsPerMetre) + number(dotsPerMetre) + '\1');
  }
  if (!picture.description.empty())
    file.writeChunk("tEXt", "Description" + std::string(1, '\0') + picture.description);
  const std::size_t channels = picture.hasAlpha ? 4 : 3;
  const auto* from = static_cast<const std::uint8_t*>(picture.pixels);
  Bytes before(channels * static_cast<std::size_t>(picture.width));
  DataChunks data(file);
  for (int y = 0; y < picture.height; ++y) {
    Bytes row(from, from + before.size());
    Bytes least = filtered({row, before, channels});
    data.add(least);
    from += before.size();
    before = std::move(row);
  }
  data.end();
  file.writeChunk("IEND", {});
  return file.close();
}

} // namespace limn
