// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/pictures/PictureStack.h"
#include "io/reading/ReadError.h"

#include <glm/gtc/packing.hpp>

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <set>
#include <vector>

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr int mostPages = 65535;
constexpr std::uint64_t mostPieces = 1 << 20; // strips or tiles of a page

// Tags of the pieces of a picture: where they lie and how long they are.
constexpr std::uint64_t stripOffsets = 273, stripLengths = 279, tileOffsets = 324, tileLengths = 325;

std::uint64_t bytesOfType(std::uint64_t type) {
  static constexpr std::array<std::uint64_t, 19> bytes = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4,
                                                          8, 4, 8, 4, 0, 0, 8, 8, 8};
  return type < bytes.size() ? bytes[type] : 0;
}

// Where the values of one entry of a directory lie.
struct Entry {
  std::uint64_t tag = 0;
  std::uint64_t width = 0; // bytes of one value
  std::uint64_t count = 0;
  std::uint64_t place = 0;
};

// Walks through a TIFF file in its own byte order.
class TiffDirectories {
public:
  explicit TiffDirectories(const fs::path& file)
      : m_file(file), m_size(fs::file_size(file)), m_stream(file, std::ios::binary) {
    m_isBigEndian = m_stream.get() == 'M';
    m_isBig = number(2, 2) == 43;
    m_wide = m_isBig ? 8 : 4;
  }

  std::uint64_t firstDirectory() { return number(m_isBig ? 8 : 4, m_wide); }

  // Checks the directory at `offset` and returns the place of the one that follows; 0 behind the last.
  std::uint64_t passDirectory(std::uint64_t offset) {
    if (!m_passed.insert(offset).second)
      failCutOff();
    const std::uint64_t head = m_isBig ? 8 : 2;
    const std::uint64_t entryBytes = m_isBig ? 20 : 12;
    const std::uint64_t entries = number(offset, head);
    if (entries > 65536)
      failCutOff();
    const std::string directory = bytesAt(offset + head, entries * entryBytes);
    std::vector<std::uint64_t> places, lengths;
    for (std::uint64_t i = 0; i < entries; ++i) {
      const Entry entry = entryIn(directory, i * entryBytes, offset + head);
      if (entry.tag == stripOffsets || entry.tag == tileOffsets)
        places = valuesOf(entry);
      if (entry.tag == stripLengths || entry.tag == tileLengths)
        lengths = valuesOf(entry);
    }
    if (places.size() != lengths.size())
      failCutOff();
    for (std::size_t i = 0; i < places.size(); ++i)
      requireInside(places[i], lengths[i]);
    return number(offset + head + entries * entryBytes, m_wide);
  }

  [[noreturn]] void failCutOff() const {
    failReading(m_file, Message::tr("its pages are damaged or cut off"), copyAgain);
  }

private:
  void requireInside(std::uint64_t offset, std::uint64_t bytes) const {
    if (offset > m_size || bytes > m_size - offset)
      failCutOff();
  }

  // The entry at `at` in the bytes of a directory, which start at `offset` in the file.
  Entry entryIn(const std::string& directory, std::uint64_t at, std::uint64_t offset) const {
    Entry entry;
    entry.tag = numberIn(directory, at, 2);
    entry.width = bytesOfType(numberIn(directory, at + 2, 2));
    entry.count = numberIn(directory, at + 4, m_wide);
    entry.place = offset + at + 4 + m_wide;
    if (entry.width > 0 && entry.count > m_size / entry.width)
      failCutOff();
    // Values too long for the entry itself lie where it points to.
    if (entry.width * entry.count > m_wide)
      entry.place = numberIn(directory, at + 4 + m_wide, m_wide);
    requireInside(entry.place, entry.width * entry.count);
    return entry;
  }

  std::vector<std::uint64_t> valuesOf(const Entry& entry) {
    if (entry.width == 0)
      return {};
    if (entry.count > mostPieces)
      failCutOff();
    // Pages that share their lists would be read again and again.
    m_listed += entry.width * entry.count;
    if (m_listed > 2 * m_size)
      failCutOff();
    const std::string bytes = bytesAt(entry.place, entry.width * entry.count);
    std::vector<std::uint64_t> values(entry.count);
    for (std::uint64_t i = 0; i < entry.count; ++i)
      values[i] = numberIn(bytes, i * entry.width, entry.width);
    return values;
  }

  std::string bytesAt(std::uint64_t offset, std::uint64_t count) {
    requireInside(offset, count);
    std::string bytes(count, '\0');
    m_stream.seekg(static_cast<std::streamoff>(offset));
    if (!m_stream.read(bytes.data(), static_cast<std::streamsize>(count)))
      failCutOff();
    return bytes;
  }

  std::uint64_t numberIn(const std::string& text, std::uint64_t at, std::uint64_t bytes) const {
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < bytes; ++i)
      value = value << 8 | static_cast<unsigned char>(text[at + (m_isBigEndian ? i : bytes - 1 - i)]);
    return value;
  }

  std::uint64_t number(std::uint64_t offset, std::uint64_t bytes) {
    return numberIn(bytesAt(offset, bytes), 0, bytes);
  }

  fs::path m_file;
  std::uint64_t m_size;
  std::ifstream m_stream;
  bool m_isBigEndian = false;
  bool m_isBig = false;
  std::uint64_t m_wide = 4; // bytes of an offset
  std::set<std::uint64_t> m_passed;
  std::uint64_t m_listed = 0; // bytes of all lists
};

// No strip, tile or table of a file is larger; a header that asks for more is damaged.
constexpr tmsize_t largestPiece = tmsize_t{256} << 20;

// An open file, and what the library last complained of.
struct Tiff {
  fs::path file;
  std::string complaint;
  bool isMended = false;
  std::unique_ptr<TIFF, decltype(&TIFFClose)> handle{nullptr, &TIFFClose};

  [[noreturn]] void fail() const {
    failReading(file,
                complaint.empty() ? Message::tr("the picture is damaged")
                                  : Message::tr("the picture is damaged (%1)").arg(complaint),
                copyAgain);
  }
};

int keepComplaint(TIFF*, void* tiff, const char*, const char* format, va_list arguments) {
  char text[160];
  std::vsnprintf(text, sizeof text, format, arguments);
  static_cast<Tiff*>(tiff)->complaint = text;
  return 1;
}

// The library mends lengths of strips that contradict the size of the picture, and reads what is no pixel.
int noteMending(TIFF*, void* tiff, const char*, const char* format, va_list) {
  if (std::strstr(format, "Bogus"))
    static_cast<Tiff*>(tiff)->isMended = true;
  return 1;
}

// Opens without mapping the file into memory: it may be cut while it is read.
void open(Tiff& tiff) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 &TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepComplaint, &tiff);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), noteMending, &tiff);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), largestPiece);
  tiff.handle.reset(TIFFOpenExt(tiff.file.c_str(), "rm", options.get()));
  if (!tiff.handle)
    tiff.fail();
}

// How the samples of a page are written.
struct Layout {
  int bits = 1;
  int samples = 1; ///< of a pixel
  int meaning = PHOTOMETRIC_MINISBLACK;
  bool isHalf = false;
  bool isPlanar = false;
  bool isTiled = false;
  const std::uint16_t* palette[3] = {};
};

template <class T>
T field(TIFF* handle, std::uint32_t tag, T otherwise) {
  T value = otherwise;
  TIFFGetFieldDefaulted(handle, tag, &value);
  return value;
}

Layout layoutOf(const Tiff& tiff) {
  TIFF* handle = tiff.handle.get();
  Layout layout;
  layout.bits = field<std::uint16_t>(handle, TIFFTAG_BITSPERSAMPLE, 1);
  layout.samples = field<std::uint16_t>(handle, TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.meaning = field<std::uint16_t>(handle, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  layout.isHalf =
      field<std::uint16_t>(handle, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT) == SAMPLEFORMAT_IEEEFP &&
      layout.bits == 16;
  layout.isPlanar = layout.samples > 1 && field<std::uint16_t>(handle, TIFFTAG_PLANARCONFIG,
                                                               PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE;
  layout.isTiled = TIFFIsTiled(handle) != 0;
  if (layout.meaning == PHOTOMETRIC_YCBCR &&
      field<std::uint16_t>(handle, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_JPEG &&
      TIFFSetField(handle, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB))
    layout.meaning = PHOTOMETRIC_RGB;
  if (layout.meaning == PHOTOMETRIC_PALETTE &&
      !TIFFGetField(handle, TIFFTAG_COLORMAP, &layout.palette[0], &layout.palette[1], &layout.palette[2]))
    tiff.fail();
  return layout;
}

VoxelType typeOf(const Tiff& tiff, const Layout& layout) {
  const int format = field<std::uint16_t>(tiff.handle.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const bool isSigned = format == SAMPLEFORMAT_INT;
  const bool isReal = format == SAMPLEFORMAT_IEEEFP;
  if (isReal && layout.bits == 64)
    return VoxelType::float64;
  if (isReal && (layout.bits == 16 || layout.bits == 32))
    return VoxelType::float32;
  const bool isWhole = isSigned || format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID;
  if (isWhole && (layout.bits == 8 || layout.bits == 1))
    return isSigned ? VoxelType::int8 : VoxelType::uint8;
  if (isWhole && layout.bits == 16)
    return isSigned ? VoxelType::int16 : VoxelType::uint16;
  if (isWhole && layout.bits == 32)
    return isSigned ? VoxelType::int32 : VoxelType::uint32;
  if (isWhole && layout.bits == 64)
    return isSigned ? VoxelType::int64 : VoxelType::uint64;
  failReading(tiff.file, Message::tr("its samples are of a type that is not supported"),
              Message::tr("convert it to 8 or 16 bits first"));
}

PictureShape shapeOf(const Tiff& tiff, const Layout& layout) {
  const auto width = field<std::uint32_t>(tiff.handle.get(), TIFFTAG_IMAGEWIDTH, 0);
  const auto height = field<std::uint32_t>(tiff.handle.get(), TIFFTAG_IMAGELENGTH, 0);
  PictureShape shape;
  shape.width = dimension(tiff.file, width);
  shape.height = dimension(tiff.file, height);
  shape.type = typeOf(tiff, layout);
  const bool isGrey = layout.meaning == PHOTOMETRIC_MINISBLACK || layout.meaning == PHOTOMETRIC_MINISWHITE;
  const bool isPalette = layout.meaning == PHOTOMETRIC_PALETTE && layout.bits == 8 && layout.samples == 1;
  const bool isColour =
      layout.meaning == PHOTOMETRIC_RGB && (layout.samples == 3 || layout.samples == 4) && layout.bits >= 8;
  if (!(isGrey && layout.samples <= 2 && (layout.bits >= 8 || layout.samples == 1)) && !isPalette &&
      !isColour)
    failReading(
        tiff.file,
        Message::tr("it holds %1 values per pixel of a kind that is not supported").arg(layout.samples),
        Message::tr("convert it to grey or RGB first"));
  shape.channels = isPalette ? 3 : layout.samples;
  requireRoom(tiff.file, shape);
  return shape;
}

// Reads the rows of a page in the file's own layout, in order.
class RawRows {
public:
  RawRows(const Tiff& tiff, const Layout& layout, const PictureShape& shape)
      : m_tiff(tiff), m_layout(layout), m_shape(shape),
        m_bytes((static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(layout.samples) *
                     static_cast<std::size_t>(layout.bits) +
                 7) /
                8) {
    if (!layout.isTiled && !layout.isPlanar && TIFFScanlineSize64(m_tiff.handle.get()) != m_bytes)
      m_tiff.fail();
  }

  std::size_t bytes() const { return m_bytes; }

  // The bytes of row `y`, valid until the next is asked for.
  const unsigned char* row(int y) {
    if (!m_layout.isTiled && !m_layout.isPlanar) {
      m_band.resize(m_bytes);
      if (TIFFReadScanline(m_tiff.handle.get(), m_band.data(), static_cast<std::uint32_t>(y)) < 0)
        m_tiff.fail();
      return m_band.data();
    }
    if (y >= m_bandEnd)
      readBand(y);
    return m_band.data() + static_cast<std::size_t>(y - m_bandStart) * m_bytes;
  }

private:
  // Reads the strips or tiles from row `y` on.
  void readBand(int y) {
    TIFF* handle = m_tiff.handle.get();
    const auto tag = m_layout.isTiled ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP;
    const auto rows = field<std::uint32_t>(handle, tag, 0);
    const auto width = m_layout.isTiled ? field<std::uint32_t>(handle, TIFFTAG_TILEWIDTH, 0)
                                        : static_cast<std::uint32_t>(m_shape.width);
    if (rows == 0 || width == 0 || m_layout.bits < 8)
      m_tiff.fail();
    m_bandStart = y;
    m_bandEnd = static_cast<int>(std::min<std::int64_t>(std::int64_t{y} + rows, m_shape.height));
    const tmsize_t pieceBytes = m_layout.isTiled ? TIFFTileSize(handle) : TIFFStripSize(handle);
    const std::size_t samples = m_layout.isPlanar ? 1 : static_cast<std::size_t>(m_layout.samples);
    const std::size_t pieceRow = width * samples * static_cast<std::size_t>(m_layout.bits) / 8;
    const auto bandRows = static_cast<std::size_t>(m_bandEnd - m_bandStart);
    if (pieceBytes <= 0 || pieceBytes > largestPiece ||
        static_cast<std::size_t>(pieceBytes) < pieceRow * bandRows)
      m_tiff.fail();
    m_piece.resize(static_cast<std::size_t>(pieceBytes));
    m_band.resize(m_bytes * bandRows);
    const int planes = m_layout.isPlanar ? m_layout.samples : 1;
    for (int plane = 0; plane < planes; ++plane)
      for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(m_shape.width); x += width) {
        readPiece(x, y, plane, static_cast<tmsize_t>(pieceRow * bandRows));
        placePiece(x, plane, pieceRow, std::min(width, static_cast<std::uint32_t>(m_shape.width) - x),
                   samples);
      }
  }

  void readPiece(std::uint32_t x, int y, int plane, tmsize_t least) {
    TIFF* handle = m_tiff.handle.get();
    const auto row = static_cast<std::uint32_t>(y);
    const auto sample = static_cast<std::uint16_t>(plane);
    const auto size = static_cast<tmsize_t>(m_piece.size());
    const tmsize_t got =
        m_layout.isTiled
            ? TIFFReadEncodedTile(handle, TIFFComputeTile(handle, x, row, 0, sample), m_piece.data(), size)
            : TIFFReadEncodedStrip(handle, TIFFComputeStrip(handle, row, sample), m_piece.data(), size);
    if (got < least)
      m_tiff.fail();
  }

  // Copies `columns` columns of the piece to column `x` of the band, interleaving planes.
  void placePiece(std::uint32_t x, int plane, std::size_t pieceRow, std::uint32_t columns,
                  std::size_t samples) {
    const std::size_t width = static_cast<std::size_t>(m_layout.bits) / 8;
    const auto all = static_cast<std::size_t>(m_layout.samples);
    for (std::size_t row = 0; row < static_cast<std::size_t>(m_bandEnd - m_bandStart); ++row)
      for (std::size_t column = 0; column < columns; ++column)
        std::memcpy(m_band.data() + row * m_bytes +
                        ((x + column) * all + static_cast<std::size_t>(plane)) * width,
                    m_piece.data() + row * pieceRow + column * samples * width, samples * width);
  }

  const Tiff& m_tiff;
  Layout m_layout;
  PictureShape m_shape;
  std::size_t m_bytes; // of a row
  std::vector<unsigned char> m_band;
  std::vector<unsigned char> m_piece;
  int m_bandStart = 0;
  int m_bandEnd = 0;
};

// Turns a row as written into samples of the shape's type.
void convertRow(const Layout& layout, const PictureShape& shape, const unsigned char* raw, std::size_t bytes,
                unsigned char* to) {
  const auto width = static_cast<std::size_t>(shape.width);
  if (layout.meaning == PHOTOMETRIC_PALETTE) {
    for (std::size_t i = 0; i < width; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        to[3 * i + c] = static_cast<unsigned char>(layout.palette[c][raw[i]] >> 8);
  } else if (layout.bits == 1) {
    for (std::size_t i = 0; i < width; ++i)
      to[i] = (raw[i / 8] >> (7 - i % 8) & 1) ? 255 : 0;
  } else if (layout.isHalf) {
    for (std::size_t i = 0; i < width * static_cast<std::size_t>(shape.channels); ++i) {
      std::uint16_t half = 0;
      std::memcpy(&half, raw + 2 * i, sizeof half);
      const float value = glm::unpackHalf1x16(half);
      std::memcpy(to + 4 * i, &value, sizeof value);
    }
  } else {
    std::memcpy(to, raw, bytes);
  }
  const bool isUnsigned = shape.type == VoxelType::uint8 || shape.type == VoxelType::uint16 ||
                          shape.type == VoxelType::uint32 || shape.type == VoxelType::uint64;
  if (layout.meaning == PHOTOMETRIC_MINISWHITE && isUnsigned)
    for (std::size_t i = 0; i < rowBytes(shape); ++i)
      to[i] = static_cast<unsigned char>(~to[i]);
}

Picture pageOf(const Tiff& tiff) {
  if (tiff.isMended)
    failReading(tiff.file, Message::tr("its pages are damaged or cut off"), copyAgain);
  const Layout layout = layoutOf(tiff);
  Picture picture;
  picture.shape = shapeOf(tiff, layout);
  auto rows = std::make_shared<RawRows>(tiff, layout, picture.shape);
  picture.readRows = [rows, layout, shape = picture.shape](unsigned char* to, int first, int count) {
    for (int y = first; y < first + count; ++y, to += rowBytes(shape))
      convertRow(layout, shape, rows->row(y), rows->bytes(), to);
  };
  return picture;
}

} // namespace

int tiffPages(const fs::path& file) {
  TiffDirectories tiff(file);
  int pages = 0;
  for (std::uint64_t at = tiff.firstDirectory(); at != 0; at = tiff.passDirectory(at))
    if (++pages > mostPages)
      tiff.failCutOff();
  return pages;
}

void forEachTiffPage(const fs::path& file, const std::function<void(const Picture&)>& use) {
  const int pages = tiffPages(file);
  Tiff tiff;
  tiff.file = file;
  open(tiff);
  for (int page = 0; page < pages; ++page) {
    if (page > 0 && !TIFFReadDirectory(tiff.handle.get()))
      tiff.fail();
    use(pageOf(tiff));
  }
}

} // namespace limn
