// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/VtkXmlFile.h"

#include "io/formats/AxisGrid.h"
#include "io/formats/Bytes.h"
#include "io/formats/HeaderText.h"
#include "io/formats/ReadError.h"
#include "io/formats/Voxels.h"

#include <pugixml.hpp>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <cmath>
#include <type_traits>

namespace limn {
namespace {

namespace fs = std::filesystem;

// What the elements before the arrays say.
struct Header {
  glm::ivec3 points{0};
  glm::dmat3 stepsMm{1.0};
  glm::dvec3 firstPointMm{0.0};
  bool spacingKnown = false;
};

std::vector<double> listOf(const fs::path& file, const pugi::xml_node& node, const char* name,
                           std::size_t count) {
  const std::vector<double> values = numbers(file, node.attribute(name).as_string());
  if (!values.empty() && values.size() != count)
    failReading(file, std::string("its header's attribute ") + name + " has the wrong number of numbers",
                copyAgain);
  return values;
}

// The voxels a file of this length can hold at most, by the best its compressor can do (bytes per byte).
double mostVoxels(const fs::path& file, const std::string& compressor) {
  const double size = static_cast<double>(fs::file_size(file));
  if (compressor.empty())
    return size;
  if (compressor == "vtkZLibDataCompressor")
    return size * 1032.0;
  if (compressor == "vtkLZ4DataCompressor")
    return size * 255.0;
  return size * 8192.0;
}

Header headerOf(const fs::path& file) {
  const std::string start = firstBytes(file, 1 << 16);
  pugi::xml_document document;
  // The text is cut before the data, so the elements stay open: the tree up to there is what is asked for.
  document.load_buffer(start.data(), std::min(start.find("<Piece"), start.size()));
  const pugi::xml_node root = document.child("VTKFile");
  if (std::string(root.attribute("type").as_string()) != "ImageData")
    failReading(file,
                "it holds VTK data of the type \"" + std::string(root.attribute("type").as_string()) +
                    "\", not image data",
                "export the volume as image data (.vti)");
  const pugi::xml_node image = root.child("ImageData");
  const std::vector<double> extent = listOf(file, image, "WholeExtent", 6);
  const std::vector<double> spacing = listOf(file, image, "Spacing", 3);
  const std::vector<double> origin = listOf(file, image, "Origin", 3);
  const std::vector<double> direction = listOf(file, image, "Direction", 9);
  if (extent.empty())
    failReading(file, "its header has no WholeExtent", copyAgain);
  Header header;
  header.spacingKnown = !spacing.empty();
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    header.points[axis] = dimension(file, extent[2 * a + 1] - extent[2 * a] + 1.0);
    for (int row = 0; row < 3 && !direction.empty(); ++row)
      header.stepsMm[axis][row] = direction[static_cast<std::size_t>(row) * 3 + a];
    header.stepsMm[axis] *= spacing.empty() ? 1.0 : spacing[a];
    header.firstPointMm[axis] = origin.empty() ? 0.0 : origin[a];
  }
  header.firstPointMm += header.stepsMm * glm::dvec3(extent[0], extent[2], extent[4]);
  if (static_cast<double>(voxelCount(file, header.points)) >
      8.0 * mostVoxels(file, root.attribute("compressor").as_string()))
    failReading(file, "its header asks for more voxels than the file can hold", copyAgain);
  return header;
}

// What VTK's callbacks hand on to us and back.
struct Conversation {
  const Progress* progress = nullptr;
  std::string complaint;
  bool isCancelled = false;
};

void onVtkEvent(vtkObject* caller, unsigned long event, void* data, void* detail) {
  auto& conversation = *static_cast<Conversation*>(data);
  if (event == vtkCommand::ErrorEvent) {
    if (conversation.complaint.empty() && detail)
      conversation.complaint = static_cast<const char*>(detail);
    return;
  }
  auto* reader = vtkAlgorithm::SafeDownCast(caller);
  const Progress& progress = *conversation.progress;
  if (progress.isCancelled && progress.isCancelled()) {
    conversation.isCancelled = true;
    reader->SetAbortExecute(1);
  }
  if (progress.report)
    progress.report(reader->GetProgress(), "Reading voxels");
}

void update(vtkXMLImageDataReader& reader, const fs::path& file, const Progress& progress) {
  Conversation conversation;
  conversation.progress = &progress;
  vtkNew<vtkCallbackCommand> callback;
  callback->SetCallback(onVtkEvent);
  callback->SetClientData(&conversation);
  reader.AddObserver(vtkCommand::ErrorEvent, callback);
  reader.AddObserver(vtkCommand::ProgressEvent, callback);
  reader.SetReaderErrorObserver(callback);
  reader.SetParserErrorObserver(callback);
  reader.SetFileName(file.c_str());
  reader.Update();
  if (conversation.isCancelled)
    throw Cancelled();
  if (!conversation.complaint.empty() || reader.GetErrorCode() != 0)
    failReading(file, "its image data are damaged or cut off", copyAgain);
}

// The array of one value or colour per point (or else per cell).
vtkDataArray* scalarsOf(const fs::path& file, vtkImageData& image, bool& areOfCells) {
  for (vtkDataSetAttributes* attributes : {static_cast<vtkDataSetAttributes*>(image.GetPointData()),
                                           static_cast<vtkDataSetAttributes*>(image.GetCellData())}) {
    vtkDataArray* scalars = attributes->GetScalars();
    if (!scalars && attributes->GetNumberOfArrays() > 0)
      scalars = attributes->GetArray(0);
    areOfCells = attributes == image.GetCellData();
    if (scalars)
      return scalars;
  }
  failReading(file, "it holds no array of values", "export the volume with its scalars");
}

template <class Stored>
VoxelArray copyOf(vtkDataArray& array, std::uint64_t count, int components) {
  const auto* from = static_cast<const Stored*>(array.GetVoidPointer(0));
  constexpr bool isLong = std::is_integral_v<Stored> && sizeof(Stored) == 8;
  using Kept = std::conditional_t<isLong, double, Stored>;
  std::vector<Kept> voxels(count);
  double samples[4] = {};
  for (std::uint64_t i = 0; i < count; ++i) {
    for (int c = 0; c < components; ++c)
      samples[c] = static_cast<double>(
          from[i * static_cast<std::uint64_t>(components) + static_cast<std::uint64_t>(c)]);
    const double luma = luminance(samples, components);
    voxels[i] = static_cast<Kept>(std::is_integral_v<Kept> ? std::round(luma) : luma);
  }
  return voxels;
}

VoxelArray voxelsOf(const fs::path& file, vtkDataArray& array, std::uint64_t count) {
  const int components = array.GetNumberOfComponents();
  if (components != 1 && components != 3 && components != 4)
    failReading(file, "it holds " + std::to_string(components) + " values per voxel, and a volume needs one",
                "save one component as a volume of its own");
  if (static_cast<std::uint64_t>(array.GetNumberOfTuples()) != count)
    failReading(file, "its array does not fit its extent", copyAgain);
  switch (array.GetDataType()) {
  case VTK_UNSIGNED_CHAR:
    return copyOf<std::uint8_t>(array, count, components);
  case VTK_CHAR:
  case VTK_SIGNED_CHAR:
    return copyOf<std::int8_t>(array, count, components);
  case VTK_UNSIGNED_SHORT:
    return copyOf<std::uint16_t>(array, count, components);
  case VTK_SHORT:
    return copyOf<std::int16_t>(array, count, components);
  case VTK_UNSIGNED_INT:
    return copyOf<std::uint32_t>(array, count, components);
  case VTK_INT:
    return copyOf<std::int32_t>(array, count, components);
  case VTK_UNSIGNED_LONG:
  case VTK_UNSIGNED_LONG_LONG:
    return copyOf<std::uint64_t>(array, count, components);
  case VTK_LONG:
  case VTK_LONG_LONG:
  case VTK_ID_TYPE:
    return copyOf<std::int64_t>(array, count, components);
  case VTK_FLOAT:
    return copyOf<float>(array, count, components);
  case VTK_DOUBLE:
    return copyOf<double>(array, count, components);
  default:
    failReading(file, "its voxels are of a type that is not supported",
                "convert it to integers or floats first");
  }
}

} // namespace

bool isVtkXml(std::string_view bytes) {
  return bytes.find("<VTKFile") != std::string_view::npos && trimmed(bytes).starts_with('<');
}

VolumeParts readVtkXml(const fs::path& path, const Progress& progress) {
  const Header header = headerOf(path);
  vtkNew<vtkXMLImageDataReader> reader;
  update(*reader, path, progress);
  vtkImageData& image = *reader->GetOutput();
  glm::ivec3 points(0);
  image.GetDimensions(&points.x);
  bool areOfCells = false;
  vtkDataArray* scalars = scalarsOf(path, image, areOfCells);
  if (points != header.points)
    failReading(path, "its pieces do not fill its extent", copyAgain);

  VolumeParts parts;
  parts.info.format = "VTI";
  parts.info.orientationKnown = false;
  parts.info.spacingKnown = header.spacingKnown;
  // Values of cells sit half a step behind the points.
  const glm::ivec3 dims = areOfCells ? glm::max(points - 1, glm::ivec3(1)) : points;
  const glm::dvec3 shift = areOfCells ? glm::dvec3(0.5) : glm::dvec3(0.0);
  parts.grid = gridFromAxes(path, dims, header.stepsMm, header.firstPointMm + header.stepsMm * shift);
  parts.stored = voxelsOf(path, *scalars, voxelCount(path, dims));
  if (scalars->GetNumberOfComponents() > 1)
    parts.info.warnings.emplace_back(colorWarning);
  return parts;
}

} // namespace limn
