// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Body.h"

#include "regions/Flood.h"
#include "regions/ValueSet.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double tissueHu = -300.0;

using Word = BitGrid::Word;

std::size_t facesAlongRow(const Word* a, const Word* b, int words) {
  constexpr int topBit = BitGrid::wordBits - 1;
  std::size_t faces = 0;
  for (int w = 0; w < words; ++w) {
    const Word below = b[w] << 1 | (w > 0 ? b[w - 1] >> topBit : 0);
    const Word above = b[w] >> 1 | (w + 1 < words ? b[w + 1] << topBit : 0);
    faces += std::popcount(a[w] & below) + std::popcount(a[w] & above);
  }
  return faces;
}

std::size_t facesBetweenRows(const Word* a, const Word* b, int words) {
  std::size_t faces = 0;
  for (int w = 0; w < words; ++w)
    faces += std::popcount(a[w] & b[w]);
  return faces;
}

constexpr double ballMm = 2.0;
constexpr double marginVoxels = 2.0;
constexpr double leastShare = 0.8;     // of the tissue, which a sure body holds
constexpr double mostContact = 0.05;   // of its surface, by which what is cut off may touch the body
constexpr double nextToNothing = 0.01; // of the tissue
constexpr double worthHiding = 0.001;  // of the tissue

double shareOf(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
}

// Rounded down, so that what misses a bound does not read as if it reached it.
Message percent(double share) {
  return Message::tr("%1 %").arg(Message::fixed(std::floor(100.0 * share), 0));
}

// The largest piece of tissue; by how much of its surface what the ball cuts off touches it, 0 where that is
// next to nothing.
struct Piece {
  BitGrid voxels;
  double contact = 0.0;
};

// Cuts off what hangs on the body by less than the ball, but only where that leaves no doubt.
Piece largestPiece(const BitGrid& tissue, const glm::dvec3& ball, const Effort& effort) {
  const BitGrid bulky = opened(tissue, ball, partOf(effort, 0.0, 0.6));
  BitGrid body = largestComponent(bulky, partOf(effort, 0.6, 1.0));
  if (body.count() == 0)
    return {largestComponent(tissue, effort)};
  BitGrid thin = tissue;
  thin -= bulky;
  body = grownWithin(body, thin, effort);
  const BitGrid whole = grownWithin(body, tissue, effort);
  BitGrid cutOff = whole;
  cutOff -= body;
  const std::size_t all = tissue.count();
  if (shareOf(cutOff.count(), all) <= nextToNothing)
    return {whole};
  const double contact = shareOf(sharedFaces(cutOff, body), sharedFaces(cutOff, cutOff.complement()));
  const bool isCut = contact <= mostContact && shareOf(body.count(), all) >= leastShare;
  return {isCut ? body : whole, contact};
}

Region regionOf(const BitGrid& kept, const std::shared_ptr<Room>& room, const Effort& effort) {
  const glm::ivec3& dims = kept.dims();
  RoomVector<std::uint8_t> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, room);
  forEachPiece(dims.z, effort, [&](int z) {
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        places[voxelOffset(dims, x, y, z)] = kept.at({x, y, z}) ? 1 : 0;
  });
  return bodyRegion(dims, std::move(places));
}

// Why a body is not sure that leaves `beside` of the tissue out; empty where it is.
Message doubtAbout(double beside, double contact, bool isAlone) {
  if (1.0 - beside < leastShare)
    return Message::tr("only %1 of the tissue hangs together, so a part of the patient may be hidden")
        .arg(percent(1.0 - beside));
  if (contact > mostContact)
    return Message::tr(
               "what lies against the body touches it by %1 of its surface, so a part of the table may "
               "be kept")
        .arg(percent(contact));
  return isAlone ? Message::tr("nothing lies beside it") : Message();
}

} // namespace

double tissueThreshold(const Volume& volume, const Effort& effort) {
  return looksLikeHounsfield(volume) ? tissueHu : objectThreshold(histogramOf(volume, 1024, effort));
}

BitGrid tissueOf(const Volume& volume, double threshold, const Effort& effort) {
  return valuesWithin(volume, {threshold, std::numeric_limits<double>::infinity()}, effort);
}

std::size_t sharedFaces(const BitGrid& a, const BitGrid& b) {
  const glm::ivec3& dims = a.dims();
  const int words = a.rowWords();
  std::size_t faces = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      faces += facesAlongRow(a.row(y, z), b.row(y, z), words);
      for (const glm::ivec2& near : {glm::ivec2(y - 1, z), {y + 1, z}, {y, z - 1}, {y, z + 1}})
        if (near.x >= 0 && near.x < dims.y && near.y >= 0 && near.y < dims.z)
          faces += facesBetweenRows(a.row(y, z), b.row(near.x, near.y), words);
    }
  return faces;
}

BodyFinding findBody(const Volume& volume, const Effort& effort) {
  const double threshold = tissueThreshold(volume, partOf(effort, 0.0, 0.1));
  const BitGrid tissue = tissueOf(volume, threshold, partOf(effort, 0.1, 0.2));
  const std::size_t all = tissue.count();
  if (all == 0)
    return {{}, false, false, Message::tr("it holds no tissue")};
  const glm::dvec3 ball = glm::max(ballMm / volume.grid().spacingMm, glm::dvec3(1.0));
  const Piece piece = largestPiece(tissue, ball, partOf(effort, 0.2, 0.6));
  const BitGrid body =
      withHolesFilled(closed(piece.voxels, ball, partOf(effort, 0.6, 0.8)), partOf(effort, 0.8, 0.9));
  BitGrid kept = dilated(body, glm::dvec3(marginVoxels), partOf(effort, 0.9, 0.95));
  kept -= tissue;
  kept |= body;
  BitGrid beside = tissue;
  beside -= kept;
  const double share = shareOf(beside.count(), all);
  const bool isAlone = share < worthHiding;
  const Message doubt = doubtAbout(share, piece.contact, isAlone);
  return {regionOf(kept, volume.room(), partOf(effort, 0.95, 1.0)), doubt.empty(), isAlone, doubt};
}

} // namespace limn
