// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/voxels/Bytes.h"

#include "io/reading/ReadError.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

// Deflate codes at best 258 bytes in 2 bits: no stream is longer than 1032 times its code.
constexpr std::uint64_t largestDeflateRatio = 1032;

std::ifstream openFile(const fs::path& file) {
  std::error_code problem;
  if (fs::is_directory(file, problem))
    failReading(file, Message::tr("it is a folder where a file is needed"), Message::tr("choose a file"));
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    failReading(file, std::strerror(errno), Message::tr("check the name and the right to read it"));
  return stream;
}

std::uint64_t sizeOf(const fs::path& file) {
  std::error_code problem;
  const auto size = fs::file_size(file, problem);
  if (problem)
    failReading(file, problem.message(), Message::tr("check the name and the right to read it"));
  return size;
}

// Inflates a file from its current position.
class Inflater {
public:
  Inflater(fs::path file, std::ifstream stream) : m_file(std::move(file)), m_stream(std::move(stream)) {
    if (inflateInit2(&m_zlib, MAX_WBITS + 32) != Z_OK)
      throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&m_zlib); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  std::size_t read(unsigned char* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count && !m_ended) {
      const auto step =
          static_cast<uInt>(std::min<std::size_t>(count - done, std::numeric_limits<uInt>::max()));
      m_zlib.next_out = to + done;
      m_zlib.avail_out = step;
      inflateSome();
      done += step - m_zlib.avail_out;
    }
    return done;
  }

private:
  void inflateSome() {
    refill();
    const int status = inflate(&m_zlib, Z_NO_FLUSH);
    if (status == Z_STREAM_END)
      startNextMember();
    else if (status == Z_BUF_ERROR && m_zlib.avail_in == 0)
      m_ended = true;
    else if (status != Z_OK)
      failReading(m_file, Message::tr("its compressed data are damaged"), copyAgain);
  }

  void refill() {
    if (m_zlib.avail_in > 0)
      return;
    m_stream.read(reinterpret_cast<char*>(m_input.data()), static_cast<std::streamsize>(m_input.size()));
    m_zlib.next_in = m_input.data();
    m_zlib.avail_in = static_cast<uInt>(m_stream.gcount());
  }

  // A gzip file may be several written one after the other; whatever else follows is no data.
  void startNextMember() {
    refill();
    if (m_zlib.avail_in > 0 && m_zlib.next_in[0] == 0x1f)
      inflateReset(&m_zlib);
    else
      m_ended = true;
  }

  fs::path m_file;
  std::ifstream m_stream;
  z_stream m_zlib{};
  std::array<unsigned char, 1 << 16> m_input{};
  bool m_ended = false;
};

ByteReader inflatingReader(const fs::path& file, std::ifstream stream) {
  auto inflater = std::make_shared<Inflater>(file, std::move(stream));
  return [inflater](unsigned char* to, std::size_t count) { return inflater->read(to, count); };
}

ByteReader plainReader(std::ifstream opened) {
  auto stream = std::make_shared<std::ifstream>(std::move(opened));
  return [stream](unsigned char* to, std::size_t count) {
    stream->read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(stream->gcount());
  };
}

void skipBytes(const ByteReader& reader, std::uint64_t count) {
  std::vector<unsigned char> sink(1 << 16);
  while (count > 0) {
    const std::size_t step = static_cast<std::size_t>(std::min<std::uint64_t>(count, sink.size()));
    if (reader(sink.data(), step) < step)
      return;
    count -= step;
  }
}

void requireRoom(const ByteLocation& location, std::uint64_t needed) {
  const std::uint64_t size = sizeOf(location.file);
  const std::uint64_t held = size > location.offset ? size - location.offset : 0;
  const std::uint64_t wanted = location.skip + needed;
  const bool fits =
      location.encoding == Encoding::raw ? wanted <= held : wanted / largestDeflateRatio <= held;
  if (!fits)
    failReading(location.file,
                Message::tr("its header asks for %1 bytes of voxels, but the file holds only %2%3")
                    .arg(wanted, held,
                         location.encoding == Encoding::raw ? Message() : Message::tr(" compressed ones")),
                copyAgain);
}

} // namespace

ByteReader openBytes(const ByteLocation& location, std::uint64_t needed) {
  std::ifstream stream = openFile(location.file);
  requireRoom(location, needed);
  if (location.encoding == Encoding::raw) {
    stream.seekg(static_cast<std::streamoff>(location.offset + location.skip));
    return plainReader(std::move(stream));
  }
  stream.seekg(static_cast<std::streamoff>(location.offset));
  ByteReader reader = inflatingReader(location.file, std::move(stream));
  skipBytes(reader, location.skip);
  return reader;
}

void moveToLast(std::uint64_t bytes, ByteLocation& location) {
  const std::uint64_t size = sizeOf(location.file);
  if (size < location.offset || size - location.offset < bytes)
    failReading(location.file, Message::tr("its voxels end early"), copyAgain);
  location.offset = size - bytes;
}

std::string firstBytes(const fs::path& file, std::size_t count) {
  const bool compressed = isGzip(file);
  std::ifstream stream = openFile(file);
  const ByteReader reader =
      compressed ? inflatingReader(file, std::move(stream)) : plainReader(std::move(stream));
  std::string bytes(compressed ? count : std::min<std::uint64_t>(count, sizeOf(file)), '\0');
  bytes.resize(reader(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size()));
  return bytes;
}

bool isGzip(const fs::path& file) {
  std::ifstream stream = openFile(file);
  std::array<char, 2> magic{};
  stream.read(magic.data(), magic.size());
  return stream.gcount() == 2 && magic[0] == '\x1f' && magic[1] == '\x8b';
}

fs::path detachedFile(const fs::path& header, const std::string& name) {
  if (name.starts_with("LIST") || name.find('%') != std::string::npos)
    failReading(header, Message::tr("its voxels are spread over several files"),
                Message::tr("save it as one file"));
  const fs::path relative(name);
  const fs::path normal = relative.lexically_normal();
  if (name.empty() || relative.is_absolute() || normal.empty() || *normal.begin() == "..")
    failReading(
        header,
        Message::tr("it names its voxel file \"%1\", which is not in the folder of the header").arg(name),
        Message::tr("put both files into one folder and name the voxel file without a path"));
  fs::path file = header.parent_path() / normal;
  std::error_code problem;
  if (!fs::is_regular_file(file, problem))
    failReading(header, Message::tr("its voxel file %1 is missing").arg(file.string()),
                Message::tr("copy that file beside the header"));
  if (fs::equivalent(header, file))
    failReading(header, Message::tr("it names itself as its voxel file"), copyAgain);
  const fs::path inside =
      fs::canonical(file).lexically_relative(fs::canonical(absolute(header).parent_path()));
  if (inside.empty() || *inside.begin() == "..")
    failReading(header, Message::tr("its voxel file \"%1\" is a link that leads out of the folder").arg(name),
                Message::tr("replace the link by the file itself"));
  return file;
}

} // namespace limn
