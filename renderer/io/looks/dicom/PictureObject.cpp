// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/PictureObject.h"

#include "io/looks/dicom/References.h"
#include "io/looks/dicom/SrgbProfile.h"

namespace limn::dicom {
namespace {

void putPixels(DcmItem& object, const BytePicture& picture) {
  putCount(object, DCM_SamplesPerPixel, 3);
  putText(object, DCM_PhotometricInterpretation, "RGB");
  putCount(object, DCM_PlanarConfiguration, 0);
  putCount(object, DCM_Rows, picture.size.y);
  putCount(object, DCM_Columns, picture.size.x);
  putCount(object, DCM_BitsAllocated, 8);
  putCount(object, DCM_BitsStored, 8);
  putCount(object, DCM_HighBit, 7);
  putCount(object, DCM_PixelRepresentation, 0);
  std::vector<std::uint8_t> bytes = picture.bytes;
  if (bytes.size() % 2 != 0)
    bytes.push_back(0); // a value has an even length
  require(object
              .putAndInsertUint8Array(DcmTag(DCM_PixelData, EVR_OB), bytes.data(),
                                      static_cast<unsigned long>(bytes.size()))
              .good(),
          DCM_PixelData);
  putSrgb(object);
}

// Once lossy, always lossy: a picture of such images is one as well.
void putCompression(DcmItem& object, DcmItem& image) {
  if (textIn(image, DCM_LossyImageCompression) != "01")
    return;
  putText(object, DCM_LossyImageCompression, "01");
  for (const DcmTagKey& tag : {DCM_LossyImageCompressionRatio, DCM_LossyImageCompressionMethod})
    if (holds(image, tag))
      putText(object, tag, textIn(image, tag));
}

} // namespace

void putPicture(DcmItem& object, DcmItem& image, const DicomWriting& writing) {
  putText(object, DCM_ConversionType, "WSD"); // workstation
  putText(object, DCM_ImageType, "DERIVED\\SECONDARY");
  putText(object, DCM_DerivationDescription,
          "Volume rendering of the source images made by Limn " + writing.version + "; not for diagnosis");
  putText(object, DCM_BurnedInAnnotation, "NO");
  putNothing(object, DCM_PatientOrientation);
  putReferences(object, DCM_SourceImageSequence, writing.series.images);
  putCompression(object, image);
  putPixels(object, writing.picture);
}

} // namespace limn::dicom
