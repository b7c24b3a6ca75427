// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DicomObjects.h"

#include "io/AtomicFile.h"
#include "io/looks/dicom/DisplayModule.h"
#include "io/looks/dicom/GeometryModule.h"
#include "io/looks/dicom/Items.h"
#include "io/looks/dicom/Losses.h"
#include "io/looks/dicom/ObjectBytes.h"
#include "io/looks/dicom/OwnBlock.h"
#include "io/looks/dicom/References.h"
#include "io/looks/dicom/Segmentation.h"
#include "io/looks/dicom/SrgbProfile.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <random>

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

// Fills in the Secondary Capture module and the pixels (PS3.3 A.8.1): what made them, of which images, and
// that nothing is burned into them. `image` is one of the series.
void putPicture(DcmItem& object, DcmItem& image, const DicomWriting& writing) {
  putText(object, DCM_ConversionType, "WSD"); // workstation
  putText(object, DCM_ImageType, "DERIVED\\SECONDARY");
  putText(object, DCM_DerivationDescription,
          "Volume rendering of the source images made by Limn " + writing.version + "; not for diagnosis" +
              (writing.remark.empty() ? "" : ". " + writing.remark));
  putText(object, DCM_BurnedInAnnotation, "NO");
  putNothing(object, DCM_PatientOrientation);
  putReferences(object, DCM_SourceImageSequence, writing.series.images);
  putCompression(object, image);
  putPixels(object, writing.picture);
}

} // namespace
} // namespace limn::dicom

namespace limn {
namespace {

// A DICOM UID that no other object has: a random UUID below 2.25 (PS3.5, B.2). It tells neither the computer
// nor the time at which it was made.
std::string newUid() {
  std::random_device chance;
  std::array<std::uint32_t, 4> words{};
  for (std::uint32_t& word : words)
    word = chance();
  words[1] = (words[1] & 0xFFFF0FFFu) | 0x00004000u; // version 4: random
  words[2] = (words[2] & 0x3FFFFFFFu) | 0x80000000u; // variant of RFC 4122
  // 128 bits to decimal digits by long division, the last digit first.
  std::string digits;
  while (std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word != 0; })) {
    std::uint64_t rest = 0;
    for (std::uint32_t& word : words) {
      const std::uint64_t part = rest << 32 | word;
      word = static_cast<std::uint32_t>(part / 10);
      rest = part % 10;
    }
    digits += static_cast<char>('0' + rest);
  }
  return "2.25." + std::string(digits.rbegin(), digits.rend());
}

using namespace dicom;

/// One series of one object.
struct Identity {
  std::string series = newUid();
  std::string instance = newUid();
};

/// When the objects were made, as DICOM writes it, in local time.
struct Moment {
  std::string date, time;
};

Moment now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm local{};
  localtime_r(&seconds, &local);
  char date[16], time[16];
  std::strftime(date, sizeof date, "%Y%m%d", &local);
  std::strftime(time, sizeof time, "%H%M%S", &local);
  return {date, time};
}

// Series, equipment and SOP Common: what every object of ours has.
void putOrigin(DcmItem& object, const std::string& sopClass, const std::string& modality,
               const std::string& description, const Identity& identity, const std::string& version) {
  putText(object, DCM_SOPClassUID, sopClass);
  putText(object, DCM_SOPInstanceUID, identity.instance);
  putText(object, DCM_Modality, modality);
  putText(object, DCM_SeriesInstanceUID, identity.series);
  putNothing(object, DCM_SeriesNumber);
  putText(object, DCM_SeriesDescription, description);
  putText(object, DCM_InstanceNumber, "1");
  putText(object, DCM_Manufacturer, "Limn");
  putText(object, DCM_ManufacturerModelName, "Limn");
  putText(object, DCM_DeviceSerialNumber,
          "0"); // must not be empty; which computer it was is nobody's business
  putText(object, DCM_SoftwareVersions, version);
}

void putIdentification(DcmItem& object, const Moment& moment) {
  putText(object, DCM_PresentationCreationDate, moment.date);
  putText(object, DCM_PresentationCreationTime, moment.time);
  putText(object, DCM_ContentLabel, "LIMN LOOK");
  putNothing(object, DCM_ContentDescription);
  putNothing(object, DCM_ContentCreatorName);
}

// What a look says of the scene in the standard's words; the sampling step is that of its opacities.
void putLook(DcmItem& object, const Scene& scene, const SeriesImages& series) {
  const std::string inputSet = newUid();
  DcmItem& input = putInput(object, inputSet, series.images);
  putCommonReferences(object, series.series, series.images);
  const WrittenWindow window = windowOver(scene.volume->range());
  putWindow(input, window);
  putCrop(object, input, scene.crop, scene.volume->grid());
  const Geometry geometry = geometryOf(scene);
  putGeometry(object, geometry);
  putShading(object, scene.shading, scene.camera);
  // Of one value alone no length is asked: its opacity stays as it is.
  const bool isProjection = geometry.projection != Projection::composite;
  const double lengthMm = isProjection ? scene.transferFunction.unitDistanceMm : *geometry.stepMm;
  const ColourTable table = tableOf(scene.transferFunction, window.range, lengthMm);
  putDisplay(object, inputSet, table);
}

SubjectCopy subjectOf(const DicomWriting& writing) {
  return writing.isAnonymous ? SubjectCopy::anonymous : SubjectCopy::whole;
}

std::string lookFile(const Scene& scene, const DicomWriting& writing, DcmItem& image,
                     const std::string& pictureInstance) {
  const Identity identity;
  DcmFileFormat file;
  DcmItem& object = *file.getDataset();
  putSubject(object, image, subjectOf(writing));
  putOrigin(object, UID_VolumeRenderingVolumetricPresentationStateStorage, "PR", "Limn look", identity,
            writing.version);
  putIdentification(object, now());
  putLook(object, scene, writing.series);
  if (!pictureInstance.empty())
    putReferences(object, DCM_RenderedImageReferenceSequence,
                  {{UID_SecondaryCaptureImageStorage, pictureInstance}});
  putOwnBlock(object, scene, identity.instance);
  return bytesOf(file);
}

std::string pictureFile(const DicomWriting& writing, DcmItem& image, const Identity& identity) {
  const Moment moment = now();
  DcmFileFormat file;
  DcmItem& object = *file.getDataset();
  putSubject(object, image, subjectOf(writing));
  putOrigin(object, UID_SecondaryCaptureImageStorage, "OT", "Limn picture", identity, writing.version);
  putText(object, DCM_ContentDate, moment.date);
  putText(object, DCM_ContentTime, moment.time);
  putPicture(object, image, writing);
  return bytesOf(file);
}

std::string segmentsFile(const Scene& scene, const DicomWriting& writing, DcmItem& image) {
  if (!hasSegments(scene))
    return {};
  const Identity identity;
  DcmFileFormat file;
  DcmItem& object = *file.getDataset();
  putSegmentation(object, scene.keep, scene.volume->grid(), image, writing.series, newUid(), writing.version);
  putSubject(object, image, subjectOf(writing));
  putOrigin(object, UID_SegmentationStorage, "SEG", "Limn segments", identity, writing.version);
  putText(object, DCM_SeriesNumber, "1"); // of which a segmentation has one
  putSegmentNames(object, scene.keep, scene.volume->grid(), scene.volume->info().unit);
  return bytesOf(file);
}

// The header of an image of the series, with a frame of reference for both objects where it has none.
std::unique_ptr<DcmFileFormat> imageOf(const SeriesImages& series) {
  auto file = headerOfFile(series.firstFile);
  for (const DcmTagKey& tag : {DCM_StudyInstanceUID, DCM_FrameOfReferenceUID})
    if (!holds(*file->getDataset(), tag))
      putText(*file->getDataset(), tag, newUid());
  return file;
}

} // namespace

bool hasSegments(const Scene& scene) {
  return dicom::hasSegments(scene.keep, scene.volume->grid());
}

DicomObjects dicomObjectsOf(const Scene& scene, const DicomWriting& writing) {
  const auto image = imageOf(writing.series);
  const Identity picture;
  return {lookFile(scene, writing, *image->getDataset(), picture.instance),
          pictureFile(writing, *image->getDataset(), picture),
          segmentsFile(scene, writing, *image->getDataset()), lossesOf(scene)};
}

std::string dicomLookOf(const Scene& scene, const SeriesImages& series, const std::string& version) {
  const auto image = imageOf(series);
  return lookFile(scene, {series, {}, version, {}, false}, *image->getDataset(), {});
}

void writeDicomObjects(const std::filesystem::path& folder, const DicomObjects& objects) {
  writeFileAtomically(folder / "picture.dcm", objects.picture);
  if (!objects.segments.empty())
    writeFileAtomically(folder / "segments.dcm", objects.segments);
  writeFileAtomically(folder / "look.dcm", objects.look);
}

} // namespace limn
