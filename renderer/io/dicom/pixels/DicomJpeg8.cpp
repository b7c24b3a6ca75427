// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/pixels/DicomJpeg.h"

#include <cstdio>

extern "C" {
#include <gdcmjpeg/8/jpeglib.h>

#include <gdcmjpeg/8/jerror.h>
}

#include "io/dicom/pixels/DicomJpegDecoder.inl"

namespace limn {

JpegPicture decodeJpeg8(const std::vector<unsigned char>& stream) {
  return decodeJpeg(stream);
}

} // namespace limn
