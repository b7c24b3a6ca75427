// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientField.h"

#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {
namespace {

// Of pictures side by side.
constexpr std::size_t mostSmoothed = 2;

} // namespace

double GradientField::more(const std::shared_ptr<const Volume>& volume, double sigmaMm,
                           const Effort& effort) {
  if (m_volume != volume)
    while (!m_smoothed.empty())
      dropLast();
  m_volume = volume;
  m_plain.setVolume(m_volume);
  m_isAskedFor = false;
  if (!m_volume || !(sigmaMm > 0.0))
    return 1.0;
  const auto there = std::ranges::find_if(
      m_smoothed, [&](const Smoothed& smoothed) { return smoothed.smoothing.sigmaMm() == sigmaMm; });
  if (there != m_smoothed.end()) {
    std::rotate(m_smoothed.begin(), there, there + 1);
  } else {
    makeRoom();
    m_smoothed.push_front({Smoothing(m_volume, sigmaMm), {}});
  }
  Smoothed& wanted = m_smoothed.front();
  const double done = wanted.smoothing.more(effort);
  m_isAskedFor = done == 1.0;
  if (m_isAskedFor)
    wanted.scales.setVolume(wanted.smoothing.smoothed());
  return done;
}

// Those that make room go first: three, or two, need not fit into memory. What lies on the disk asks that for
// room.
void GradientField::makeRoom() {
  if (m_smoothed.size() == mostSmoothed)
    dropLast();
  while (!m_smoothed.empty() && !holdsOneMore())
    dropLast();
  // Who draws holds the field of the last picture until it has the next, which then takes its place.
  std::erase_if(m_dropped, [](const std::weak_ptr<const Volume>& one) { return one.expired(); });
  if (m_dropped.empty() && !holdsOneMore())
    throw Error(Error::Kind::other,
                Message::tr("Smooth normals of this volume take %1 GB of memory, and %2 GB are free; switch "
                            "them off, or close other programs.")
                    .arg(Message::fixed(1e-9 * static_cast<double>(bytesEach()), 1),
                         Message::fixed(1e-9 * static_cast<double>(m_free().value_or(0)), 1)));
}

void GradientField::dropLast() {
  if (const std::shared_ptr<const Volume> field = m_smoothed.back().smoothing.smoothed())
    m_dropped.push_back(field);
  m_smoothed.pop_back();
}

bool GradientField::holdsOneMore() const {
  const std::optional<std::uint64_t> free = m_volume->room() ? std::nullopt : m_free();
  return !free || bytesEach() <= *free;
}

std::size_t GradientField::bytesEach() const {
  return m_volume->voxelCount() * sizeof(float);
}

GradientScale GradientField::scale(const Shading& shading, bool usesRatio, const Effort& effort) {
  GradientScale scale = (m_isAskedFor ? m_smoothed.front().scales : m_plain).of(shading, usesRatio, effort);
  scale.smoothed = smoothed();
  return scale;
}

std::size_t GradientField::ownBytes() const {
  return m_smoothed.empty() ? 0 : m_smoothed.size() * bytesEach();
}

glm::dvec3 followedGradientAt(const Volume& volume, const GradientScale& scale, const glm::dvec3& index) {
  const bool isThere = scale.smoothed && scale.smoothed->grid() == volume.grid();
  return glm::transpose(volume.grid().direction) * gradientAt(isThere ? *scale.smoothed : volume, index);
}

} // namespace limn
