// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Subject.h"

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

} // namespace limn::dicom
