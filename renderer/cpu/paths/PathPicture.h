// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PathFigures.h"
#include "engine/PixelRect.h"
#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace limn::cpu {

/// What the paths of one pixel found. Sums are taken path after path, so that no thread and no pass shows.
struct PixelPaths {
  glm::dvec3 sum{0.0};     ///< of radiances
  glm::dvec3 squares{0.0}; ///< of each channel
  glm::vec3 half{0.0f};    ///< the sum over every second path that met something, to judge a filter by
  int met = 0;             ///< how many met something
  int paths = 0;
  float alpha = -1.0f; ///< negative: not known yet

  /// A pixel counts from half a level of alpha on (DEFINITION section 9).
  bool isCovered() const { return alpha >= 1.0f / 510.0f; }
};

/// A picture of physical light on its way: the same for each number of paths, whatever tiles, passes and
/// threads brought it there. It keeps radiances: exposure and knee say how they are shown, whenever that is
/// asked for.
class PathPicture {
public:
  PathPicture(const Scene& scene, const glm::ivec2& size);

  /// Whether it is that of a scene, however many paths it asks for and however they are shown.
  bool isOf(const Scene& scene, const glm::ivec2& size) const;
  bool isOfVolume(const Scene& scene) const { return m_scene.volume == scene.volume; }

  const glm::ivec2& size() const { return m_size; }
  const std::vector<PixelPaths>& pixels() const { return m_pixels; } ///< rows from the top
  PixelPaths& at(int x, int y) { return m_pixels[static_cast<std::size_t>(y) * m_size.x + x]; }

  /// Pixels that had more paths begin anew.
  void limit(const PixelRect& tile, int paths);
  bool knowsAlpha(const PixelRect& tile) const;
  /// Premultiplied display colours, or linear radiance times alpha.
  Image displayedTile(const PixelRect& tile, const Shading& shading, int threads) const;
  Image radianceTile(const PixelRect& tile) const;
  PathFigures figures(const Shading& shading, int threads) const;
  /// Of each pixel the standard error of the worst of its display colours, 255 levels; less than 0 where
  /// nothing is covered.
  std::vector<float> errors(const Shading& shading, int threads) const;

  /// How many paths it goes on from: those that half of the covered pixels have. 0 where one has none.
  int followed() const;
  std::size_t bytes() const { return m_pixels.size() * sizeof(PixelPaths); }

private:
  Scene m_scene; ///< as far as paths depend on it
  glm::ivec2 m_size;
  std::vector<PixelPaths> m_pixels;
};

/// The pictures drawn last, the newest first: two sides, and beside them those before, as long as there is
/// room. Where there is none the smallest goes first: coarse ones of a drag, of which there are many, before
/// the whole picture from which it began.
class PathPictures {
public:
  explicit PathPictures(std::size_t mostBytes = usualBytes) : m_mostBytes(mostBytes) {}

  PathPicture& of(const Scene& scene, const glm::ivec2& size);
  const PathPicture* find(const Scene& scene, const glm::ivec2& size) const;
  std::size_t bytes() const;

private:
  using Kept = std::deque<std::unique_ptr<PathPicture>>;
  Kept::iterator leastWorth();

  static constexpr std::size_t alwaysKept = 2;
  static constexpr std::size_t mostKept = 6;
  // Of two sides of 1600 × 1000 whole, and of half the width, with what is coarser.
  static constexpr std::size_t usualBytes = std::size_t{256} << 20;
  std::size_t m_mostBytes;
  Kept m_pictures;
};

} // namespace limn::cpu
