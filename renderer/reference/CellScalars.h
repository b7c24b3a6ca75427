// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/CellChords.h"
#include "scene/Scene.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace limn {

/// What projections need that look at scalars alone, found cell by cell and so exactly: the largest and the
/// smallest are those of cubics, their mean is an integral of cubics, a surface is where one first takes the
/// isovalue; all of them where the kept region leaves at least half.
template <class T>
class CellScalars {
public:
  CellScalars(const PictureTerms& terms, const RaySamples<T>& samples)
      : m_terms(terms), m_chords(terms, samples) {}

  /// The scalar that a MIP, a MinIP or an average classifies; absent where nothing is kept.
  std::optional<double> scalar(Projection projection) {
    std::optional<double> extreme;
    double sum = 0.0, length = 0.0;
    eachKept([&](double entry, double exit, const ChordCubic& cubic, double from, double to) {
      if (projection == Projection::average) {
        const double part = (to - from) * (exit - entry);
        sum += part * cubic.mean(from, to);
        length += part;
        return false;
      }
      const bool isLargest = projection == Projection::mip;
      const auto look = [&](double s) {
        const double scalar = cubic.at(s);
        extreme = !extreme ? scalar : isLargest ? std::max(*extreme, scalar) : std::min(*extreme, scalar);
      };
      look(from);
      look(to);
      double turns[2];
      const int count = cubic.findTurns(turns);
      for (int i = 0; i < count; ++i)
        if (turns[i] > from && turns[i] < to)
          look(turns[i]);
      return false;
    });
    if (projection != Projection::average)
      return extreme;
    return length > 0.0 ? std::optional(sum / length) : std::nullopt;
  }

  /// Where the field first reaches a value in what is kept, mm behind the span's begin; absent where it stays
  /// below.
  std::optional<double> firstAt(double value) {
    std::optional<double> hit;
    eachKept([&](double entry, double exit, const ChordCubic& cubic, double from, double to) {
      m_places.clear();
      if (cubic.at(from) >= value)
        m_places.push_back(from);
      cubic.addCrossings(value, m_places);
      for (const double place : m_places)
        if (place >= from && place <= to) {
          hit = entry + place * (exit - entry);
          return true;
        }
      return false;
    });
    return hit;
  }

private:
  // Tells of the kept parts of chords front to back, until one is enough: the chord, its scalars, and from
  // where to where on 0..1 it is kept.
  template <class Tell>
  void eachKept(const Tell& isEnough) {
    for (double entry = 0.0; entry < m_chords.end();) {
      const double exit = m_chords.exitFrom(entry);
      const ChordCubic cubic = m_chords.scalars(entry, exit);
      m_ends.assign({0.0, 1.0});
      if (m_terms.hasRegion) {
        const ChordCubic weights = m_chords.weights(entry, exit);
        weights.addCrossings(keptWeight, m_ends);
        std::sort(m_ends.begin(), m_ends.end());
        for (std::size_t i = 0; i + 1 < m_ends.size(); ++i)
          if (weights.at(0.5 * (m_ends[i] + m_ends[i + 1])) >= keptWeight &&
              isEnough(entry, exit, cubic, m_ends[i], m_ends[i + 1]))
            return;
      } else if (isEnough(entry, exit, cubic, 0.0, 1.0)) {
        return;
      }
      entry = exit;
    }
  }

  const PictureTerms& m_terms;
  CellChords<T> m_chords;
  std::vector<double> m_ends, m_places;
};

} // namespace limn
