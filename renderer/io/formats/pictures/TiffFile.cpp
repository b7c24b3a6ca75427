// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/pictures/Picture.h"

#include "io/reading/ReadError.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstring>
#include <memory>

#include <tiffio.h>

namespace limn {
namespace {

namespace fs = std::filesystem;

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
