// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/ModulusSearch.h"

#include "scene/light/Gradient.h"
#include "scene/volume/RowPieces.h"
#include "scene/volume/VolumePart.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <type_traits>

namespace limn {
namespace {

// By how much less than a square could be its estimate, which a dozen roundings to float part from it.
constexpr double estimateError = 1e-5;

// A square less than which no estimate of a modulus at or above `modulus` is. Squares of very small numbers
// are none in float: there none is sure.
float surelyBelow(double modulus) {
  return modulus > 1e-12 ? static_cast<float>(modulus * modulus * (1.0 - estimateError)) : -1.0f;
}

float asFloat(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}

// What one thread finds; moduli in units of `modulusUnit`.
struct Moduli {
  double largest = 0.0;
  std::uint64_t eligible = 0;
  std::uint64_t above = 0; // behind the window
  std::uint64_t zeros = 0; // in the window; most of some volumes
};

using Classes = std::vector<std::atomic<std::uint64_t>>;

// Estimates of squared moduli along a row of voxels, in units of `modulusUnit`.
template <class T>
class RowEstimate {
public:
  RowEstimate(const Stencil<T>& stencil, int j, int k)
      : m_row(&stencil.stored[voxelOffset(stencil.dims, 0, j, k)]) {
    m_last = stencil.dims.x - 1;
    const auto perDifference = [&](int axis, int distance) {
      const double factor = stencil.volume.rescale().slope * stencil.perUnit /
                            (distance * stencil.volume.grid().spacingMm[axis]);
      m_isSafe = m_isSafe && std::abs(factor) > 1e-25 && std::abs(factor) < 1e25;
      return static_cast<float>(factor);
    };
    m_perX = perDifference(0, 2);
    const auto around = [&](int axis, int index, const T*& lower, const T*& upper, float& per) {
      const bool hasLower = index > 0;
      const bool hasUpper = index + 1 < stencil.dims[axis];
      lower = hasLower ? m_row - stencil.stride[axis] : m_row;
      upper = hasUpper ? m_row + stencil.stride[axis] : m_row;
      per = perDifference(axis, std::max(1, int(hasLower) + int(hasUpper)));
    };
    around(1, j, m_lowerY, m_upperY, m_perY);
    around(2, k, m_lowerZ, m_upperZ, m_perZ);
  }

  // Whether estimates are within `estimateError`; of voxels with unheard-of units they are not.
  bool isSafe() const { return m_isSafe; }

  // Writes the squares from voxel `from` on.
  void squares(int from, int count, float* to) const {
    // Copies, which what is written cannot be: the loops become vectors.
    const float perX = m_perX, perY = m_perY, perZ = m_perZ;
    const T *lowerY = m_lowerY + from, *upperY = m_upperY + from;
    const T *lowerZ = m_lowerZ + from, *upperZ = m_upperZ + from;
    const T* here = m_row + from;
    for (int i = 0; i < count; ++i) {
      const float y = perY * difference(upperY[i], lowerY[i]);
      const float z = perZ * difference(upperZ[i], lowerZ[i]);
      to[i] = y * y + z * z;
    }
    const int end = std::min(count, m_last - from);
    for (int i = from > 0 ? 0 : 1; i < end; ++i)
      addAlongX(perX * difference(here[i + 1], here[i - 1]), to[i]);
    if (m_last > 0 && from == 0)
      addAlongX(2.0f * m_perX * difference(m_row[1], m_row[0]), to[0]);
    if (m_last > 0 && from + count > m_last)
      addAlongX(2.0f * m_perX * difference(m_row[m_last], m_row[m_last - 1]), to[m_last - from]);
  }

private:
  static void addAlongX(float x, float& square) { square += x * x; }

  static float difference(T upper, T lower) {
    if constexpr (sizeof(T) <= 2)
      return static_cast<float>(int{upper} - int{lower});
    else if constexpr (std::is_same_v<T, float>)
      return upper - lower;
    else
      return static_cast<float>(static_cast<double>(upper) - static_cast<double>(lower));
  }

  const T* m_row;
  const T *m_lowerY, *m_upperY, *m_lowerZ, *m_upperZ;
  float m_perX, m_perY, m_perZ;
  int m_last;
  bool m_isSafe = true;
};

// One thread's share of a pass: looks at every modulus that could be the largest or in the window.
template <class T>
class Pass {
public:
  // Without a window only the largest is looked for. It is `largest` at least. Columns are half open.
  Pass(const Stencil<T>& stencil, int first, int end, const ModulusWindow* window, double largest,
       Classes& classes)
      : m_stencil(stencil), m_eligible(stencil.volume), m_firstColumn(first), m_endColumn(end),
        m_window(window), m_classes(classes) {
    m_found.largest = largest;
    if (window) {
      m_shift = window->shift();
      const double last = asFloat(window->last);
      m_first = surelyBelow(asFloat(window->first));
      m_behind = static_cast<float>(last * last * (1.0 + estimateError));
    }
    m_largest = surelyBelow(largest);
  }

  void row(int j, int k) {
    const RowEstimate<T> estimate(m_stencil, j, k);
    const bool isSafe = estimate.isSafe();
    float squares[EligibleVoxels::run];
    for (int x = m_firstColumn; x < m_endColumn; x += EligibleVoxels::run) {
      const int count = std::min(EligibleVoxels::run, m_endColumn - x);
      const std::uint64_t eligible = m_eligible.from(x, j, k, count);
      m_found.eligible += static_cast<std::uint64_t>(std::popcount(eligible));
      estimate.squares(x, count, squares);
      // Written so that what is no number counts.
      const float least = isSafe ? std::min(m_first, m_largest) : -1.0f;
      int candidates = 0;
      for (int i = 0; i < count; ++i)
        candidates += squares[i] < least ? 0 : 1;
      for (int i = 0; candidates > 0 && i < count; ++i)
        if (!(squares[i] < least)) {
          --candidates;
          if ((eligible >> i & 1) != 0)
            look(x + i, j, k, isSafe ? squares[i] : 0.0f);
        }
    }
  }

  const Moduli& found() const { return m_found; }

private:
  void look(int i, int j, int k, float square) {
    if (square > m_behind && square < m_largest) {
      ++m_found.above;
      return;
    }
    const double modulus = m_stencil.modulus(i, j, k);
    if (modulus > m_found.largest) {
      m_found.largest = modulus;
      m_largest = surelyBelow(modulus);
    }
    if (!m_window)
      return;
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(modulus));
    if (bits > m_window->last)
      ++m_found.above;
    else if (bits == 0 && m_window->first == 0)
      ++m_found.zeros;
    else if (bits >= m_window->first)
      m_classes[(bits - m_window->first) >> m_shift].fetch_add(1, std::memory_order_relaxed);
  }

  const Stencil<T>& m_stencil;
  EligibleVoxels m_eligible;
  int m_firstColumn, m_endColumn;
  const ModulusWindow* m_window;
  Classes& m_classes;
  int m_shift = 0;
  // Squares: from which on a modulus could be in the window, behind it, or the largest.
  float m_first = std::numeric_limits<float>::infinity();
  float m_behind = std::numeric_limits<float>::infinity();
  float m_largest;
  Moduli m_found;
};

template <class T>
ModulusCounts counted(const Stencil<T>& stencil, const VoxelBox& of, const ModulusWindow* window,
                      double known, const Effort& effort) {
  const RowPieces rows(of.upper - of.lower);
  ModulusCounts all;
  all.largest = known;
  Classes classes(window ? window->classes() : 0);
  std::mutex mutex;
  shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
    Pass<T> pass(stencil, of.lower.x, of.upper.x, window, known, classes);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&](int j, int k) { pass.row(of.lower.y + j, of.lower.z + k); });
    const Moduli& found = pass.found();
    const std::lock_guard lock(mutex);
    all.largest = std::max(all.largest, found.largest);
    all.eligible += found.eligible;
    all.above += found.above;
    if (window && window->first == 0)
      classes.front() += found.zeros;
  });
  all.classes.assign(classes.begin(), classes.end());
  return all;
}

// Of so many voxels a part takes its share of the sample, in pieces of work.
constexpr std::size_t mostSampled = 1 << 17;
constexpr std::size_t sampledPerPiece = 1 << 12;

template <class T>
std::vector<float> sampleOf(const Stencil<T>& stencil, const VoxelBox& of, int pieces, const Effort& effort) {
  const glm::ivec3 size = of.upper - of.lower;
  const std::size_t most = static_cast<std::size_t>(pieces) * sampledPerPiece;
  const std::size_t part = static_cast<std::size_t>(size.x) * size.y * size.z / most;
  if (part == 0)
    return {};
  const EligibleVoxels eligible(stencil.volume);
  std::vector<float> sample(most, -1.0f);
  forEachPiece(pieces, {effort.threads, effort.isCancelled, {}}, [&](int piece) {
    std::uint32_t random = 2654435761u * static_cast<std::uint32_t>(piece + 1);
    for (std::size_t n = piece * sampledPerPiece; n < (piece + 1) * sampledPerPiece; ++n) {
      random = 1664525u * random + 1013904223u;
      const std::size_t at = n * part + (random >> 8) % part;
      const int i = of.lower.x + static_cast<int>(at % size.x);
      const int j = of.lower.y + static_cast<int>(at / size.x % size.y);
      const int k = of.lower.z + static_cast<int>(at / size.x / size.y);
      if (eligible.has(i, j, k))
        sample[n] = static_cast<float>(stencil.modulus(i, j, k));
    }
  });
  std::erase(sample, -1.0f);
  return sample;
}

// Where the percentile most likely lies.
ModulusWindow likelyWindow(std::vector<float> sample, double percent, std::size_t voxels) {
  ModulusWindow window{static_cast<std::uint32_t>(std::clamp<std::size_t>(voxels, 1 << 10, 1 << 20))};
  if (sample.size() < 1024)
    return window;
  const auto bitsAt = [&sample](double rank) {
    const auto at = sample.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(sample.begin(), at, sample.end());
    return std::bit_cast<std::uint32_t>(*at);
  };
  const auto count = static_cast<double>(sample.size());
  const double share = percent / 100.0;
  const double margin = 4.0 * std::sqrt(share * (1.0 - share) * count) + 2.0;
  const double first = std::floor(share * count - margin);
  const double last = std::ceil(share * count + margin);
  if (first >= 0.0)
    window.first = bitsAt(first);
  if (last < count)
    window.last = bitsAt(last);
  return window;
}

// Narrows the window to the class that holds the element of a rank (from 1) among `eligible`, or moves it to
// where it must be. True once it holds one number.
bool narrow(ModulusWindow& window, const ModulusCounts& found, std::uint64_t rank) {
  const std::uint64_t inside = std::accumulate(found.classes.begin(), found.classes.end(), std::uint64_t{0});
  const std::uint64_t below = found.eligible - found.above - inside;
  if (rank <= below) {
    window = {window.mostClasses, 0, window.first - 1};
    return false;
  }
  rank -= below;
  if (rank > inside) {
    window = {window.mostClasses, window.last + 1, ModulusWindow::bitsOfInfinity};
    return false;
  }
  std::uint32_t bin = 0;
  while (rank > found.classes[bin])
    rank -= found.classes[bin++];
  const int shift = window.shift();
  window.first += bin << shift;
  window.last = std::min(window.last, window.first + ((1u << shift) - 1));
  return shift == 0;
}

// In units of `modulusUnit`.
FoundModuli found(const ModulusLooks& looks, std::size_t voxels, std::optional<double> percent) {
  const std::vector<float> sample = voxels < 4 * mostSampled ? std::vector<float>() : looks.sample().moduli;
  const double sampled = sample.empty() ? 0.0 : *std::max_element(sample.begin(), sample.end());
  // Less than the modulus that was rounded to this float.
  const double known = sampled > 1e-30 ? sampled * (1.0 - 1e-6) : 0.0;
  if (!percent)
    return {looks.count(std::nullopt, known).largest, 0.0};
  ModulusWindow window = likelyWindow(sample, *percent, voxels);
  for (;;) {
    const ModulusCounts counts = looks.count(window, known);
    if (counts.eligible == 0)
      return {};
    const double wanted = std::ceil(*percent / 100.0 * static_cast<double>(counts.eligible));
    const auto rank =
        static_cast<std::uint64_t>(std::clamp(wanted, 1.0, static_cast<double>(counts.eligible)));
    if (narrow(window, counts, rank))
      return {counts.largest, asFloat(window.first)};
  }
}

// Calls `function(stencil, box)` with what is held and the voxels `of` in it.
template <class Function>
auto withStencil(const Volume& volume, const VoxelBox& of, const Function& function) {
  const auto look = [&](const Volume& held, const VoxelBox& box) {
    return visitVoxels(held, [&]<class T>(const StoredVoxels<T>& stored) {
      return function(Stencil<T>{held, stored}, box);
    });
  };
  return volume.part() ? look(volume.held(), movedInto(of, volume.part()->box)) : look(volume, of);
}

} // namespace

int ModulusWindow::shift() const {
  int bits = 0;
  while ((last - first) >> bits >= mostClasses)
    ++bits;
  return bits;
}

ModulusCounts joined(const ModulusCounts& a, const ModulusCounts& b) {
  ModulusCounts both{std::max(a.largest, b.largest), a.eligible + b.eligible, a.above + b.above, a.classes};
  std::transform(b.classes.begin(), b.classes.end(), both.classes.begin(), both.classes.begin(),
                 std::plus<>());
  return both;
}

ModulusSample joined(const ModulusSample& a, const ModulusSample& b) {
  ModulusSample both = a;
  both.moduli.insert(both.moduli.end(), b.moduli.begin(), b.moduli.end());
  return both;
}

ModulusSample sampledModuli(const Volume& volume, const VoxelBox& of, const Effort& effort) {
  if (isEmpty(of))
    return {};
  const glm::dvec3 share = glm::dvec3(of.upper - of.lower) / glm::dvec3(volume.grid().dims);
  constexpr double most = static_cast<double>(mostSampled) / sampledPerPiece;
  const double pieces = share.x * share.y * share.z * most;
  return withStencil(volume, of, [&](const auto& stencil, const VoxelBox& box) {
    return ModulusSample{sampleOf(stencil, box, std::max(1, static_cast<int>(pieces)), effort)};
  });
}

ModulusCounts countedModuli(const Volume& volume, const VoxelBox& of,
                            const std::optional<ModulusWindow>& window, double known, const Effort& effort) {
  if (isEmpty(of))
    return {known, 0, 0, std::vector<std::uint64_t>(window ? window->classes() : 0)};
  return withStencil(volume, of, [&](const auto& stencil, const VoxelBox& box) {
    return counted(stencil, box, window ? &*window : nullptr, known, effort);
  });
}

FoundModuli findModuliBy(const ModulusLooks& looks, const Volume& volume, std::optional<double> percent) {
  const bool wantsLargest = percent && *percent >= 100.0;
  FoundModuli result = found(looks, volume.voxelCount(), wantsLargest ? std::nullopt : percent);
  if (wantsLargest)
    result.percentile = result.largest;
  result.largest *= modulusUnit(volume);
  result.percentile *= modulusUnit(volume);
  return result;
}

FoundModuli findModuli(const Volume& volume, std::optional<double> percent, const Effort& effort) {
  const VoxelBox all = allVoxels(volume.grid());
  return findModuliBy({[&] { return sampledModuli(volume, all, effort); },
                       [&](const std::optional<ModulusWindow>& window, double known) {
                         return countedModuli(volume, all, window, known, effort);
                       }},
                      volume, percent);
}

} // namespace limn
