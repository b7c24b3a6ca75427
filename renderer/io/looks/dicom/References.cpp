// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/References.h"

#include "io/reading/ReadError.h"

namespace limn::dicom {
namespace {

// Of type 2 in the modules Patient (C.7.1.1), General Study (C.7.2.1), Frame of Reference (C.7.4.1).
const DcmTagKey presentAnyway[] = {DCM_PatientName,
                                   DCM_PatientID,
                                   DCM_PatientBirthDate,
                                   DCM_PatientSex,
                                   DCM_StudyDate,
                                   DCM_StudyTime,
                                   DCM_ReferringPhysicianName,
                                   DCM_StudyID,
                                   DCM_AccessionNumber,
                                   DCM_PositionReferenceIndicator};

// The rest of those modules and of Patient Study (C.7.2.2).
const DcmTagKey whereGiven[] = {DCM_IssuerOfPatientID,
                                DCM_TypeOfPatientID,
                                DCM_IssuerOfPatientIDQualifiersSequence,
                                DCM_PatientBirthTime,
                                DCM_OtherPatientIDsSequence,
                                DCM_RETIRED_OtherPatientIDs,
                                DCM_OtherPatientNames,
                                DCM_EthnicGroup,
                                DCM_PatientComments,
                                DCM_PatientSpeciesDescription,
                                DCM_PatientSpeciesCodeSequence,
                                DCM_PatientBreedDescription,
                                DCM_PatientBreedCodeSequence,
                                DCM_ResponsiblePerson,
                                DCM_ResponsiblePersonRole,
                                DCM_ResponsibleOrganization,
                                DCM_ReferencedPatientSequence,
                                DCM_PatientIdentityRemoved,
                                DCM_DeidentificationMethod,
                                DCM_DeidentificationMethodCodeSequence,
                                DCM_ClinicalTrialSponsorName,
                                DCM_StudyDescription,
                                DCM_PhysiciansOfRecord,
                                DCM_PhysiciansOfRecordIdentificationSequence,
                                DCM_NameOfPhysiciansReadingStudy,
                                DCM_ReferringPhysicianIdentificationSequence,
                                DCM_ConsultingPhysicianName,
                                DCM_IssuerOfAccessionNumberSequence,
                                DCM_ReferencedStudySequence,
                                DCM_ProcedureCodeSequence,
                                DCM_ReasonForPerformedProcedureCodeSequence,
                                DCM_AdmittingDiagnosesDescription,
                                DCM_AdmittingDiagnosesCodeSequence,
                                DCM_PatientAge,
                                DCM_PatientSize,
                                DCM_PatientWeight,
                                DCM_MedicalAlerts,
                                DCM_Allergies,
                                DCM_SmokingStatus,
                                DCM_PregnancyStatus,
                                DCM_PatientState,
                                DCM_Occupation,
                                DCM_AdditionalPatientHistory,
                                DCM_AdmissionID,
                                DCM_PatientSexNeutered};

// An element with its bytes as they are; false where the image has none or an empty one.
bool copyElement(DcmItem& object, DcmItem& image, const DcmTagKey& tag) {
  DcmElement* copied = nullptr;
  if (image.findAndGetElement(tag, copied, OFFalse, OFTrue).bad() || !copied)
    return false;
  require(object.insert(copied, true).good(), tag);
  return holds(object, tag);
}

constexpr const char* deformableRegistration = "1.2.840.10008.5.1.4.1.1.66.3";

void refuseRegistration(DcmItem& input, const std::string& name) {
  for (DcmItem* item : itemsIn(input, DCM_ReferencedSpatialRegistrationSequence)) {
    const bool isDeformable = textIn(*item, DCM_ReferencedSOPClassUID) == deformableRegistration;
    failReading(
        name,
        isDeformable
            ? Message::tr("its images are deformed by a non-linear registration, which Limn cannot draw")
            : Message::tr("its images are moved by a registration, which Limn does not read"),
        Message::tr("export a look of the images as they are"));
  }
}

} // namespace

void putSubject(DcmItem& object, DcmItem& image, SubjectCopy copy) {
  for (const DcmTagKey& tag : {DCM_StudyInstanceUID, DCM_FrameOfReferenceUID})
    copyElement(object, image, tag);
  for (const DcmTagKey& tag : presentAnyway)
    putNothing(object, tag);
  if (copy == SubjectCopy::anonymous) {
    putText(object, DCM_PatientIdentityRemoved, "YES");
    putText(object, DCM_DeidentificationMethod, "Patient and study left out, UIDs kept");
    return;
  }
  copyElement(object, image, DCM_SpecificCharacterSet);
  for (const DcmTagKey& tag : presentAnyway)
    if (!copyElement(object, image, tag))
      putNothing(object, tag);
  for (const DcmTagKey& tag : whereGiven)
    copyElement(object, image, tag);
}

void putReferences(DcmItem& item, const DcmTagKey& sequence, const std::vector<DicomReference>& images) {
  for (const DicomReference& image : images) {
    DcmItem& reference = addItem(item, sequence);
    putText(reference, DCM_ReferencedSOPClassUID, image.sopClass);
    putText(reference, DCM_ReferencedSOPInstanceUID, image.sopInstance);
  }
}

DcmItem& putInput(DcmItem& object, const std::string& inputSet, const std::vector<DicomReference>& images) {
  DcmItem& set = addItem(object, DCM_VolumetricPresentationInputSetSequence);
  putText(set, DCM_VolumetricPresentationInputSetUID, inputSet);
  putText(set, DCM_PresentationInputType, "VOLUME");
  putReferences(set, DCM_ReferencedImageSequence, images);
  DcmItem& input = addItem(object, DCM_VolumetricPresentationStateInputSequence);
  putCount(input, DCM_VolumetricPresentationInputNumber, 1);
  putText(input, DCM_VolumetricPresentationInputSetUID, inputSet);
  return input;
}

void putCommonReferences(DcmItem& object, const std::string& series,
                         const std::vector<DicomReference>& images) {
  DcmItem& item = addItem(object, DCM_ReferencedSeriesSequence);
  putText(item, DCM_SeriesInstanceUID, series);
  putReferences(item, DCM_ReferencedInstanceSequence, images);
}

DcmItem& inputIn(DcmItem& object, const std::string& name) {
  const std::vector<DcmItem*> inputs = itemsIn(object, DCM_VolumetricPresentationStateInputSequence);
  if (inputs.empty())
    failReading(name, Message::tr("%1 is missing").arg(nameOf(DCM_VolumetricPresentationStateInputSequence)),
                exportAgain);
  if (inputs.size() > 1)
    failReading(name, Message::tr("it has %1 inputs, and Limn draws one volume at a time").arg(inputs.size()),
                Message::tr("export a look of one volume"));
  refuseRegistration(*inputs.front(), name);
  return *inputs.front();
}

std::vector<DicomReference> imagesIn(DcmItem& object, DcmItem& input, const std::string& name) {
  const std::string wanted = textIn(input, DCM_VolumetricPresentationInputSetUID);
  std::vector<DicomReference> images;
  for (DcmItem* set : itemsIn(object, DCM_VolumetricPresentationInputSetSequence)) {
    if (textIn(*set, DCM_VolumetricPresentationInputSetUID) != wanted)
      continue;
    const std::string type = textIn(*set, DCM_PresentationInputType);
    if (!type.empty() && type != "VOLUME")
      failReading(name, Message::tr("its input is of the kind \"%1\", which Limn cannot draw").arg(type),
                  Message::tr("export a look of one volume"));
    for (DcmItem* image : itemsIn(*set, DCM_ReferencedImageSequence))
      images.push_back(
          {textIn(*image, DCM_ReferencedSOPClassUID), textIn(*image, DCM_ReferencedSOPInstanceUID)});
  }
  if (images.empty())
    failReading(name, Message::tr("it does not say which images it belongs to"), exportAgain);
  return images;
}

} // namespace limn::dicom
