// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomDataset.h"

/// The attributes Limn reads, by the keywords of the standard (PS3.6).
namespace limn::tag {

inline constexpr DicomTag mediaStorageClass = 0x00020002;
inline constexpr DicomTag transferSyntax = 0x00020010;
inline constexpr DicomTag characterSet = 0x00080005;
inline constexpr DicomTag imageType = 0x00080008;
inline constexpr DicomTag sopClass = 0x00080016;
inline constexpr DicomTag sopInstance = 0x00080018;
inline constexpr DicomTag studyDate = 0x00080020;
inline constexpr DicomTag acquisitionTime = 0x00080032;
inline constexpr DicomTag contentTime = 0x00080033;
inline constexpr DicomTag modality = 0x00080060;
inline constexpr DicomTag seriesDescription = 0x0008103E;
inline constexpr DicomTag patientName = 0x00100010;
inline constexpr DicomTag patientId = 0x00100020;
inline constexpr DicomTag sliceThickness = 0x00180050;
inline constexpr DicomTag echoTime = 0x00180081;
inline constexpr DicomTag spacingBetweenSlices = 0x00180088;
inline constexpr DicomTag triggerTime = 0x00181060;
inline constexpr DicomTag frameTime = 0x00181063;
inline constexpr DicomTag frameTimeVector = 0x00181065;
inline constexpr DicomTag imagerPixelSpacing = 0x00181164;
inline constexpr DicomTag effectiveEchoTime = 0x00189082;
inline constexpr DicomTag diffusionBValue = 0x00189087;
inline constexpr DicomTag mrEchoSequence = 0x00189114;
inline constexpr DicomTag mrDiffusionSequence = 0x00189117;
inline constexpr DicomTag cardiacSynchronizationSequence = 0x00189118;
inline constexpr DicomTag studyInstance = 0x0020000D;
inline constexpr DicomTag seriesInstance = 0x0020000E;
inline constexpr DicomTag seriesNumber = 0x00200011;
inline constexpr DicomTag acquisitionNumber = 0x00200012;
inline constexpr DicomTag instanceNumber = 0x00200013;
inline constexpr DicomTag imagePosition = 0x00200032;
inline constexpr DicomTag imageOrientation = 0x00200037;
inline constexpr DicomTag temporalPosition = 0x00200100;
inline constexpr DicomTag stackId = 0x00209056;
inline constexpr DicomTag frameContentSequence = 0x00209111;
inline constexpr DicomTag planePositionSequence = 0x00209113;
inline constexpr DicomTag planeOrientationSequence = 0x00209116;
inline constexpr DicomTag temporalPositionIndex = 0x00209128;
inline constexpr DicomTag cardiacTriggerDelay = 0x00209153;
inline constexpr DicomTag samplesPerPixel = 0x00280002;
inline constexpr DicomTag photometricInterpretation = 0x00280004;
inline constexpr DicomTag planarConfiguration = 0x00280006;
inline constexpr DicomTag numberOfFrames = 0x00280008;
inline constexpr DicomTag frameIncrementPointer = 0x00280009;
inline constexpr DicomTag rows = 0x00280010;
inline constexpr DicomTag columns = 0x00280011;
inline constexpr DicomTag pixelSpacing = 0x00280030;
inline constexpr DicomTag bitsAllocated = 0x00280100;
inline constexpr DicomTag bitsStored = 0x00280101;
inline constexpr DicomTag highBit = 0x00280102;
inline constexpr DicomTag pixelRepresentation = 0x00280103;
inline constexpr DicomTag pixelPadding = 0x00280120;
inline constexpr DicomTag pixelPaddingLimit = 0x00280121;
inline constexpr DicomTag rescaleIntercept = 0x00281052;
inline constexpr DicomTag rescaleSlope = 0x00281053;
inline constexpr DicomTag rescaleType = 0x00281054;
inline constexpr DicomTag redPaletteDescriptor = 0x00281101;
inline constexpr DicomTag redPalette = 0x00281201;
inline constexpr DicomTag lossyCompression = 0x00282110;
inline constexpr DicomTag lossyRatio = 0x00282112;
inline constexpr DicomTag modalityLutSequence = 0x00283000;
inline constexpr DicomTag lutDescriptor = 0x00283002;
inline constexpr DicomTag lutData = 0x00283006;
inline constexpr DicomTag pixelMeasuresSequence = 0x00289110;
inline constexpr DicomTag pixelValueTransformationSequence = 0x00289145;
inline constexpr DicomTag petUnits = 0x00541001;
inline constexpr DicomTag doseUnits = 0x30040002;
inline constexpr DicomTag gridFrameOffsets = 0x3004000C;
inline constexpr DicomTag doseGridScaling = 0x3004000E;
inline constexpr DicomTag sharedFunctionalGroups = 0x52009229;
inline constexpr DicomTag perFrameFunctionalGroups = 0x52009230;
inline constexpr DicomTag floatPixelData = 0x7FE00008;
inline constexpr DicomTag doubleFloatPixelData = 0x7FE00009;
inline constexpr DicomTag pixelData = 0x7FE00010;

/// Whether the parser keeps an attribute: one of those above, or a channel of the palette.
bool isKept(DicomTag tag);

} // namespace limn::tag
