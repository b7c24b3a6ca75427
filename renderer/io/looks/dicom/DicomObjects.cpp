// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/DicomObjects.h"

#include "io/AtomicFile.h"
#include "io/looks/dicom/CroppingModule.h"
#include "io/looks/dicom/DisplayModule.h"
#include "io/looks/dicom/GeometryModule.h"
#include "io/looks/dicom/Losses.h"
#include "io/looks/dicom/NewUid.h"
#include "io/looks/dicom/ObjectBytes.h"
#include "io/looks/dicom/OwnBlock.h"
#include "io/looks/dicom/PictureObject.h"
#include "io/looks/dicom/References.h"
#include "io/looks/dicom/ShadingModule.h"
#include "io/looks/dicom/Subject.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <ctime>

namespace limn {
namespace {

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

// The header of an image of the series, with a frame of reference for both objects where it has none.
std::unique_ptr<DcmFileFormat> imageOf(const SeriesImages& series) {
  auto file = headerOfFile(series.firstFile);
  for (const DcmTagKey& tag : {DCM_StudyInstanceUID, DCM_FrameOfReferenceUID})
    if (!holds(*file->getDataset(), tag))
      putText(*file->getDataset(), tag, newUid());
  return file;
}

} // namespace

DicomObjects dicomObjectsOf(const Scene& scene, const DicomWriting& writing) {
  const auto image = imageOf(writing.series);
  const Identity picture;
  return {lookFile(scene, writing, *image->getDataset(), picture.instance),
          pictureFile(writing, *image->getDataset(), picture), lossesOf(scene)};
}

std::string dicomLookOf(const Scene& scene, const SeriesImages& series, const std::string& version) {
  const auto image = imageOf(series);
  return lookFile(scene, {series, {}, version, false}, *image->getDataset(), {});
}

void writeDicomObjects(const std::filesystem::path& folder, const DicomObjects& objects) {
  writeFileAtomically(folder / "picture.dcm", objects.picture);
  writeFileAtomically(folder / "look.dcm", objects.look);
}

} // namespace limn
