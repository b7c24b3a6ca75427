// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dicom/header/DicomHeader.h"

#include "io/dicom/header/DicomTags.h"

#include <cmath>
#include <cstdio>

namespace limn {
namespace {

// How far unit vectors may be off length and right angle before they are called damaged.
constexpr double orientationTolerance = 1e-2;

// Where the attributes of a frame may stand, most specific first.
struct Sources {
  const DicomDataset* perFrame = nullptr;
  const DicomDataset* shared = nullptr;
  const DicomDataset* root = nullptr;

  // The item of a functional group that holds `tag`; the root where none does.
  const DicomDataset& holding(DicomTag sequence, DicomTag tag) const {
    for (const DicomDataset* groups : {perFrame, shared}) {
      const DicomDataset* item = groups ? firstItemOf(*groups, sequence) : nullptr;
      if (item && has(*item, tag))
        return *item;
    }
    return *root;
  }
};

std::optional<std::array<glm::dvec3, 2>> axesOf(const DicomDataset& dataset) {
  const std::vector<double> n = decimalsOf(dataset, tag::imageOrientation);
  if (n.size() != 6)
    return std::nullopt;
  const glm::dvec3 row(n[0], n[1], n[2]);
  const glm::dvec3 column(n[3], n[4], n[5]);
  const bool isSound = std::abs(glm::length(row) - 1.0) < orientationTolerance &&
                       std::abs(glm::length(column) - 1.0) < orientationTolerance &&
                       std::abs(glm::dot(row, column)) < orientationTolerance;
  if (!isSound)
    return std::nullopt;
  const glm::dvec3 x = glm::normalize(row);
  return std::array{x, glm::normalize(column - x * glm::dot(x, column))};
}

// A place within a thousand kilometres: beyond, numbers are damage, and distances lose their digits.
std::optional<glm::dvec3> sane(const std::optional<glm::dvec3>& place) {
  constexpr double farthestMm = 1e9;
  return place && glm::length(*place) <= farthestMm ? place : std::nullopt;
}

// (0028,0030) gives the distance between rows first.
std::optional<glm::dvec2> spacingOf(const DicomDataset& dataset, DicomTag tag) {
  const std::vector<double> rowsThenColumns = decimalsOf(dataset, tag);
  if (rowsThenColumns.size() != 2 || !(rowsThenColumns[0] > 0.0) || !(rowsThenColumns[1] > 0.0))
    return std::nullopt;
  return glm::dvec2(rowsThenColumns[1], rowsThenColumns[0]);
}

std::optional<double> positive(std::optional<double> length) {
  return length && *length > 0.0 ? length : std::nullopt;
}

// One number of an attribute: `otherwise` where it is absent, NaN where it is no number or several.
double numberOr(const DicomDataset& dataset, DicomTag tag, double otherwise) {
  if (!has(dataset, tag) || textOf(dataset, tag).empty())
    return otherwise;
  const std::vector<double> numbers = decimalsOf(dataset, tag);
  return numbers.size() == 1 ? numbers.front() : std::nan("");
}

std::optional<Rescale> rescaleOf(const Sources& from) {
  const auto sequence = tag::pixelValueTransformationSequence;
  const DicomDataset& dataset = from.holding(sequence, tag::rescaleSlope);
  if (has(dataset, tag::rescaleSlope) || has(dataset, tag::rescaleIntercept))
    return Rescale{numberOr(dataset, tag::rescaleSlope, 1.0), numberOr(dataset, tag::rescaleIntercept, 0.0)};
  if (const auto scaling = decimalOf(*from.root, tag::doseGridScaling))
    return Rescale{*scaling, 0.0};
  return std::nullopt;
}

std::string numberText(std::optional<double> number) {
  if (!number)
    return {};
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", *number);
  return text;
}

std::array<std::string, dicomPhaseCount> phasesOf(const Sources& from) {
  const auto index = [](DicomPhase phase) { return static_cast<std::size_t>(phase); };
  std::array<std::string, dicomPhaseCount> phase;
  const DicomDataset& content = from.holding(tag::frameContentSequence, tag::temporalPositionIndex);
  const auto temporal = unsignedOf(content, tag::temporalPositionIndex);
  phase[index(DicomPhase::temporalPosition)] =
      temporal ? std::to_string(*temporal) : textOf(*from.root, tag::temporalPosition);
  phase[index(DicomPhase::triggerTime)] = textOf(*from.root, tag::triggerTime);
  phase[index(DicomPhase::cardiacDelay)] = numberText(floatOf(
      from.holding(tag::cardiacSynchronizationSequence, tag::cardiacTriggerDelay), tag::cardiacTriggerDelay));
  const auto echo =
      floatOf(from.holding(tag::mrEchoSequence, tag::effectiveEchoTime), tag::effectiveEchoTime);
  phase[index(DicomPhase::echoTime)] = echo ? numberText(echo) : textOf(*from.root, tag::echoTime);
  phase[index(DicomPhase::diffusionBValue)] =
      numberText(floatOf(from.holding(tag::mrDiffusionSequence, tag::diffusionBValue), tag::diffusionBValue));
  phase[index(DicomPhase::imageType)] = textOf(*from.root, tag::imageType);
  phase[index(DicomPhase::acquisitionNumber)] = textOf(*from.root, tag::acquisitionNumber);
  phase[index(DicomPhase::acquisitionTime)] = textOf(*from.root, tag::acquisitionTime);
  phase[index(DicomPhase::contentTime)] = textOf(*from.root, tag::contentTime);
  return phase;
}

DicomFrame frameFrom(const Sources& from, bool mayUseRootPosition) {
  DicomFrame frame;
  const DicomDataset& place = from.holding(tag::planePositionSequence, tag::imagePosition);
  if (&place != from.root || mayUseRootPosition)
    frame.positionMm = sane(decimalVectorOf(place, tag::imagePosition));
  frame.axes = axesOf(from.holding(tag::planeOrientationSequence, tag::imageOrientation));
  const auto measures = tag::pixelMeasuresSequence;
  frame.pixelSpacingMm = spacingOf(from.holding(measures, tag::pixelSpacing), tag::pixelSpacing);
  if (!frame.pixelSpacingMm)
    frame.pixelSpacingMm = spacingOf(*from.root, tag::imagerPixelSpacing);
  frame.thicknessMm = positive(decimalOf(from.holding(measures, tag::sliceThickness), tag::sliceThickness));
  frame.betweenSlicesMm =
      positive(decimalOf(from.holding(measures, tag::spacingBetweenSlices), tag::spacingBetweenSlices));
  frame.rescale = rescaleOf(from);
  frame.rescaleType =
      textOf(from.holding(tag::pixelValueTransformationSequence, tag::rescaleType), tag::rescaleType);
  frame.stackId = textOf(from.holding(tag::frameContentSequence, tag::stackId), tag::stackId);
  frame.phase = phasesOf(from);
  return frame;
}

// Places the frames of a dose grid: offsets along the normal from the first, or patient z where the first
// offset is not 0 (PS3.3, C.8.8.3.2).
void placeByOffsets(const DicomDataset& dataset, std::vector<DicomFrame>& frames) {
  const std::vector<double> offsets = decimalsOf(dataset, tag::gridFrameOffsets);
  const auto first = decimalVectorOf(dataset, tag::imagePosition);
  if (offsets.size() != frames.size() || !first || !frames.front().axes)
    return;
  const auto& axes = *frames.front().axes;
  const glm::dvec3 normal = glm::cross(axes[0], axes[1]);
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].positionMm = sane(*first + (offsets[i] - offsets[0]) * normal);
}

} // namespace

std::vector<DicomFrame> framesOf(const DicomDataset& dataset, int count) {
  const auto groups = dataset.elements.find(tag::perFrameFunctionalGroups);
  Sources from;
  from.shared = firstItemOf(dataset, tag::sharedFunctionalGroups);
  from.root = &dataset;
  std::vector<DicomFrame> frames;
  frames.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const bool isListed =
        groups != dataset.elements.end() && static_cast<std::size_t>(i) < groups->second.items.size();
    from.perFrame = isListed ? &groups->second.items[static_cast<std::size_t>(i)] : nullptr;
    frames.push_back(frameFrom(from, count == 1));
  }
  if (count > 1 && has(dataset, tag::gridFrameOffsets))
    placeByOffsets(dataset, frames);
  return frames;
}

} // namespace limn
