// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Segmentation.h"

#include "io/dicom/DicomSegmentation.h"
#include "scene/basics/Message.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/volume/NearestVoxel.h"
#include "scene/volume/VolumePart.h"

#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace limn::dicom {
namespace {

constexpr std::size_t longestName = 64; // of VR LO, in characters

/// A label that is written.
struct Written {
  std::size_t place = 0;
  std::string name; ///< UTF-8
  glm::dvec3 color{1.0};
};

std::string rangeOf(const ConnectedPiece& piece, const std::string& unit) {
  constexpr int digits = 4;
  const std::string range = Message::rounded(piece.range.x, digits).english() + " to " +
                            Message::rounded(piece.range.y, digits).english();
  return unit.empty() ? range : range + " " + unit;
}

// The names of the pieces that have a look, in their order: as a person called them, or by their ranges.
std::vector<std::string> pieceNames(const Region& keep, const std::string& unit) {
  std::vector<std::string> names;
  for (const Cut& cut : keep.cuts)
    if (const ConnectedPiece* piece = pieceWithLook(cut))
      names.push_back(!cut.name.empty()
                          ? cut.name
                          : "Piece " + std::to_string(names.size() + 1) + ", " + rangeOf(*piece, unit));
  return names;
}

// Whether the seed of a piece is among what was cut away. What took a piece took its seed; where nothing was
// found there it took neither.
bool isSeedRemoved(const Region& keep, const Grid& grid, const ConnectedPiece& piece) {
  const std::optional<glm::ivec3> voxel = nearestVoxel(worldToIndex(grid, piece.seedMm), grid.dims);
  return voxel && keep.labels->placeAt(voxelOffset(grid.dims, voxel->x, voxel->y, voxel->z)) + 1 ==
                      keep.labels->labels().size();
}

// What went, by the names of the cuts that took it; lines that have none are only counted, beside others.
std::string removedName(const Region& keep, const Grid& grid, const std::string& unit) {
  std::string names;
  const auto add = [&names](const std::string& name) { names += (names.empty() ? "" : "; ") + name; };
  int lines = 0;
  for (const Cut& cut : keep.cuts) {
    const auto* piece = std::get_if<ConnectedPiece>(&cut.how);
    if (!takesAway(cut) ||
        (piece && isSeedRemoved(keep, grid, *piece) != (piece->fate == ConnectedPiece::Fate::hidden)))
      continue;
    if (piece && piece->fate == ConnectedPiece::Fate::alone)
      add("all but " + (cut.name.empty() ? "piece " + rangeOf(*piece, unit) : cut.name));
    else if (!cut.name.empty())
      add(cut.name);
    else if (piece)
      add("piece " + rangeOf(*piece, unit));
    else
      ++lines;
  }
  if (lines > 0 && !names.empty())
    add(lines == 1 ? "1 line" : std::to_string(lines) + " lines");
  return names.empty() ? "Cut away" : "Cut away: " + names;
}

// What a piece that was kept alone leaves of everything, or of the body; otherwise what that is called.
std::string keptName(const Region& keep, const Grid& grid, const std::string& unit,
                     const std::string& otherwise) {
  std::string name = otherwise;
  if (std::none_of(keep.cuts.begin(), keep.cuts.end(), takesAway) ||
      isEmpty(keep.labels->boxAround(keep.labels->labels().size() - 1)))
    return name;
  for (const Cut& cut : keep.cuts)
    if (const auto* piece = std::get_if<ConnectedPiece>(&cut.how);
        piece && cut.isOn && piece->fate == ConnectedPiece::Fate::alone && !isSeedRemoved(keep, grid, *piece))
      name = cut.name.empty() ? "Kept: piece " + rangeOf(*piece, unit) : cut.name;
  return name;
}

std::vector<Written> writtenOf(const Region& keep, const Grid& grid, const std::string& unit = {}) {
  std::vector<Written> written;
  if (!keep.labels)
    return written;
  const std::vector<Label>& labels = keep.labels->labels();
  const std::vector<std::string> pieces = pieceNames(keep, unit);
  const std::size_t own = ownLabels(keep);
  for (std::size_t place = 0; place < labels.size(); ++place) {
    const bool isBackground = keep.kind == Region::Kind::labels &&
                              (labels[place].value == 0 || labels[place].value == tableLabelValue);
    if (isBackground || isEmpty(keep.labels->boxAround(place)))
      continue;
    std::string name = labels[place].name;
    if (place >= own)
      name = place - own < pieces.size() ? pieces[place - own] : removedName(keep, grid, unit);
    else if (keep.kind == Region::Kind::all)
      name = keptName(keep, grid, unit, "Kept");
    else if (keep.kind == Region::Kind::body && place == 1)
      name = keptName(keep, grid, unit, name);
    written.push_back({place, name, labels[place].color});
  }
  return written;
}

OFString dsText(double number) {
  return decimalText(number).c_str();
}

// The first characters of a text in UTF-8, none cut in two.
std::string shortened(const std::string& text) {
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    if ((static_cast<unsigned char>(text[at]) & 0xC0) != 0x80 && ++characters > longestName)
      return text.substr(0, at);
  return text;
}

void requireMade(const OFCondition& made) {
  require(made.good(), DCM_SegmentSequence);
}

// What all frames share: how they lie, how large pixels are, of which images they are.
void putShared(DcmSegmentation& segmentation, const Grid& grid, const SeriesImages& series) {
  const glm::dmat3& axes = grid.direction;
  const std::unique_ptr<FGPlaneOrientationPatient> plane(
      FGPlaneOrientationPatient::createMinimal(dsText(axes[0].x), dsText(axes[0].y), dsText(axes[0].z),
                                               dsText(axes[1].x), dsText(axes[1].y), dsText(axes[1].z)));
  FGPixelMeasures pixels;
  const OFString apart = dsText(grid.spacingMm.z);
  requireMade(pixels.setPixelSpacing(dsText(grid.spacingMm.y) + "\\" + dsText(grid.spacingMm.x)));
  requireMade(pixels.setSliceThickness(apart));
  requireMade(pixels.setSpacingBetweenSlices(apart));
  OFVector<ImageSOPInstanceReferenceMacro> sources;
  for (const DicomReference& image : series.images) {
    ImageSOPInstanceReferenceMacro source;
    requireMade(source.setReferencedSOPClassUID(image.sopClass.c_str()));
    requireMade(source.setReferencedSOPInstanceUID(image.sopInstance.c_str()));
    sources.push_back(source);
  }
  const std::unique_ptr<FGDerivationImage> derived(
      DcmSegmentation::createDerivationImageFG(sources, "Kept and cut away in a volume rendering"));
  require(plane && derived, DCM_SharedFunctionalGroupsSequence);
  requireMade(segmentation.addForAllFrames(*plane));
  requireMade(segmentation.addForAllFrames(pixels));
  requireMade(segmentation.addForAllFrames(*derived));
}

// A segment whose name is written later, in the character set of the whole object.
Uint16 addSegment(DcmSegmentation& segmentation, const Written& label, int number) {
  DcmSegment* made = nullptr;
  const CodeSequenceMacro tissue("85756007", "SCT", "Tissue");
  const OFString name = ("Segment " + std::to_string(number)).c_str();
  requireMade(
      DcmSegment::create(made, name, tissue, tissue, DcmSegTypes::SAT_SEMIAUTOMATIC, "Limn cuts and labels"));
  std::unique_ptr<DcmSegment> segment(made);
  const std::array<std::uint16_t, 3> color = cieLabOfColor(label.color);
  requireMade(segment->setRecommendedDisplayCIELabValue(color[0], color[1], color[2]));
  Uint16 added = 0;
  requireMade(segmentation.addSegment(segment.get(), added));
  static_cast<void>(segment.release()); // which is the segmentation's now
  return added;
}

/// The pixels of all frames, a bit each, one frame right behind the other: DCMTK 3.6.7 drops the last bits
/// where those of a frame fill no bytes.
class Bits {
public:
  void add(const std::vector<Uint8>& pixels) {
    for (const Uint8 pixel : pixels) {
      if (m_count % 8 == 0)
        m_bytes.push_back(0);
      m_bytes.back() |= static_cast<Uint8>(pixel << m_count++ % 8);
    }
  }

  std::vector<Uint8> bytes() const {
    std::vector<Uint8> even = m_bytes;
    even.resize(even.size() + even.size() % 2); // a value has an even length
    return even;
  }

private:
  std::vector<Uint8> m_bytes;
  std::size_t m_count = 0;
};

// The slices in which a label has a voxel.
void addFrames(DcmSegmentation& segmentation, const LabelMap& map, std::size_t place, const Grid& grid,
               Uint16 segment, Bits& bits) {
  const glm::ivec3& dims = map.dims();
  std::vector<Uint8> pixels(static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y));
  const VoxelBox& box = map.boxAround(place);
  for (int z = box.lower.z; z < box.upper.z; ++z) {
    const std::size_t first = voxelOffset(dims, 0, 0, z);
    std::visit(
        [&](const auto& places) {
          for (std::size_t n = 0; n < pixels.size(); ++n)
            pixels[n] = places[first + n] == place ? 1 : 0;
        },
        map.places());
    if (std::find(pixels.begin(), pixels.end(), 1) == pixels.end())
      continue;
    const glm::dvec3 position = indexToWorld(grid, {0.0, 0.0, static_cast<double>(z)});
    const std::unique_ptr<FGPlanePosPatient> plane(
        FGPlanePosPatient::createMinimal(dsText(position.x), dsText(position.y), dsText(position.z)));
    require(plane != nullptr, DCM_PlanePositionSequence);
    FGFrameContent content;
    requireMade(content.setStackID("1"));
    requireMade(content.setInStackPositionNumber(static_cast<Uint32>(z) + 1));
    requireMade(content.setDimensionIndexValues(segment, 0));
    requireMade(content.setDimensionIndexValues(static_cast<Uint32>(z) + 1, 1));
    OFVector<FGBase*> groups;
    groups.push_back(plane.get());
    groups.push_back(&content);
    requireMade(segmentation.addFrame(pixels.data(), segment, groups));
    bits.add(pixels);
  }
}

} // namespace

bool hasSegments(const Region& keep, const Grid& grid) {
  return !writtenOf(keep, grid).empty();
}

void putSegmentation(DcmItem& object, const Region& keep, const Grid& grid, DcmItem& image,
                     const SeriesImages& series, const std::string& organisation,
                     const std::string& version) {
  DcmSegmentation* made = nullptr;
  ContentIdentificationMacro content;
  requireMade(content.setInstanceNumber("1"));
  requireMade(content.setContentLabel("LIMN SEGMENTS"));
  requireMade(DcmSegmentation::createBinarySegmentation(
      made, static_cast<Uint16>(grid.dims.y), static_cast<Uint16>(grid.dims.x),
      IODGeneralEquipmentModule::EquipmentInfo("Limn", "Limn", "0", version.c_str()), content));
  const std::unique_ptr<DcmSegmentation> segmentation(made);
  requireMade(segmentation->importFromSourceImage(image));
  requireMade(segmentation->getSeries().setSeriesNumber("1"));
  IODMultiframeDimensionModule& dimensions = segmentation->getDimensions();
  requireMade(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organisation.c_str(),
                                           DCM_SegmentIdentificationSequence, "Segment"));
  requireMade(dimensions.addDimensionIndex(DCM_InStackPositionNumber, organisation.c_str(),
                                           DCM_FrameContentSequence, "Slice"));
  putShared(*segmentation, grid, series);
  int number = 0;
  Bits bits;
  for (const Written& label : writtenOf(keep, grid))
    addFrames(*segmentation, *keep.labels, label.place, grid, addSegment(*segmentation, label, ++number),
              bits);
  requireMade(segmentation->writeDataset(object));
  const std::vector<Uint8> bytes = bits.bytes();
  require(object
              .putAndInsertUint8Array(DcmTag(DCM_PixelData, EVR_OB), bytes.data(),
                                      static_cast<unsigned long>(bytes.size()))
              .good(),
          DCM_PixelData);
  putCommonReferences(object, series.series, series.images);
}

void putSegmentNames(DcmItem& object, const Region& keep, const Grid& grid, const std::string& unit) {
  require(object.convertToUTF8().good(), DCM_SpecificCharacterSet);
  putText(object, DCM_SpecificCharacterSet, "ISO_IR 192");
  const std::vector<Written> written = writtenOf(keep, grid, unit);
  const std::vector<DcmItem*> segments = itemsIn(object, DCM_SegmentSequence);
  for (std::size_t n = 0; n < written.size(); ++n)
    if (!written[n].name.empty())
      putText(*segments[n], DCM_SegmentLabel, shortened(written[n].name));
}

} // namespace limn::dicom
