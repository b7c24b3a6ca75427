// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/paths/NoiseFilter.h"

#include "cpu/paths/Tone.h"
#include "cpu/rays/Threads.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace limn::cpu {
namespace {

// Pixels around one that may tell of it, and the patches around both that are compared.
constexpr int windowRadius = 7;
constexpr int patchRadius = 1;

// How many standard errors apart two patches may be: a smaller number keeps more, noise among it.
constexpr float errorsApart = 1.0f;

// So much apart, things are different ones: of some numbers tried these and the one above erred least or
// nearly so on CT and MR heads at 200², after 8 and 32 paths. Depths may differ by so many lengths for each
// pixel between.
constexpr float albedosApart = 0.16f, normalsApart = 0.5f, lengthsApart = 3.0f;

constexpr int rowsAtOnce = 16;

// So many paths of a pixel met something that each half has a mean and both have a spread.
constexpr int leastMet = 4;

/// Which of a pixel's paths: all, or every second of those that met something, or the others.
enum class Paths { all, half, otherHalf };

/// Means of radiances, and the variances of these means; less than 0 where they are not known.
struct Radiances {
  std::vector<glm::vec3> mean, variance;
  bool areKnown(std::size_t n) const { return variance[n].x >= 0.0f; }
};

Radiances radiancesOf(const PathPicture& picture, Paths which) {
  const std::vector<PixelPaths>& pixels = picture.pixels();
  Radiances found{std::vector(pixels.size(), glm::vec3(0.0f)), std::vector(pixels.size(), glm::vec3(-1.0f))};
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    const PixelPaths& pixel = pixels[n];
    if (!pixel.isCovered() || pixel.met < leastMet)
      continue;
    const double met = pixel.met;
    const glm::dvec3 whole = pixel.sum / met;
    const glm::dvec3 spread =
        glm::max(pixel.squares / met - whole * whole, glm::dvec3(0.0)) * met / (met - 1.0);
    const int inHalf = (pixel.met + 1) / 2;
    const double count = which == Paths::all ? met : which == Paths::half ? inHalf : pixel.met - inHalf;
    const glm::dvec3 sum = which == Paths::all    ? pixel.sum
                           : which == Paths::half ? glm::dvec3(pixel.half)
                                                  : pixel.sum - glm::dvec3(pixel.half);
    found.mean[n] = sum / count;
    found.variance[n] = spread / count;
  }
  return found;
}

// Variances are noise as well, and dark pixels of few paths think themselves exact: those around count.
std::vector<glm::vec3> smoothed(const Radiances& radiances, const glm::ivec2& size) {
  std::vector<glm::vec3> smooth(radiances.variance);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * size.x + x;
      if (!radiances.areKnown(n))
        continue;
      glm::vec3 sum(0.0f);
      float count = 0.0f;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.y - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.x - 1); ++u)
          if (const std::size_t at = static_cast<std::size_t>(v) * size.x + u; radiances.areKnown(at)) {
            sum += radiances.variance[at];
            count += 1.0f;
          }
      smooth[n] = sum / count;
    }
  return smooth;
}

// Filters some rows, offset by offset.
class RowFilter {
public:
  RowFilter(const Radiances& radiances, const std::vector<glm::vec3>& variance, const PathGuides& guides,
            const glm::ivec2& size, int firstRow, int endRow)
      : m_radiances(radiances), m_variance(variance), m_guides(guides), m_size(size), m_first(firstRow),
        m_end(endRow), m_top(std::max(firstRow - patchRadius, 0)),
        m_bottom(std::min(endRow + patchRadius, size.y)),
        m_distance(static_cast<std::size_t>(m_bottom - m_top) * size.x),
        m_sum(static_cast<std::size_t>(endRow - firstRow) * size.x), m_weight(m_sum.size(), 0.0f) {}

  /// Into `to`, a whole picture.
  void run(std::vector<glm::vec3>& to) {
    for (int dy = -windowRadius; dy <= windowRadius; ++dy)
      for (int dx = -windowRadius; dx <= windowRadius; ++dx)
        add({dx, dy});
    for (std::size_t i = 0; i < m_sum.size(); ++i)
      to[at(0, m_first) + i] = m_sum[i] / m_weight[i];
  }

private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * m_size.x + x; }
  std::size_t here(int x, int y) const { return static_cast<std::size_t>(y - m_top) * m_size.x + x; }

  // Adds the pixels at an offset to those that they tell of.
  void add(const glm::ivec2& offset) {
    if (offset == glm::ivec2(0)) {
      for (std::size_t i = 0; i < m_sum.size(); ++i) {
        m_sum[i] += m_radiances.mean[at(0, m_first) + i];
        m_weight[i] += 1.0f;
      }
      return;
    }
    for (int y = m_top; y < m_bottom; ++y)
      for (int x = 0; x < m_size.x; ++x)
        m_distance[here(x, y)] = distance(x, y, x + offset.x, y + offset.y);
    const float reach = lengthsApart * glm::length(glm::vec2(offset));
    for (int y = m_first; y < m_end; ++y)
      for (int x = 0; x < m_size.x; ++x) {
        if (m_distance[here(x, y)] < 0.0f)
          continue;
        const float weight = weightOf(x, y, at(x + offset.x, y + offset.y), reach);
        const std::size_t i = at(x, y - m_first);
        m_sum[i] += weight * m_radiances.mean[at(x + offset.x, y + offset.y)];
        m_weight[i] += weight;
      }
  }

  // How far the radiances of two pixels lie apart beyond what chance makes of equal ones, 1 at the bound, at
  // least 0; less where either is not known.
  float distance(int x, int y, int u, int v) const {
    if (u < 0 || v < 0 || u >= m_size.x || v >= m_size.y)
      return -1.0f;
    const std::size_t p = at(x, y), q = at(u, v);
    if (!m_radiances.areKnown(p) || !m_radiances.areKnown(q))
      return -1.0f;
    const glm::vec3 apart = m_radiances.mean[p] - m_radiances.mean[q];
    const glm::vec3 chance = m_variance[p] + glm::min(m_variance[p], m_variance[q]);
    const glm::vec3 most = glm::vec3(1e-10f) + errorsApart * errorsApart * (m_variance[p] + m_variance[q]);
    const glm::vec3 share = (apart * apart - chance) / most;
    return std::max((share.r + share.g + share.b) / 3.0f, 0.0f);
  }

  float weightOf(int x, int y, std::size_t q, float reach) const {
    float sum = 0.0f, count = 0.0f;
    for (int v = std::max(y - patchRadius, m_top); v < std::min(y + patchRadius + 1, m_bottom); ++v)
      for (int u = std::max(x - patchRadius, 0); u < std::min(x + patchRadius + 1, m_size.x); ++u)
        if (const float d = m_distance[here(u, v)]; d >= 0.0f) {
          sum += d;
          count += 1.0f;
        }
    const std::size_t p = at(x, y);
    const glm::vec3 albedo = (m_guides.albedo[p] - m_guides.albedo[q]) / albedosApart;
    const glm::vec3 normal = (m_guides.normal[p] - m_guides.normal[q]) / normalsApart;
    const float depth = (m_guides.depth[p] - m_guides.depth[q]) / reach;
    const float guided = std::max({glm::dot(albedo, albedo), glm::dot(normal, normal), depth * depth});
    return std::exp(-sum / count - guided);
  }

  const Radiances& m_radiances;
  const std::vector<glm::vec3>& m_variance;
  const PathGuides& m_guides;
  glm::ivec2 m_size;
  int m_first, m_end;  // rows
  int m_top, m_bottom; // and those of patches
  std::vector<float> m_distance;
  std::vector<glm::vec3> m_sum;
  std::vector<float> m_weight;
};

// Filtered means of some radiances.
std::vector<glm::vec3> filteredMeans(const Radiances& radiances, const PathGuides& guides,
                                     const glm::ivec2& size, const Effort& effort) {
  const std::vector<glm::vec3> variance = smoothed(radiances, size);
  std::vector<glm::vec3> means(radiances.mean.size());
  const int pieces = (size.y + rowsAtOnce - 1) / rowsAtOnce;
  std::atomic<int> done = 0;
  forEach(
      pieces, effort.threads,
      [&](int piece) {
        const int first = piece * rowsAtOnce;
        RowFilter(radiances, variance, guides, size, first, std::min(first + rowsAtOnce, size.y)).run(means);
        ++done;
      },
      [&] { // asked on the thread that may tell
        if (effort.report)
          effort.report(double(done) / pieces);
        return effort.isCancelled && effort.isCancelled();
      });
  return means;
}

/// Squares of errors, each in levels.
struct Squares {
  double sum = 0.0;
  double count = 0.0;
  bool anyJudged = false;
};

// Judges filtered means by radiances that they know nothing of: their squared differences, less what chance
// makes of the latter.
void judge(const PathPicture& picture, const std::vector<glm::vec3>& means, const Radiances& others,
           const Shading& shading, Squares& squares) {
  for (std::size_t n = 0; n < means.size(); ++n) {
    if (!picture.pixels()[n].isCovered())
      continue;
    const double alpha = 255.0 * picture.pixels()[n].alpha;
    squares.count += 3.0;
    if (!others.areKnown(n)) { // as PathPicture's figures count them
      squares.sum += 3.0 * alpha * alpha;
      continue;
    }
    const glm::dvec3 mean(means[n]);
    // How the display colour follows the radiance there.
    const glm::dvec3 step = glm::max(glm::dvec3(0.01) * mean, glm::dvec3(1e-6));
    const glm::dvec3 slope =
        (displayed(mean + step, shading) - displayed(mean - step, shading)) / (2.0 * step);
    const glm::dvec3 apart = glm::dvec3(others.mean[n]) - mean;
    const glm::dvec3 error = slope * slope * (apart * apart - glm::dvec3(others.variance[n]));
    squares.sum += alpha * alpha * (error.r + error.g + error.b);
    squares.anyJudged = true;
  }
}

// The whole picture filtered, and what that changed.
FilteredPaths filteredWhole(const PathPicture& picture, const PathGuides& guides, const Shading& shading,
                            const Effort& effort) {
  const glm::ivec2& size = picture.size();
  const Radiances all = radiancesOf(picture, Paths::all);
  const std::vector<glm::vec3> means = filteredMeans(all, guides, size, effort);
  FilteredPaths result{picture.displayedTile({{0, 0}, size}, shading, effort.threads), {}, {}};
  double squares = 0.0, count = 0.0;
  for (std::size_t n = 0; n < means.size(); ++n) {
    if (!picture.pixels()[n].isCovered())
      continue;
    count += 3.0;
    if (!all.areKnown(n))
      continue;
    glm::vec4& pixel = result.image.pixels[n];
    const glm::vec3 color = double(pixel.a) * displayed(glm::dvec3(means[n]), shading);
    const glm::dvec3 change = 255.0 * glm::dvec3(color - glm::vec3(pixel));
    squares += glm::dot(change, change);
    for (int channel = 0; channel < 3; ++channel)
      result.figures.largestChange = std::max(result.figures.largestChange, std::abs(change[channel]));
    pixel = glm::vec4(color, pixel.a);
  }
  if (count > 0.0)
    result.figures.rmsChange = std::sqrt(squares / count);
  return result;
}

} // namespace

FilteredPaths filtered(const PathPicture& picture, const PathGuides& guides, const Shading& shading,
                       const Effort& effort) {
  const glm::ivec2& size = picture.size();
  FilteredPaths result = filteredWhole(picture, guides, shading, partOf(effort, 0.0, 1.0 / 3.0));
  const Radiances half = radiancesOf(picture, Paths::half), other = radiancesOf(picture, Paths::otherHalf);
  Squares squares;
  judge(picture, filteredMeans(half, guides, size, partOf(effort, 1.0 / 3.0, 2.0 / 3.0)), other, shading,
        squares);
  judge(picture, filteredMeans(other, guides, size, partOf(effort, 2.0 / 3.0, 1.0)), half, shading, squares);
  if (squares.anyJudged && squares.sum > 0.0)
    result.rmsLevels = std::sqrt(squares.sum / squares.count);
  return result;
}

} // namespace limn::cpu
