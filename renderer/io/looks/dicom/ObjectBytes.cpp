// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/ObjectBytes.h"

#include "io/reading/ReadError.h"

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctag.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/oflog/oflog.h>

#include <cstddef>
#include <cstdint>
#include <mutex>

namespace limn::dicom {
namespace {

// Where the attributes of a file begin, and how they are encoded.
struct Encoding {
  std::size_t start = 0; ///< behind preamble and meta information
  bool isExplicit = true;
};

constexpr std::size_t preambleBytes = 132;
constexpr std::uint32_t undefinedLength = 0xFFFFFFFF;
constexpr std::uint32_t itemTag = 0xFFFEE000, itemEnd = 0xFFFEE00D, sequenceEnd = 0xFFFEE0DD;
constexpr int deepestLevel = 32;
constexpr int mostElements = 400000;

/// What is wrong with the bytes; becomes the one sentence.
struct NotWhole {};

/// An element before its value (PS3.5 7.1).
struct Header {
  std::uint32_t tag = 0;
  std::uint32_t length = 0;
  bool isSequence = false;
  bool isUnknown = false; ///< VR UN, whose items are encoded implicitly
};

class Walker {
public:
  explicit Walker(std::string_view bytes) : m_bytes(bytes) {}

  /// The transfer syntax in group 0002, which is explicit; `at` moves behind the group.
  std::string_view transferSyntax(std::size_t& at) {
    std::string_view syntax;
    while (at + 8 <= m_bytes.size() && number(at, 2) == 2) {
      const Header header = headerAt(at, m_bytes.size(), true);
      requireRoom(header, at, m_bytes.size());
      if (header.tag == 0x00020010)
        syntax = m_bytes.substr(at, header.length);
      at += header.length;
    }
    return syntax.substr(0, syntax.find_last_not_of(std::string_view(" \0", 2)) + 1);
  }

  /// Elements up to `end`, or, within an item of undefined length, up to its delimiter. Returns where they
  /// end.
  std::size_t elements(std::size_t at, std::size_t end, bool isExplicit, bool isDelimited, int level) {
    if (level > deepestLevel)
      throw NotWhole();
    while (at < end) {
      const std::size_t start = at;
      const Header header = headerAt(at, end, isExplicit);
      if (header.tag == itemEnd && isDelimited)
        return at;
      if (header.tag >> 16 == 0xFFFE || ++m_count > mostElements || at <= start)
        throw NotWhole();
      if (header.length == undefinedLength)
        at = items(at, end, isExplicit && !header.isUnknown, true, level + 1);
      else {
        requireRoom(header, at, end);
        if (header.isSequence)
          items(at, at + header.length, isExplicit, false, level + 1);
        at += header.length;
      }
    }
    if (isDelimited)
      throw NotWhole();
    return at;
  }

private:
  std::size_t items(std::size_t at, std::size_t end, bool isExplicit, bool isDelimited, int level) {
    while (at < end) {
      const Header header = headerAt(at, end, false);
      if (header.tag == sequenceEnd && isDelimited)
        return at;
      if (header.tag != itemTag || ++m_count > mostElements)
        throw NotWhole();
      if (header.length == undefinedLength) {
        at = elements(at, end, isExplicit, true, level + 1);
      } else {
        requireRoom(header, at, end);
        elements(at, at + header.length, isExplicit, false, level + 1);
        at += header.length;
      }
    }
    if (isDelimited)
      throw NotWhole();
    return at;
  }

  static void requireRoom(const Header& header, std::size_t at, std::size_t end) {
    if (header.length > end - at)
      throw NotWhole();
  }

  /// Reads a header and moves behind it. Items and delimiters have no VR.
  Header headerAt(std::size_t& at, std::size_t end, bool isExplicit) const {
    if (end - at < 8)
      throw NotWhole();
    Header header;
    header.tag = number(at, 2) << 16 | number(at + 2, 2);
    if (!isExplicit || header.tag >> 16 == 0xFFFE) {
      header.length = number(at + 4, 4);
      header.isSequence =
          DcmTag(static_cast<Uint16>(header.tag >> 16), static_cast<Uint16>(header.tag)).getEVR() == EVR_SQ;
      at += 8;
      return header;
    }
    static constexpr std::string_view shortKinds =
        "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";
    static constexpr std::string_view longKinds = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    const std::string_view kind = m_bytes.substr(at + 4, 2);
    const bool isShort = isAmong(kind, shortKinds);
    if ((!isShort && !isAmong(kind, longKinds)) || (!isShort && end - at < 12))
      throw NotWhole();
    header.isSequence = kind == "SQ";
    header.isUnknown = kind == "UN";
    header.length = isShort ? number(at + 6, 2) : number(at + 8, 4);
    if (header.length == undefinedLength && !header.isSequence && !header.isUnknown)
      throw NotWhole();
    at += isShort ? 8 : 12;
    return header;
  }

  static bool isAmong(std::string_view kind, std::string_view kinds) {
    for (std::size_t i = 0; i < kinds.size(); i += 3)
      if (kinds.substr(i, 2) == kind)
        return true;
    return false;
  }

  std::uint32_t number(std::size_t at, int count) const {
    std::uint32_t value = 0;
    for (int i = count - 1; i >= 0; --i)
      value = value << 8 | static_cast<unsigned char>(m_bytes[at + static_cast<std::size_t>(i)]);
    return value;
  }

  std::string_view m_bytes;
  int m_count = 0;
};

// Walks over a file before DCMTK does, which makes room for whatever length an element announces: every
// element lies within the item or file that holds it, there are at most 400,000 of them, in at most 32
// levels. Little endian, uncompressed. Throws Error (input).
Encoding requireWholeElements(std::string_view bytes, const std::string& name) {
  Encoding encoding{preambleBytes, true};
  try {
    if (bytes.size() < preambleBytes || bytes.substr(128, 4) != "DICM")
      throw NotWhole();
    Walker walker(bytes);
    const std::string_view syntax = walker.transferSyntax(encoding.start);
    if (syntax != UID_LittleEndianExplicitTransferSyntax && syntax != UID_LittleEndianImplicitTransferSyntax)
      failReading(name, Message::tr("it is compressed as a whole, or big endian"),
                  Message::tr("export it as explicit little endian"));
    encoding.isExplicit = syntax == UID_LittleEndianExplicitTransferSyntax;
    walker.elements(encoding.start, bytes.size(), encoding.isExplicit, false, 0);
  } catch (const NotWhole&) {
    failReading(name, Message::tr("it is no DICOM object, or one that is damaged or cut off"), copyAgain);
  }
  return encoding;
}

constexpr Uint32 longestHeaderValue = 1u << 20;

// What is wrong with a file is said by us, once; DCMTK would print more of it.
void silenceLibrary() {
  static std::once_flag once;
  std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

[[noreturn]] void failMaking() {
  throw Error(Error::Kind::other, Message::tr("The DICOM object cannot be made; please report it."));
}

} // namespace

std::unique_ptr<DcmDataset> objectIn(std::string_view bytes, const std::string& name) {
  silenceLibrary();
  const Encoding encoding = requireWholeElements(bytes, name);
  const std::string_view attributes = bytes.substr(encoding.start);
  auto object = std::make_unique<DcmDataset>();
  DcmInputBufferStream stream;
  stream.setBuffer(attributes.data(), static_cast<offile_off_t>(attributes.size()));
  stream.setEos();
  object->transferInit();
  const OFCondition read = object->read(
      stream, encoding.isExplicit ? EXS_LittleEndianExplicit : EXS_LittleEndianImplicit, EGL_noChange);
  object->transferEnd();
  if (read.bad())
    failReading(name, Message::tr("it is no DICOM object, or one that is damaged or cut off"), copyAgain);
  return object;
}

std::unique_ptr<DcmFileFormat> headerOfFile(const std::filesystem::path& file) {
  silenceLibrary();
  auto object = std::make_unique<DcmFileFormat>();
  const OFCondition read = object->loadFileUntilTag(OFFilename(file.c_str()), EXS_Unknown, EGL_noChange,
                                                    longestHeaderValue, ERM_autoDetect, DCM_PixelData);
  if (read.bad())
    failReading(file, Message::tr("what it says of its patient and study cannot be copied"), copyAgain);
  return object;
}

std::string bytesOf(DcmFileFormat& object) {
  silenceLibrary();
  constexpr E_TransferSyntax syntax = EXS_LittleEndianExplicit;
  const OFCondition prepared = object.validateMetaInfo(syntax);
  std::string bytes(object.calcElementLength(syntax, EET_ExplicitLength) + 1024, '\0');
  DcmOutputBufferStream stream(bytes.data(), static_cast<offile_off_t>(bytes.size()));
  object.transferInit();
  const OFCondition written = object.write(stream, syntax, EET_ExplicitLength, nullptr);
  object.transferEnd();
  void* start = nullptr;
  offile_off_t length = 0;
  stream.flushBuffer(start, length);
  if (prepared.bad() || written.bad() || start != bytes.data())
    failMaking();
  bytes.resize(static_cast<std::size_t>(length));
  return bytes;
}

} // namespace limn::dicom
