// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Looks.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmdata/dcsequen.h>

// The modules of the two objects as the standard's tables list them (PS3.3 A.80.2, A.8.1 and the sections
// named), checked against what is written by the library that wrote it, read back from disk.

namespace limn {
namespace {

/// 1: there and not empty; 2: there; where a condition does not hold, absent.
enum class Type { one, two, absent };

struct Row {
  const char* module;
  std::vector<DcmTagKey> path; ///< from the object through sequences
  Type type;
  std::string value = {}; ///< where it is fixed
};

std::unique_ptr<DcmFileFormat> opened(const std::string& bytes) {
  test::TemporaryFolder folder;
  std::ofstream(folder.path() / "object", std::ios::binary) << bytes;
  auto file = std::make_unique<DcmFileFormat>();
  EXPECT_TRUE(file->loadFile((folder.path() / "object").c_str()).good());
  EXPECT_TRUE(file->loadAllDataIntoMemory().good());
  EXPECT_EQ(file->getDataset()->getOriginalXfer(), EXS_LittleEndianExplicit);
  return file;
}

// Every item that a path leads to.
void check(DcmItem& item, const Row& row, std::size_t depth, int& reached) {
  const DcmTagKey& tag = row.path[depth];
  const std::string name = std::string(row.module) + " " + tag.toString().c_str();
  if (depth + 1 < row.path.size()) {
    DcmSequenceOfItems* sequence = nullptr;
    ASSERT_TRUE(item.findAndGetSequence(tag, sequence).good()) << name;
    for (unsigned long i = 0; i < sequence->card(); ++i)
      check(*sequence->getItem(i), row, depth + 1, reached);
    return;
  }
  ++reached;
  EXPECT_EQ(item.tagExists(tag), row.type != Type::absent) << name;
  EXPECT_TRUE(row.type != Type::one || item.tagExistsWithValue(tag)) << name;
  OFString value;
  if (!row.value.empty()) {
    EXPECT_TRUE(item.findAndGetOFStringArray(tag, value).good()) << name;
    EXPECT_EQ(std::string(value.c_str()), row.value) << name;
  }
}

void expectRows(const std::string& bytes, const std::vector<Row>& rows) {
  const auto file = opened(bytes);
  for (const Row& row : rows) {
    int reached = 0;
    check(*file->getDataset(), row, 0, reached);
    EXPECT_GT(reached, 0) << row.module << " " << row.path.back().toString().c_str();
  }
}

std::vector<Row> sharedRows() {
  return {{"SOP Common C.12.1", {DCM_SOPClassUID}, Type::one},
          {"SOP Common C.12.1", {DCM_SOPInstanceUID}, Type::one},
          {"SOP Common C.12.1", {DCM_SpecificCharacterSet}, Type::one, "ISO_IR 100"},
          {"Patient C.7.1.1", {DCM_PatientName}, Type::two, "B\xE4r^Anna"},
          {"Patient C.7.1.1", {DCM_PatientID}, Type::two, "7"},
          {"Patient C.7.1.1", {DCM_PatientBirthDate}, Type::two},
          {"Patient C.7.1.1", {DCM_PatientSex}, Type::two},
          {"General Study C.7.2.1", {DCM_StudyInstanceUID}, Type::one, "1.2.3"},
          {"General Study C.7.2.1", {DCM_StudyDate}, Type::two, "20240531"},
          {"General Study C.7.2.1", {DCM_StudyTime}, Type::two},
          {"General Study C.7.2.1", {DCM_ReferringPhysicianName}, Type::two},
          {"General Study C.7.2.1", {DCM_StudyID}, Type::two},
          {"General Study C.7.2.1", {DCM_AccessionNumber}, Type::two, "A1"},
          {"Patient Study C.7.2.2", {DCM_PatientAge}, Type::one, "044Y"},
          {"General Series C.7.3.1", {DCM_SeriesInstanceUID}, Type::one},
          {"General Series C.7.3.1", {DCM_SeriesNumber}, Type::two},
          {"Frame of Reference C.7.4.1", {DCM_FrameOfReferenceUID}, Type::one, "1.2.3.9"},
          {"Frame of Reference C.7.4.1", {DCM_PositionReferenceIndicator}, Type::two},
          {"Enhanced General Equipment C.7.5.2", {DCM_Manufacturer}, Type::one},
          {"Enhanced General Equipment C.7.5.2", {DCM_ManufacturerModelName}, Type::one},
          {"Enhanced General Equipment C.7.5.2", {DCM_DeviceSerialNumber}, Type::one},
          {"Enhanced General Equipment C.7.5.2", {DCM_SoftwareVersions}, Type::one, "1.2"}};
}

std::vector<Row> lookRows(bool isCropped, bool isShaded) {
  const DcmTagKey input = DCM_VolumetricPresentationStateInputSequence;
  const DcmTagKey set = DCM_VolumetricPresentationInputSetSequence;
  const DcmTagKey stream = DCM_VolumeStreamSequence;
  const DcmTagKey component = DCM_PresentationStateClassificationComponentSequence;
  const Type whenCropped = isCropped ? Type::one : Type::absent;
  const Type whenShaded = isShaded ? Type::one : Type::absent;
  const char* const relationship = "VPS Relationship C.11.23";
  const char* const display = "Volume Render Display C.11.32";
  const char* const geometry = "Volume Render Geometry C.11.30";
  const char* const shading = "Render Shading C.11.31";
  std::vector<Row> rows = sharedRows();
  const std::vector<Row> own{
      {"Presentation Series C.11.9", {DCM_Modality}, Type::one, "PR"},
      {"VPS Identification C.11.22", {DCM_PresentationCreationDate}, Type::one},
      {"VPS Identification C.11.22", {DCM_PresentationCreationTime}, Type::one},
      {"VPS Identification C.11.22", {DCM_InstanceNumber}, Type::one},
      {"VPS Identification C.11.22", {DCM_ContentLabel}, Type::one},
      {"VPS Identification C.11.22", {DCM_ContentDescription}, Type::two},
      {"VPS Identification C.11.22", {DCM_ContentCreatorName}, Type::two},
      {"VPS Identification C.11.22",
       {DCM_RenderedImageReferenceSequence, DCM_ReferencedSOPClassUID},
       Type::one,
       "1.2.840.10008.5.1.4.1.1.7"},
      {"VPS Identification C.11.22",
       {DCM_RenderedImageReferenceSequence, DCM_ReferencedSOPInstanceUID},
       Type::one},
      {relationship, {set, DCM_VolumetricPresentationInputSetUID}, Type::one},
      {relationship, {set, DCM_PresentationInputType}, Type::one, "VOLUME"},
      {relationship, {set, DCM_ReferencedImageSequence, DCM_ReferencedSOPClassUID}, Type::one},
      {relationship, {set, DCM_ReferencedImageSequence, DCM_ReferencedSOPInstanceUID}, Type::one},
      {relationship, {input, DCM_VolumetricPresentationInputNumber}, Type::one, "1"},
      {relationship, {input, DCM_VolumetricPresentationInputSetUID}, Type::one},
      {relationship, {input, DCM_WindowCenter}, Type::one},
      {relationship, {input, DCM_WindowWidth}, Type::one},
      {relationship, {input, DCM_VOILUTFunction}, Type::one, "LINEAR_EXACT"},
      {relationship, {input, DCM_Crop}, Type::one, isCropped ? "YES" : "NO"},
      {relationship, {input, DCM_CroppingSpecificationIndex}, whenCropped},
      {relationship, {input, DCM_ReferencedSpatialRegistrationSequence}, Type::absent},
      {relationship, {DCM_GlobalCrop}, Type::one, "NO"},
      {relationship, {DCM_GlobalCroppingSpecificationIndex}, Type::absent},
      {"Common Instance Reference C.12.2",
       {DCM_ReferencedSeriesSequence, DCM_SeriesInstanceUID},
       Type::one,
       "1.2.3.4"},
      {"Common Instance Reference C.12.2",
       {DCM_ReferencedSeriesSequence, DCM_ReferencedInstanceSequence, DCM_ReferencedSOPInstanceUID},
       Type::one},
      {geometry, {DCM_RenderProjection}, Type::one, "PERSPECTIVE"},
      {geometry, {DCM_ViewpointPosition}, Type::one},
      {geometry, {DCM_ViewpointLookAtPoint}, Type::one},
      {geometry, {DCM_ViewpointUpDirection}, Type::one},
      {geometry, {DCM_RenderFieldOfView}, Type::one},
      {geometry, {DCM_RenderingMethod}, Type::one, "VOLUME_RENDERED"},
      {geometry, {DCM_SamplingStepSize}, Type::one}, // 3 in the table; we promise it
      {shading, {DCM_ShadingStyle}, whenShaded},
      {shading, {DCM_AmbientReflectionIntensity}, whenShaded},
      {shading, {DCM_LightDirection}, whenShaded},
      {display, {DCM_PixelPresentation}, Type::one, "TRUE_COLOR"},
      {display, {DCM_PresentationStateCompositorComponentSequence}, Type::two},
      {display, {DCM_ICCProfile}, Type::one},
      {display, {DCM_ColorSpace}, Type::one, "SRGB"},
      {display, {stream, DCM_VolumetricPresentationInputSetUID}, Type::one},
      {display, {stream, component, DCM_ComponentType}, Type::one, "ONE_TO_RGBA"},
      {display,
       {stream, component, DCM_ComponentInputSequence, DCM_VolumetricPresentationInputIndex},
       Type::one,
       "1"},
      {display, {stream, component, DCM_RGBLUTTransferFunction}, Type::one, "TABLE"},
      {display, {stream, component, DCM_AlphaLUTTransferFunction}, Type::one, "TABLE"},
      {display, {stream, component, DCM_RedPaletteColorLookupTableDescriptor}, Type::one},
      {display, {stream, component, DCM_GreenPaletteColorLookupTableDescriptor}, Type::one},
      {display, {stream, component, DCM_BluePaletteColorLookupTableDescriptor}, Type::one},
      {display, {stream, component, DCM_AlphaPaletteColorLookupTableDescriptor}, Type::one},
      {display, {stream, component, DCM_RedPaletteColorLookupTableData}, Type::one},
      {display, {stream, component, DCM_GreenPaletteColorLookupTableData}, Type::one},
      {display, {stream, component, DCM_BluePaletteColorLookupTableData}, Type::one},
      {display, {stream, component, DCM_AlphaPaletteColorLookupTableData}, Type::one}};
  rows.insert(rows.end(), own.begin(), own.end());
  if (isCropped) {
    const DcmTagKey crop = DCM_VolumeCroppingSequence;
    rows.push_back({"Volume Cropping C.11.24", {crop, DCM_CroppingSpecificationNumber}, Type::one, "1"});
    rows.push_back({"Volume Cropping C.11.24", {crop, DCM_VolumeCroppingMethod}, Type::one, "BOUNDING_BOX"});
    rows.push_back({"Volume Cropping C.11.24", {crop, DCM_BoundingBoxCrop}, Type::one});
  } else {
    rows.push_back({"Volume Cropping C.11.24", {DCM_VolumeCroppingSequence}, Type::absent});
  }
  return rows;
}

TEST(DicomLookModules, areThoseOfTheStandard) {
  Scene scene = test::phantomScene();
  expectRows(test::objectsOf(scene).look, lookRows(false, false));
  scene.crop.upper.x = 0.5;
  scene.shading.model = ShadingModel::classic;
  expectRows(test::objectsOf(scene).look, lookRows(true, true));
}

TEST(DicomLookModules, ofThePictureAreThoseOfASecondaryCapture) {
  std::vector<Row> rows = sharedRows();
  const char* const image = "General Image C.7.6.1";
  const char* const pixels = "Image Pixel C.7.6.3";
  const std::vector<Row> own{{"General Series C.7.3.1", {DCM_Modality}, Type::one, "OT"},
                             {"SC Equipment C.8.6.1", {DCM_ConversionType}, Type::one, "WSD"},
                             {image, {DCM_InstanceNumber}, Type::two},
                             {image, {DCM_PatientOrientation}, Type::two},
                             {image, {DCM_ImageType}, Type::one, "DERIVED\\SECONDARY"},
                             {image, {DCM_BurnedInAnnotation}, Type::one, "NO"},
                             {image,
                              {DCM_DerivationDescription},
                              Type::one,
                              "Volume rendering of the source images made by Limn 1.2; not for diagnosis"},
                             {image, {DCM_SourceImageSequence, DCM_ReferencedSOPInstanceUID}, Type::one},
                             {image, {DCM_LossyImageCompression}, Type::absent},
                             {pixels, {DCM_SamplesPerPixel}, Type::one, "3"},
                             {pixels, {DCM_PhotometricInterpretation}, Type::one, "RGB"},
                             {pixels, {DCM_PlanarConfiguration}, Type::one, "0"},
                             {pixels, {DCM_Rows}, Type::one, "1"},
                             {pixels, {DCM_Columns}, Type::one, "3"},
                             {pixels, {DCM_BitsAllocated}, Type::one, "8"},
                             {pixels, {DCM_BitsStored}, Type::one, "8"},
                             {pixels, {DCM_HighBit}, Type::one, "7"},
                             {pixels, {DCM_PixelRepresentation}, Type::one, "0"},
                             {pixels, {DCM_PixelData}, Type::one},
                             {"ICC Profile C.11.15", {DCM_ICCProfile}, Type::one}};
  rows.insert(rows.end(), own.begin(), own.end());
  const std::string picture = test::objectsOf(test::phantomScene()).picture;
  expectRows(picture, rows);
  // Nine bytes and one of padding.
  EXPECT_EQ(picture.substr(picture.size() - 10), std::string("\1\2\3\4\5\6\7\10\11\0", 10));
}

TEST(DicomLookModules, referToEveryImageTwice) {
  const auto file = opened(test::objectsOf(test::phantomScene()).look);
  for (const auto& [outer, inner] :
       {std::pair(DCM_VolumetricPresentationInputSetSequence, DCM_ReferencedImageSequence),
        std::pair(DCM_ReferencedSeriesSequence, DCM_ReferencedInstanceSequence)}) {
    DcmItem* item = nullptr;
    DcmSequenceOfItems* images = nullptr;
    ASSERT_TRUE(file->getDataset()->findAndGetSequenceItem(outer, item).good());
    ASSERT_TRUE(item->findAndGetSequence(inner, images).good());
    ASSERT_EQ(images->card(), 3u);
    for (unsigned long i = 0; i < 3; ++i) {
      OFString uid;
      images->getItem(i)->findAndGetOFString(DCM_ReferencedSOPInstanceUID, uid);
      EXPECT_EQ(std::string(uid.c_str()), "1.2.3.4." + std::to_string(i + 1));
    }
  }
}

// 16 bits, at least 4096 entries, the first for the lowest value, the last for the highest.
TEST(DicomLookModules, haveTablesFromTheLowestToTheHighestValue) {
  const Scene scene = test::phantomScene();
  const auto file = opened(test::objectsOf(scene).look);
  DcmItem *input = nullptr, *stream = nullptr, *component = nullptr;
  DcmDataset& object = *file->getDataset();
  ASSERT_TRUE(object.findAndGetSequenceItem(DCM_VolumetricPresentationStateInputSequence, input).good());
  Float64 centre = 0.0, width = 0.0;
  ASSERT_TRUE(input->findAndGetFloat64(DCM_WindowCenter, centre).good());
  ASSERT_TRUE(input->findAndGetFloat64(DCM_WindowWidth, width).good());
  EXPECT_DOUBLE_EQ(centre - 0.5 * width, scene.volume->range().lowest);
  EXPECT_DOUBLE_EQ(centre + 0.5 * width, scene.volume->range().highest);
  ASSERT_TRUE(object.findAndGetSequenceItem(DCM_VolumeStreamSequence, stream).good());
  ASSERT_TRUE(
      stream->findAndGetSequenceItem(DCM_PresentationStateClassificationComponentSequence, component).good());
  Uint16 entries = 0, first = 1, bits = 0;
  component->findAndGetUint16(DCM_AlphaPaletteColorLookupTableDescriptor, entries, 0);
  component->findAndGetUint16(DCM_AlphaPaletteColorLookupTableDescriptor, first, 1);
  component->findAndGetUint16(DCM_AlphaPaletteColorLookupTableDescriptor, bits, 2);
  EXPECT_GE(entries, 4096);
  EXPECT_EQ(first, 0);
  EXPECT_EQ(bits, 16);
  Float64 stepMm = 0.0;
  ASSERT_TRUE(object.findAndGetFloat64(DCM_SamplingStepSize, stepMm).good());
  EXPECT_DOUBLE_EQ(stepMm, scene.quality.stepVoxels * smallestSpacingMm(scene.volume->grid()));
  // The opacity over that step, of each entry's own value.
  for (const unsigned long i : {0ul, 1500ul, static_cast<unsigned long>(entries) - 1}) {
    Uint16 alpha = 0;
    ASSERT_TRUE(component->findAndGetUint16(DCM_AlphaPaletteColorLookupTableData, alpha, i).good());
    const double value = centre + width * (static_cast<double>(i) / (entries - 1.0) - 0.5);
    const double opacity = classify(scene.transferFunction, value).opacity;
    EXPECT_NEAR(alpha / 65535.0, 1.0 - std::pow(1.0 - opacity, stepMm), 0.51 / 65535.0) << i;
  }
}

// Somebody asked for them without: the UIDs stay, by which the look finds its images.
TEST(DicomLookModules, sayNothingOfThePatientWhereThatIsAskedFor) {
  const DicomObjects objects = test::objectsOf(test::phantomScene(), true);
  for (const std::string* bytes : {&objects.look, &objects.picture}) {
    const auto file = opened(*bytes);
    for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_StudyDate, DCM_AccessionNumber}) {
      EXPECT_TRUE(file->getDataset()->tagExists(tag));
      EXPECT_FALSE(file->getDataset()->tagExistsWithValue(tag));
    }
    EXPECT_FALSE(file->getDataset()->tagExists(DCM_PatientAge));
    OFString removed;
    file->getDataset()->findAndGetOFString(DCM_PatientIdentityRemoved, removed);
    EXPECT_EQ(std::string(removed.c_str()), "YES");
  }
}

} // namespace
} // namespace limn
