// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlanePictures.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

namespace limn {
namespace {

// Told apart from any grey and from the crosshair, by eyes of every kind.
constexpr std::uint32_t outlineColor = 0xffffc83c;

// Of the colour of a label that covers its tissue: its structure is what the slice is for.
constexpr double labelCover = 0.2;
constexpr double litCover = 0.4;
constexpr std::uint32_t litColor = 0xffff5040;

// What of the content changes the picture of a slice that was read.
PlaneContent withoutPlaces(PlaneContent content) {
  const PlaneSettings& settings = content.settings;
  PlaneSettings kept;
  kept.window = windowOf(content);
  kept.isTinted = settings.isTinted;
  kept.outlinesRegion = settings.outlinesRegion;
  content.settings = kept;
  content.crop = {}; // stands above the picture, as what was measured does
  content.measured = {};
  content.inHand = {};
  content.firstWindow = {};
  if (!kept.isTinted && !content.emphasisedPoint) {
    content.function = {};
    if (!kept.outlinesRegion) { // in the colours of the labels' curves
      content.keep.looks.clear();
      content.keep.lookOf.clear();
    }
  }
  return content;
}

// A slice classifies each place by itself, whatever the picture projects. Of a label's curve in which a point
// lights up nothing else shows.
LabelLooks looksIn(const PlaneContent& content) {
  const Region& keep = content.keep;
  if (content.emphasisedPoint && content.emphasisedLabel) {
    LabelLooks looks{{TransferFunction{}, keep.looks[lookOfLabel(keep, *content.emphasisedLabel) - 1]},
                     std::vector<std::uint8_t>(keep.weights.size(), 0)};
    looks.ofLabel[*content.emphasisedLabel] = 1;
    return looks;
  }
  Scene scene;
  scene.transferFunction = content.function;
  scene.keep = keep;
  return labelLooks(scene);
}

std::uint32_t opaqueOf(const glm::dvec3& color) {
  const glm::uvec3 bytes(glm::round(glm::clamp(color, 0.0, 1.0) * 255.0));
  return 0xff000000U | bytes.r << 16 | bytes.g << 8 | bytes.b;
}

// Of a segmentation: labels that are shown, but for the background.
std::vector<std::uint32_t> colorsOf(const Region& keep, const ShownColors& shown) {
  const std::vector<Label>& labels = keep.labels->labels();
  std::vector<std::uint32_t> colors(ownLabels(keep), 0);
  for (std::size_t place = 0; place < colors.size(); ++place)
    if (labels[place].value != 0 && keep.weights[place] > 0.0)
      colors[place] = opaqueOf(shown.of(place));
  return colors;
}

QImage imageOf(const std::vector<std::uint32_t>& pixels, const glm::ivec2& size) {
  QImage image(size.x, size.y, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < size.y; ++y)
    std::memcpy(image.scanLine(y), pixels.data() + static_cast<std::size_t>(y) * size.x,
                static_cast<std::size_t>(size.x) * sizeof(std::uint32_t));
  return image;
}

} // namespace

PlaneReading readingOf(const PlaneContent& content, const PlaneGrid& plane) {
  return {content.volume, plane, {content.settings.interpolation, content.settings.slab}};
}

const QImage& PlanePictures::picture(const PlaneContent& content, const PlaneGrid& plane, int outlinePixels) {
  const PlaneReading wanted = readingOf(content, plane);
  const PlaneContent painted = withoutPlaces(content);
  const bool isRead = wanted == m_read;
  if (isRead && painted == m_painted)
    return m_picture;
  if (!isRead) {
    const auto start = std::chrono::steady_clock::now();
    PlaneImage values = reformatted(*wanted.volume, wanted.plane, wanted.sampling);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    keep(wanted, std::move(values), taken.count());
  }
  const bool weighs = isRestricting(content.keep) && (content.settings.isTinted || content.emphasisedPoint ||
                                                      content.settings.outlinesRegion);
  if (weighs)
    weigh(content, plane);
  // While a point lights up, its colour is the only one.
  const bool isTinted = content.settings.isTinted || content.emphasisedPoint;
  const std::optional<PlaneTint> tint =
      isTinted
          ? std::optional(PlaneTint{content.function, weighs ? &m_weights : nullptr, content.emphasisedPoint,
                                    looksOf(content, plane), content.emphasisedLabel ? 1u : 0u})
          : std::nullopt;
  std::vector<std::uint32_t> pixels = planePixels(m_values, windowOf(content), tint);
  m_keptLine.clear();
  if (weighs && content.settings.outlinesRegion)
    paintKeptLine(pixels, outlinePixels);
  paintLabelsOver(pixels, content, plane, outlinePixels); // whose lines are seen where both run
  m_picture = imageOf(pixels, plane.size);
  m_painted = painted;
  return m_picture;
}

void PlanePictures::paintKeptLine(std::vector<std::uint32_t>& pixels, int outlinePixels) {
  m_keptLine = outlineOf(m_weights, outlinePixels);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (m_keptLine[i])
      pixels[i] = outlineColor;
}

bool PlanePictures::hasKeptLineNear(const glm::ivec2& pixel, int within) const {
  const glm::ivec2 size(m_picture.width(), m_picture.height());
  const glm::ivec2 first = glm::max(pixel - within, glm::ivec2(0));
  const glm::ivec2 last = glm::min(pixel + within, size - 1);
  for (int y = first.y; y <= last.y && !m_keptLine.empty(); ++y)
    for (int x = first.x; x <= last.x; ++x)
      if (m_keptLine[static_cast<std::size_t>(y) * size.x + x])
        return true;
  return false;
}

const PlanePlaces& PlanePictures::placesIn(OnPlane& known, const std::shared_ptr<const LabelMap>& map,
                                           const PlaneContent& content, const PlaneGrid& plane) {
  if (known.map != map || !(known.plane == plane))
    known = {map, plane, placesOn(*map, content.volume->grid(), plane)};
  return known.labels;
}

// While a point lights up, its colour is the only one.
void PlanePictures::paintLabelsOver(std::vector<std::uint32_t>& pixels, const PlaneContent& content,
                                    const PlaneGrid& plane, int outlinePixels) {
  const Region& keep = content.keep;
  if (content.emphasisedPoint)
    return;
  // What was cut away is one label more, under which the others lie.
  const std::shared_ptr<const LabelMap>& map = keep.isCut ? keep.uncut : keep.labels;
  if (content.settings.outlinesRegion && keep.kind == Region::Kind::labels && map) {
    m_colors.follow(content.volume, keep);
    paintLabels(pixels, placesIn(m_labels, map, content, plane), colorsOf(keep, m_colors),
                content.settings.isTinted ? 0.0 : labelCover, outlinePixels);
  }
  if (!content.lit.map)
    return;
  std::vector<std::uint32_t> colors;
  for (const bool isLit : content.lit.isLit)
    colors.push_back(isLit ? litColor : 0);
  paintLabels(pixels, placesIn(m_lit, content.lit.map, content, plane), colors, litCover, outlinePixels);
}

int PlanePictures::coarseness(const PlaneContent& content, const PlaneGrid& plane, double mostMs) const {
  PlaneReading wanted = readingOf(content, plane);
  if (wanted == m_read)
    return 1;
  wanted.plane = m_read.plane;
  const double ms = wanted == m_read ? m_msPerPixel * plane.size.x * plane.size.y : 0.0;
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(ms / mostMs) - 1e-9)));
}

void PlanePictures::forget() {
  PlanePictures fresh;
  fresh.m_readings = m_readings;
  fresh.m_msPerPixel = m_msPerPixel;
  *this = std::move(fresh);
}

void PlanePictures::keep(const PlaneReading& read, PlaneImage values, double ms) {
  m_msPerPixel = ms / std::max(1, read.plane.size.x * read.plane.size.y);
  m_values = std::move(values);
  m_read = read;
  m_weights = {};
  m_looks = {};
  m_painted = {};
  ++m_readings;
}

void PlanePictures::weigh(const PlaneContent& content, const PlaneGrid& plane) {
  if (m_weights.size == plane.size && m_region == content.keep)
    return;
  m_weights = weightsOn(content.keep, content.volume->grid(), plane, content.settings.interpolation);
  m_region = content.keep;
}

// Other curves of the same labels read nothing again.
const PlaneLooks* PlanePictures::looksOf(const PlaneContent& content, const PlaneGrid& plane) {
  LabelLooks looks = looksIn(content);
  if (!looks.areAny())
    return nullptr;
  const bool isRead = m_looks.shares.size == plane.size && m_looked.labels == content.keep.labels &&
                      m_looked.weights == content.keep.weights && m_looks.looks.ofLabel == looks.ofLabel;
  if (!isRead)
    m_looks.shares =
        sharesOn(content.keep, looks, content.volume->grid(), plane, content.settings.interpolation);
  m_looked = content.keep;
  m_looks.looks = std::move(looks);
  return &m_looks;
}

} // namespace limn
