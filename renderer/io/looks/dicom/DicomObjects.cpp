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

} // namespace

DicomObjects dicomObjectsOf(const Scene& scene, const DicomWriting& writing) {
  const auto source = headerOfFile(writing.series.firstFile);
  DcmItem& image = *source->getDataset();
  const SubjectCopy copy = writing.isAnonymous ? SubjectCopy::anonymous : SubjectCopy::whole;
  const Moment moment = now();
  const Identity lookIdentity, pictureIdentity;
  DcmFileFormat look, picture;
  for (DcmFileFormat* file : {&look, &picture})
    putSubject(*file->getDataset(), image, copy);
  // Made up where the images have none: it is the same in both.
  putText(*picture.getDataset(), DCM_FrameOfReferenceUID,
          textIn(*look.getDataset(), DCM_FrameOfReferenceUID));

  DcmItem& state = *look.getDataset();
  putOrigin(state, UID_VolumeRenderingVolumetricPresentationStateStorage, "PR", "Limn look", lookIdentity,
            writing.version);
  putIdentification(state, moment);
  DicomObjects objects;
  objects.losses = lossesOf(scene);
  putLook(state, scene, writing.series);
  putReferences(state, DCM_RenderedImageReferenceSequence,
                {{UID_SecondaryCaptureImageStorage, pictureIdentity.instance}});
  putOwnBlock(state, scene, lookIdentity.instance);

  DcmItem& shown = *picture.getDataset();
  putOrigin(shown, UID_SecondaryCaptureImageStorage, "OT", "Limn picture", pictureIdentity, writing.version);
  putText(shown, DCM_ContentDate, moment.date);
  putText(shown, DCM_ContentTime, moment.time);
  putPicture(shown, image, writing);

  objects.look = bytesOf(look);
  objects.picture = bytesOf(picture);
  return objects;
}

void writeDicomObjects(const std::filesystem::path& folder, const DicomObjects& objects) {
  writeFileAtomically(folder / "picture.dcm", objects.picture);
  writeFileAtomically(folder / "look.dcm", objects.look);
}

} // namespace limn
