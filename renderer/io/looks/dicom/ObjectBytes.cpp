// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/ObjectBytes.h"

#include "io/looks/dicom/WholeElements.h"
#include "io/reading/ReadError.h"

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/oflog/oflog.h>

#include <mutex>

namespace limn::dicom {
namespace {

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
