// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/ModulusSearch.h"

#include "scene/light/Gradient.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <type_traits>

namespace limn {
namespace {

// Floats that are not negative order as their bits do.
constexpr std::uint32_t bitsOfInfinity = 0x7f800000;

// By how much less than a square could be its estimate, which a dozen roundings to float part from it.
constexpr double estimateError = 1e-5;

// Moduli, as bits of floats, among which an element is looked for. They are counted in classes of 2^shift.
struct Window {
  std::uint32_t mostClasses;
  std::uint32_t first = 0;
  std::uint32_t last = bitsOfInfinity;

  int shift() const {
    int bits = 0;
    while ((last - first) >> bits >= mostClasses)
      ++bits;
    return bits;
  }

  std::size_t classes() const { return ((last - first) >> shift()) + std::size_t{1}; }
};

// A square less than which no estimate of a modulus at or above `modulus` is. Squares of very small numbers
// are none in float: there none is sure.
float surelyBelow(double modulus) {
  return modulus > 1e-12 ? static_cast<float>(modulus * modulus * (1.0 - estimateError)) : -1.0f;
}

float asFloat(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}

// What a pass finds; moduli in units of `modulusUnit`.
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
  // Without a window only the largest is looked for. It is `largest` at least.
  Pass(const Stencil<T>& stencil, const Window* window, double largest, Classes& classes)
      : m_stencil(stencil), m_eligible(stencil.volume), m_window(window), m_classes(classes) {
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
    for (int x = 0; x < m_stencil.dims.x; x += EligibleVoxels::run) {
      const int count = std::min(EligibleVoxels::run, m_stencil.dims.x - x);
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
  const Window* m_window;
  Classes& m_classes;
  int m_shift = 0;
  // Squares: from which on a modulus could be in the window, behind it, or the largest.
  float m_first = std::numeric_limits<float>::infinity();
  float m_behind = std::numeric_limits<float>::infinity();
  float m_largest;
  Moduli m_found;
};

template <class T>
Moduli passOver(const Stencil<T>& stencil, const Window* window, double largest, Classes& classes,
                const Effort& effort) {
  const RowPieces rows(stencil.dims);
  Moduli all;
  std::mutex mutex;
  shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
    Pass<T> pass(stencil, window, largest, classes);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&pass](int j, int k) { pass.row(j, k); });
    const std::lock_guard lock(mutex);
    all.largest = std::max(all.largest, pass.found().largest);
    all.eligible += pass.found().eligible;
    all.above += pass.found().above;
    all.zeros += pass.found().zeros;
  });
  if (window && window->first == 0)
    classes.front() += all.zeros;
  return all;
}

// Moduli of some voxels, each from another part of the volume.
template <class T>
std::vector<float> sampleOf(const Stencil<T>& stencil, const Effort& effort) {
  constexpr std::size_t most = 1 << 17;
  constexpr std::size_t perPiece = 1 << 12;
  const std::size_t voxels = stencil.stored.size();
  if (voxels < 4 * most)
    return {};
  const std::size_t part = voxels / most;
  const EligibleVoxels eligible(stencil.volume);
  std::vector<float> sample(most, -1.0f);
  const glm::ivec3 dims = stencil.dims;
  forEachPiece(most / perPiece, {effort.threads, effort.isCancelled, {}}, [&](int piece) {
    std::uint32_t random = 2654435761u * static_cast<std::uint32_t>(piece + 1);
    for (std::size_t n = piece * perPiece; n < (piece + 1) * perPiece; ++n) {
      random = 1664525u * random + 1013904223u;
      const std::size_t at = n * part + (random >> 8) % part;
      const int i = static_cast<int>(at % dims.x);
      const int j = static_cast<int>(at / dims.x % dims.y);
      const int k = static_cast<int>(at / dims.x / dims.y);
      if (eligible.has(i, j, k))
        sample[n] = static_cast<float>(stencil.modulus(i, j, k));
    }
  });
  std::erase(sample, -1.0f);
  return sample;
}

// Where the percentile most likely lies.
Window likelyWindow(std::vector<float> sample, double percent, std::size_t voxels) {
  Window window{static_cast<std::uint32_t>(std::clamp<std::size_t>(voxels, 1 << 10, 1 << 20))};
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
bool narrow(Window& window, const Moduli& found, const Classes& classes, std::uint64_t rank) {
  std::uint64_t inside = 0;
  for (const auto& count : classes)
    inside += count;
  const std::uint64_t below = found.eligible - found.above - inside;
  if (rank <= below) {
    window = {window.mostClasses, 0, window.first - 1};
    return false;
  }
  rank -= below;
  if (rank > inside) {
    window = {window.mostClasses, window.last + 1, bitsOfInfinity};
    return false;
  }
  std::uint32_t bin = 0;
  while (rank > classes[bin])
    rank -= classes[bin++];
  const int shift = window.shift();
  window.first += bin << shift;
  window.last = std::min(window.last, window.first + ((1u << shift) - 1));
  return shift == 0;
}

template <class T>
FoundModuli found(const Stencil<T>& stencil, std::optional<double> percent, const Effort& effort) {
  const std::vector<float> sample = sampleOf(stencil, effort);
  const double sampled = sample.empty() ? 0.0 : *std::max_element(sample.begin(), sample.end());
  // Less than the modulus that was rounded to this float.
  const double known = sampled > 1e-30 ? sampled * (1.0 - 1e-6) : 0.0;
  if (!percent) {
    Classes none;
    return {passOver(stencil, nullptr, known, none, effort).largest, 0.0};
  }
  Window window = likelyWindow(sample, *percent, stencil.stored.size());
  for (;;) {
    Classes classes(window.classes());
    const Moduli moduli = passOver(stencil, &window, known, classes, effort);
    if (moduli.eligible == 0)
      return {};
    const double wanted = std::ceil(*percent / 100.0 * static_cast<double>(moduli.eligible));
    const auto rank =
        static_cast<std::uint64_t>(std::clamp(wanted, 1.0, static_cast<double>(moduli.eligible)));
    if (narrow(window, moduli, classes, rank))
      return {moduli.largest, asFloat(window.first)};
  }
}

} // namespace

FoundModuli findModuli(const Volume& volume, std::optional<double> percent, const Effort& effort) {
  const bool wantsLargest = percent && *percent >= 100.0;
  FoundModuli result = visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    return found(Stencil<T>{volume, stored}, wantsLargest ? std::nullopt : percent, effort);
  });
  if (wantsLargest)
    result.percentile = result.largest;
  result.largest *= modulusUnit(volume);
  result.percentile *= modulusUnit(volume);
  return result;
}

} // namespace limn
