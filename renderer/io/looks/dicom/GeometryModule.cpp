// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/GeometryModule.h"

#include "io/reading/ReadError.h"

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace limn::dicom {
namespace {

std::vector<double> listed(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

std::vector<double> countedNumbers(DcmItem& object, const DcmTagKey& tag, std::size_t count,
                                   const std::string& name) {
  std::vector<double> numbers = numbersIn(object, tag);
  if (numbers.size() != count)
    failReading(name, Message::tr("%1 is missing or damaged").arg(nameOf(tag)), exportAgain);
  return numbers;
}

glm::dvec3 vectorIn(DcmItem& object, const DcmTagKey& tag, const std::string& name) {
  const std::vector<double> numbers = countedNumbers(object, tag, 3, name);
  return {numbers[0], numbers[1], numbers[2]};
}

/// Render Field of View: four sides at the far distance, and where the view begins and ends, mm.
struct FieldOfView {
  double left, right, top, bottom, nearMm, farMm;
};

FieldOfView fieldOfViewIn(DcmItem& object, const std::string& name) {
  const std::vector<double> n = countedNumbers(object, DCM_RenderFieldOfView, 6, name);
  const FieldOfView view{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (!(view.left < view.right) || !(view.bottom < view.top) || !(view.nearMm < view.farMm) ||
      !(view.farMm > 0.0))
    failReading(name, Message::tr("%1 contradicts itself").arg(nameOf(DCM_RenderFieldOfView)), exportAgain);
  return view;
}

bool isPerspectiveIn(DcmItem& object, const std::string& name) {
  const std::string text = textIn(object, DCM_RenderProjection);
  if (text != "PERSPECTIVE" && text != "ORTHOGRAPHIC")
    failReading(name,
                Message::tr("%1 is \"%2\", which Limn does not know").arg(nameOf(DCM_RenderProjection), text),
                exportAgain);
  return text == "PERSPECTIVE";
}

Projection methodIn(DcmItem& object, const std::string& name) {
  const std::string text = textIn(object, DCM_RenderingMethod);
  if (text == "VOLUME_RENDERED")
    return Projection::composite;
  if (text == "MAXIMUM_IP")
    return Projection::mip;
  if (text == "MINIMUM_IP")
    return Projection::minip;
  failReading(name,
              Message::tr("%1 is \"%2\", which Limn does not know").arg(nameOf(DCM_RenderingMethod), text),
              exportAgain);
}

// A field of view beside the axis: a parallel camera moves aside; a perspective one stays, and it is said.
void centre(const FieldOfView& view, Camera& camera, std::vector<Message>& changes) {
  const glm::dvec2 offset(0.5 * (view.left + view.right), 0.5 * (view.bottom + view.top));
  if (glm::length(offset) < 1e-6 * (view.top - view.bottom))
    return;
  if (camera.projection == Camera::Projection::perspective) {
    changes.push_back(Message::tr("The field of view lies beside the axis of the view; it was centred."));
    return;
  }
  const CameraBasis basis = basisOf(camera);
  const glm::dvec3 aside = offset.x * basis.right + offset.y * basis.up;
  camera.position += aside;
  camera.target += aside;
}

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

ValueRange depthsOf(const Camera& camera, const Grid& grid) {
  const glm::dvec3 forward = basisOf(camera).forward;
  ValueRange depths{1e300, -1e300};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const glm::dvec3 world = indexToWorld(grid, side * glm::dvec3(grid.dims) - 0.5);
    const double depth = glm::dot(world - camera.position, forward);
    depths.lowest = std::min(depths.lowest, depth);
    depths.highest = std::max(depths.highest, depth);
  }
  return depths;
}

Projection standardProjection(Projection projection) {
  return projection == Projection::mip || projection == Projection::minip ? projection
                                                                          : Projection::composite;
}

Geometry geometryOf(const Scene& scene) {
  Geometry geometry;
  geometry.camera = scene.camera;
  geometry.aspect = 1.0 * scene.image.width / scene.image.height;
  const Grid& grid = scene.volume->grid();
  const ValueRange depths = depthsOf(scene.camera, grid);
  const double room = 0.01 * boxDiagonalMm(grid);
  // Seen from within or from behind, the picture begins at the eye, and so does the view, as nearly as near
  // may be.
  geometry.farMm = std::max(depths.highest, 0.0) + room;
  geometry.nearMm = std::clamp(depths.lowest - room, 1e-6 * geometry.farMm, (1.0 - 1e-6) * geometry.farMm);
  geometry.projection = standardProjection(scene.projection);
  geometry.stepMm = scene.quality.stepVoxels * smallestSpacingMm(grid);
  return geometry;
}

void putGeometry(DcmItem& object, const Geometry& geometry) {
  const Camera& camera = geometry.camera;
  const bool isPerspective = camera.projection == Camera::Projection::perspective;
  putText(object, DCM_RenderProjection, isPerspective ? "PERSPECTIVE" : "ORTHOGRAPHIC");
  // The camera as it draws: one whose eye is on its target, or whose up has no length, has axes all the same.
  const CameraBasis basis = basisOf(camera);
  const glm::dvec3 away = glm::abs(camera.position); // its length may be beyond what a number can hold
  const double ahead = std::max({geometry.farMm, 1e-6 * away.x, 1e-6 * away.y, 1e-6 * away.z});
  putNumbers(object, DCM_ViewpointPosition, listed(camera.position));
  putNumbers(
      object, DCM_ViewpointLookAtPoint,
      listed(camera.target == camera.position ? camera.position + ahead * basis.forward : camera.target));
  putNumbers(object, DCM_ViewpointUpDirection, listed(basis.up));
  const double halfTop = halfHeight(camera) * (isPerspective ? geometry.farMm : 1.0);
  const double halfRight = halfTop * geometry.aspect;
  putNumbers(object, DCM_RenderFieldOfView,
             {-halfRight, halfRight, halfTop, -halfTop, geometry.nearMm, geometry.farMm});
  const char* method = geometry.projection == Projection::mip     ? "MAXIMUM_IP"
                       : geometry.projection == Projection::minip ? "MINIMUM_IP"
                                                                  : "VOLUME_RENDERED";
  putText(object, DCM_RenderingMethod, std::string(method));
  if (geometry.stepMm)
    putNumbers(object, DCM_SamplingStepSize, {*geometry.stepMm});
}

Geometry geometryIn(DcmItem& object, const std::string& name, std::vector<Message>& changes) {
  Geometry geometry;
  Camera& camera = geometry.camera;
  camera.projection =
      isPerspectiveIn(object, name) ? Camera::Projection::perspective : Camera::Projection::orthographic;
  camera.position = vectorIn(object, DCM_ViewpointPosition, name);
  camera.target = vectorIn(object, DCM_ViewpointLookAtPoint, name);
  camera.up = vectorIn(object, DCM_ViewpointUpDirection, name);
  if (camera.position == camera.target)
    failReading(name, Message::tr("its viewpoint is the point that it looks at"), exportAgain);
  const FieldOfView view = fieldOfViewIn(object, name);
  const double halfTop = 0.5 * (view.top - view.bottom);
  camera.fovYDeg = glm::degrees(2.0 * std::atan(halfTop / view.farMm));
  camera.heightMm = 2.0 * halfTop;
  if (camera.projection == Camera::Projection::perspective)
    camera.heightMm = Camera{}.heightMm;
  else
    camera.fovYDeg = Camera{}.fovYDeg;
  centre(view, camera, changes);
  geometry.aspect = (view.right - view.left) / (view.top - view.bottom);
  geometry.nearMm = view.nearMm;
  geometry.farMm = view.farMm;
  geometry.projection = methodIn(object, name);
  if (const auto step = numberIn(object, DCM_SamplingStepSize); step && *step > 0.0)
    geometry.stepMm = step;
  return geometry;
}

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
