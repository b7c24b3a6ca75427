// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/RaySamples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace limn {

/// What a trilinear field is along a chord within one of its cells: a cubic on 0..1.
class ChordCubic {
public:
  /// Through its values at 0, ⅓, ⅔ and 1.
  explicit ChordCubic(const std::array<double, 4>& f)
      // From values to Bernstein coefficients, whose hull holds the cubic.
      : m_b{f[0], f[0] + (18.0 * (f[1] - f[0]) - 9.0 * (f[2] - f[0]) + 2.0 * (f[3] - f[0])) / 6.0,
            f[3] + (2.0 * (f[0] - f[3]) - 9.0 * (f[1] - f[3]) + 18.0 * (f[2] - f[3])) / 6.0, f[3]} {
    const auto [low, high] = std::minmax_element(m_b.begin(), m_b.end());
    m_low = *low;
    m_high = *high;
  }

  double at(double s) const {
    const double r = 1.0 - s;
    const double rest = 3.0 * r * r * s * (m_b[1] - m_b[0]) + 3.0 * r * s * s * (m_b[2] - m_b[0]) +
                        s * s * s * (m_b[3] - m_b[0]);
    return m_b[0] + rest;
  }

  /// Bounds of the cubic on 0..1, not always taken.
  double low() const { return m_low; }
  double high() const { return m_high; }

  /// Of the part from `from` to `to`, exactly: Simpson's rule integrates cubics.
  double mean(double from, double to) const {
    return (at(from) + 4.0 * at(0.5 * (from + to)) + at(to)) / 6.0;
  }

  /// Where it turns between 0 and 1, in order. Returns how many of `turns` are set.
  int findTurns(double (&turns)[2]) const {
    const double d0 = m_b[1] - m_b[0], d1 = m_b[2] - m_b[1], d2 = m_b[3] - m_b[2];
    const double a = d0 - 2.0 * d1 + d2, b = d1 - d0;
    const double root = b * b - a * d0;
    if (root <= 0.0)
      return 0;
    int count = 0;
    // Of both quotients the one that cancels nothing.
    const double q = -(b + std::copysign(std::sqrt(root), b));
    for (const double at : {a != 0.0 ? q / a : 2.0, q != 0.0 ? d0 / q : 2.0})
      if (at > 0.0 && at < 1.0)
        turns[count++] = at;
    if (count == 2 && turns[1] < turns[0])
      std::swap(turns[0], turns[1]);
    return count;
  }

  /// Adds the places where it takes a value, in order: each between two where it turns, by halving.
  void addCrossings(double value, std::vector<double>& places) const {
    if (value < m_low || value > m_high || !(m_low < m_high))
      return;
    double ends[2] = {};
    const int turns = findTurns(ends);
    for (int i = 0; i <= turns; ++i) {
      double from = i == 0 ? 0.0 : ends[i - 1], to = i < turns ? ends[i] : 1.0;
      const bool isBelow = at(from) < value;
      if ((at(to) < value) == isBelow)
        continue;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (from + to);
        ((at(middle) < value) == isBelow ? from : to) = middle;
      }
      places.push_back(0.5 * (from + to));
    }
  }

private:
  std::array<double, 4> m_b;
  double m_low = 0.0, m_high = 0.0;
};

/// The chords of a ray between voxel centres, on each of which its field is one cubic and light is smooth.
/// Places are in mm behind the span's begin.
template <class T>
class CellChords {
public:
  CellChords(const PictureTerms& terms, const RaySamples<T>& samples)
      : m_terms(terms), m_samples(samples),
        m_first(samples.ray().anchor + samples.span().begin * samples.ray().direction + terms.centre),
        m_end(samples.span().end - samples.span().begin) {
    findBreaks();
  }

  double end() const { return m_end; }

  /// Where the chord that begins at `entry` ends: at the next plane of voxel centres, or where light changes
  /// its definition.
  double exitFrom(double entry) const {
    double exit = m_end;
    for (int axis = 0; axis < 3; ++axis) {
      const double along = m_samples.ray().direction[axis];
      if (std::abs(along) * m_end < 1e-12)
        continue;
      const double p = m_first[axis] + entry * along;
      const double plane = along > 0.0 ? std::floor(p + onPlane) + 1.0 : std::ceil(p - onPlane) - 1.0;
      exit = std::min(exit, std::max((plane - m_first[axis]) / along, std::nextafter(entry, m_end)));
    }
    const auto next = std::upper_bound(m_breaks.begin(), m_breaks.end(), entry);
    return next == m_breaks.end() ? exit : std::min(exit, *next);
  }

  /// The scalars along a chord.
  ChordCubic scalars(double entry, double exit) const {
    return along(entry, exit, [this](double place) { return m_samples.scalarAt(place); });
  }

  /// What the kept region leaves along a chord.
  ChordCubic weights(double entry, double exit) const {
    return along(entry, exit, [this](double place) { return m_samples.weightAt(place); });
  }

private:
  template <class Field>
  ChordCubic along(double entry, double exit, const Field& field) const {
    std::array<double, 4> f;
    for (int i = 0; i < 4; ++i)
      f[i] = field((entry + i * (exit - entry) / 3.0) / m_samples.stepMm());
    return ChordCubic(f);
  }

  // One length behind a cut face, and where fog sets in.
  void findBreaks() {
    const auto add = [this](double at) {
      if (at > 0.0 && at < m_end)
        m_breaks.push_back(at);
    };
    for (int axis = 0; m_terms.isCut && axis < 3; ++axis) {
      const double inside = m_terms.smallestMm / m_terms.grid.spacingMm[axis];
      for (const double face : {m_terms.cut.lower[axis] + inside, m_terms.cut.upper[axis] - inside})
        if (m_samples.ray().direction[axis] != 0.0)
          add((face + m_terms.centre[axis] - m_first[axis]) / m_samples.ray().direction[axis]);
    }
    const double eye = m_samples.ray().eye - m_samples.span().begin;
    add(m_terms.scene.fog.startMm + eye);
    add(m_terms.scene.fog.endMm + eye);
    std::sort(m_breaks.begin(), m_breaks.end());
  }

  // So near behind a plane counts as on it, voxels.
  static constexpr double onPlane = 1e-9;

  const PictureTerms& m_terms;
  const RaySamples<T>& m_samples;
  glm::dvec3 m_first; // voxel index at the span's begin
  double m_end;
  std::vector<double> m_breaks;
};

} // namespace limn
