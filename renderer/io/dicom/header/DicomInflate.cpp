// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomParser.h"

#include "scene/basics/Error.h"

#include <cstdint>
#include <new>
#include <streambuf>
#include <vector>

#include <zlib.h>

namespace limn {
namespace {

constexpr std::uint64_t mostBytes = std::uint64_t{1} << 30;
constexpr int rawDeflate = -15;

// The state of zlib, given back also where opening fails.
struct Inflater {
  z_stream zlib{};
  Inflater() {
    if (inflateInit2(&zlib, rawDeflate) != Z_OK)
      throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&zlib); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
};

// Holds a window of what the deflated bytes behind `m_start` mean.
class InflatingBuffer : public std::streambuf {
public:
  InflatingBuffer(std::unique_ptr<std::istream> in, std::string file)
      : m_in(std::move(in)), m_file(std::move(file)), m_start(m_in->tellg()), m_input(1 << 16),
        m_window(1 << 18) {
    while (fill())
      if (m_begin + m_held > mostBytes)
        throw Error(
            Error::Kind::input,
            Message::tr(
                "The deflated DICOM file %1 inflates to more than 1 GiB; decompress it with another tool.")
                .arg(m_file));
    m_length = m_begin + m_held;
    restart();
  }

protected:
  int_type underflow() override { return fill() ? traits_type::to_int_type(*gptr()) : traits_type::eof(); }

  pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
    const auto here = static_cast<off_type>(m_begin) + (gptr() - eback());
    const off_type base = from == std::ios::beg   ? 0
                          : from == std::ios::cur ? here
                                                  : static_cast<off_type>(m_length);
    return seekpos(base + offset, std::ios::in);
  }

  pos_type seekpos(pos_type target, std::ios::openmode) override {
    const off_type offset = target;
    if (offset < 0 || static_cast<std::uint64_t>(offset) > m_length)
      return pos_type(off_type(-1));
    const auto place = static_cast<std::uint64_t>(offset);
    if (place < m_begin)
      restart();
    while (place > m_begin + m_held)
      if (!fill())
        return pos_type(off_type(-1));
    setg(eback(), eback() + (place - m_begin), egptr());
    return target;
  }

private:
  void restart() {
    m_in->clear();
    m_in->seekg(m_start);
    inflateReset(&m_zlib);
    m_zlib.avail_in = 0;
    m_isEnded = false;
    m_begin = m_held = 0;
    setg(m_window.data(), m_window.data(), m_window.data());
  }

  // Puts the bytes that follow into the window; false behind the last.
  bool fill() {
    m_begin += m_held;
    m_held = 0;
    m_zlib.next_out = reinterpret_cast<Bytef*>(m_window.data());
    m_zlib.avail_out = static_cast<uInt>(m_window.size());
    while (m_zlib.avail_out > 0 && !m_isEnded)
      inflateSome();
    m_held = m_window.size() - m_zlib.avail_out;
    setg(m_window.data(), m_window.data(), m_window.data() + m_held);
    return m_held > 0;
  }

  void inflateSome() {
    if (m_zlib.avail_in == 0) {
      m_in->read(m_input.data(), static_cast<std::streamsize>(m_input.size()));
      m_zlib.next_in = reinterpret_cast<Bytef*>(m_input.data());
      m_zlib.avail_in = static_cast<uInt>(m_in->gcount());
    }
    const int status = ::inflate(&m_zlib, Z_NO_FLUSH);
    // A buffer error is the end of the input before the end of the data: what uses it checks its lengths.
    m_isEnded = status != Z_OK;
    if (m_isEnded && status != Z_STREAM_END && status != Z_BUF_ERROR)
      throw Error(
          Error::Kind::input,
          Message::tr("The deflated DICOM file %1 is damaged: its data cannot be inflated; copy it again.")
              .arg(m_file));
  }

  std::unique_ptr<std::istream> m_in;
  std::string m_file;
  std::streampos m_start;
  std::vector<char> m_input;
  std::vector<char> m_window;
  Inflater m_inflater;
  z_stream& m_zlib = m_inflater.zlib;
  std::uint64_t m_begin = 0; // of the window, in the inflated bytes
  std::uint64_t m_held = 0;  // bytes in the window
  std::uint64_t m_length = 0;
  bool m_isEnded = false;
};

// A stream that owns its buffer.
class InflatingStream : public std::istream {
public:
  InflatingStream(std::unique_ptr<std::istream> packed, const std::string& file)
      : std::istream(nullptr), m_buffer(std::move(packed), file) {
    rdbuf(&m_buffer);
  }

private:
  InflatingBuffer m_buffer;
};

} // namespace

std::unique_ptr<std::istream> inflated(std::unique_ptr<std::istream> in, const std::string& file) {
  return std::make_unique<InflatingStream>(std::move(in), file);
}

} // namespace limn
