// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"
#include "scene/light/GradientScales.h"
#include "scene/light/GradientSmoothing.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <utility>

namespace limn {

/// The field whose gradient light and boundaries follow: that of the volume, or a smoothed one
/// (DEFINITION section 2), and the gradient scales of either. What was made is kept until another volume
/// takes its place, smoothed fields of the two σ asked for last: pictures side by side may take turns. Where
/// memory holds one alone that is smoothed anew at each turn, which takes time and changes no picture.
class GradientField {
public:
  /// `free` tells what memory could still be had, bytes, as freeMemory.
  explicit GradientField(std::function<std::optional<std::uint64_t>()> free = freeMemory)
      : m_free(std::move(free)) {}

  /// Goes on smoothing for some ten ms; the share that is done, 1 once nothing is missing. With a σ of 0, mm,
  /// nothing is asked for. Throws Cancelled, and then goes on from there; Error where memory does not hold a
  /// smoothed field.
  double more(const std::shared_ptr<const Volume>& volume, double sigmaMm, const Effort& effort = {});

  /// The same to its end.
  void update(const std::shared_ptr<const Volume>& volume, double sigmaMm, const Effort& effort = {}) {
    while (more(volume, sigmaMm, effort) < 1.0) {
    }
  }

  /// Null where none is asked for.
  std::shared_ptr<const Volume> smoothed() const {
    return m_isAskedFor ? m_smoothed.front().smoothing.smoothed() : std::shared_ptr<const Volume>();
  }

  /// Of the gradients of what was asked for last, whose smoothing is done: as limn::gradientScale of them,
  /// with the smoothed field; where nothing reads the ratio of moduli, a percentile is not measured for it.
  GradientScale scale(const Shading& shading, bool usesRatio, const Effort& effort = {});

  /// Of the volume's own gradients, as GradientScales::know.
  void know(const FoundModuli& found, std::optional<double> percent) { m_plain.know(found, percent); }

  /// What smoothed fields take in memory, bytes.
  std::size_t ownBytes() const;

private:
  struct Smoothed {
    Smoothing smoothing;
    GradientScales scales; ///< of what it made
  };

  void makeRoom();
  void dropLast();
  bool holdsOneMore() const;
  std::size_t bytesEach() const;

  std::function<std::optional<std::uint64_t>()> m_free;
  std::shared_ptr<const Volume> m_volume;
  GradientScales m_plain;
  std::deque<Smoothed> m_smoothed;                    ///< the one asked for last first
  std::vector<std::weak_ptr<const Volume>> m_dropped; ///< which others may still hold
  bool m_isAskedFor = false;                          ///< and done
};

/// The gradient that light and boundaries of a picture follow at a continuous index, along the grid's axes,
/// value/mm: of the field in its scale, which is an engine's, where that is of this grid; else the volume's
/// own.
glm::dvec3 followedGradientAt(const Volume& volume, const GradientScale& scale, const glm::dvec3& index);

} // namespace limn
