// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/CroppingModule.h"

#include "io/reading/ReadError.h"

namespace limn::dicom {
namespace {

glm::dvec3 cornerAt(const Grid& grid, const glm::dvec3& fraction) {
  return indexToWorld(grid, fraction * glm::dvec3(grid.dims) - 0.5);
}

// The numbers of the specifications that a flag and its index name.
std::vector<std::uint16_t> namedBy(DcmItem& item, const DcmTagKey& flag, const DcmTagKey& index,
                                   const std::string& name) {
  if (textIn(item, flag) != "YES")
    return {};
  std::vector<std::uint16_t> numbers = wordsIn(item, index);
  if (numbers.empty())
    failReading(name, Message::tr("it is cropped, and %1 does not say how").arg(nameOf(index)), exportAgain);
  return numbers;
}

DcmItem& specification(DcmItem& object, std::uint16_t number, const std::string& name) {
  for (DcmItem* item : itemsIn(object, DCM_VolumeCroppingSequence))
    if (const auto numbers = wordsIn(*item, DCM_CroppingSpecificationNumber);
        !numbers.empty() && numbers.front() == number)
      return *item;
  failReading(name, Message::tr("it is cropped by specification %1, which is missing").arg(number),
              exportAgain);
}

BoxCorners boxIn(DcmItem& item, const std::string& name) {
  const std::vector<double> n = numbersIn(item, DCM_BoundingBoxCrop);
  if (n.size() != 6)
    failReading(name, Message::tr("%1 is missing or damaged").arg(nameOf(DCM_BoundingBoxCrop)), exportAgain);
  return {glm::dvec3(n[0], n[1], n[2]), glm::dvec3(n[3], n[4], n[5])};
}

} // namespace

void putCrop(DcmItem& object, DcmItem& input, const CropBox& crop, const Grid& grid) {
  const bool isCropped = crop != CropBox{};
  putText(input, DCM_Crop, isCropped ? "YES" : "NO");
  putText(object, DCM_GlobalCrop, "NO");
  if (!isCropped)
    return;
  putCount(input, DCM_CroppingSpecificationIndex, 1);
  DcmItem& item = addItem(object, DCM_VolumeCroppingSequence);
  putCount(item, DCM_CroppingSpecificationNumber, 1);
  putText(item, DCM_VolumeCroppingMethod, "BOUNDING_BOX");
  const glm::dvec3 lower = cornerAt(grid, crop.lower), upper = cornerAt(grid, crop.upper);
  putNumbers(item, DCM_BoundingBoxCrop, {lower.x, lower.y, lower.z, upper.x, upper.y, upper.z});
}

std::vector<BoxCorners> cropsIn(DcmItem& object, DcmItem& input, const std::string& name,
                                std::vector<Message>& changes) {
  std::vector<std::uint16_t> numbers = namedBy(input, DCM_Crop, DCM_CroppingSpecificationIndex, name);
  const auto global = namedBy(object, DCM_GlobalCrop, DCM_GlobalCroppingSpecificationIndex, name);
  numbers.insert(numbers.end(), global.begin(), global.end());
  std::vector<BoxCorners> boxes;
  for (const std::uint16_t number : numbers) {
    DcmItem& item = specification(object, number, name);
    const std::string method = textIn(item, DCM_VolumeCroppingMethod);
    if (method == "BOUNDING_BOX")
      boxes.push_back(boxIn(item, name));
    else if (method == "OBLIQUE_PLANES")
      changes.push_back(Message::tr(
          "It is cropped by oblique planes, which Limn does not draw: what they cut away is shown."));
    else
      failReading(name, Message::tr("it is cropped by \"%1\", which Limn cannot draw").arg(method),
                  Message::tr("export a look without segmentations"));
  }
  return boxes;
}

std::optional<CropBox> cropWithin(const std::vector<BoxCorners>& boxes, const Grid& grid) {
  CropBox crop;
  for (const BoxCorners& box : boxes) {
    const glm::dvec3 dims(grid.dims);
    const glm::dvec3 first = (worldToIndex(grid, box[0]) + 0.5) / dims;
    const glm::dvec3 second = (worldToIndex(grid, box[1]) + 0.5) / dims;
    crop.lower = glm::max(crop.lower, glm::min(first, second));
    crop.upper = glm::min(crop.upper, glm::max(first, second));
  }
  for (int axis = 0; axis < 3; ++axis)
    if (!(crop.lower[axis] < crop.upper[axis]))
      return std::nullopt;
  return crop;
}

} // namespace limn::dicom
