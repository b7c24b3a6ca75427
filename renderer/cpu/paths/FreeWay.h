// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/Medium.h"
#include "cpu/paths/PathRandom.h"
#include "cpu/paths/PathTerms.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace limn::cpu {

/// How far a way from a place in the box goes until it leaves it, lengths ≥ 0.
inline float lengthInBox(const PathTerms& terms, const glm::vec3& place, const glm::vec3& direction) {
  float length = std::numeric_limits<float>::max();
  for (int axis = 0; axis < 3; ++axis) {
    const float speed = direction[axis] * terms.perLength[axis];
    if (speed != 0.0f)
      length = std::min(length, ((speed > 0.0f ? terms.upper : terms.lower)[axis] - place[axis]) / speed);
  }
  return std::max(length, 0.0f);
}

/// Goes a straight way block by block and calls `piece(majorant, from, to)`, lengths from its beginning, for
/// each stretch in which something may be; it ends where that returns false. Rounding may look for a place on
/// the wrong side of a block's face: majorants hold a little beyond (BlockRanges).
template <class Piece>
void forEachStretch(const MajorantTerms& majorants, const glm::vec3& place, const glm::vec3& perLength,
                    float length, const Piece& piece) {
  const glm::ivec3 last = majorants.blocks - 1;
  glm::ivec3 block = glm::clamp(glm::ivec3(glm::floor(place / float(blockSize))), glm::ivec3(0), last);
  glm::vec3 next;
  // Where the way crosses the face behind `ahead` blocks more; beyond the outermost nothing but the box ends.
  const auto crossing = [&](int axis, int ahead) {
    const float speed = perLength[axis];
    if (speed == 0.0f)
      return std::numeric_limits<float>::max();
    const int face = speed > 0.0f ? block[axis] + 1 + ahead : block[axis] - ahead;
    if (face > last[axis] || face <= 0)
      return std::numeric_limits<float>::max();
    return (float(face * blockSize) - place[axis]) / speed;
  };
  for (int axis = 0; axis < 3; ++axis)
    next[axis] = crossing(axis, 0);
  float at = 0.0f;
  while (true) {
    const std::size_t offset =
        (static_cast<std::size_t>(block.z) * majorants.blocks.y + block.y) * majorants.blocks.x + block.x;
    const float majorant = majorants.ofBlocks[offset];

    // Leap over the cube of empty blocks around this one.
    if (const int distance = majorants.distances ? majorants.distances[offset] : 0; distance > 1) {
      int axis = 0;
      glm::vec3 ends;
      for (int a = 0; a < 3; ++a) {
        ends[a] = crossing(a, distance - 1);
        if (ends[a] < ends[axis])
          axis = a;
      }
      if (!(ends[axis] < length))
        return;
      at = std::max(at, ends[axis]);
      const glm::ivec3 before = block;
      const glm::ivec3 there(glm::floor((place + at * perLength) / float(blockSize)));
      block = glm::clamp(glm::clamp(there, before - (distance - 1), before + (distance - 1)), glm::ivec3(0),
                         last);
      block[axis] = before[axis] + (perLength[axis] > 0.0f ? distance : -distance);
      for (int a = 0; a < 3; ++a)
        next[a] = crossing(a, 0);
      continue;
    }

    const int axis = next.x <= next.y ? (next.x <= next.z ? 0 : 2) : (next.y <= next.z ? 1 : 2);
    const float end = std::min(next[axis], length);
    if (majorant > 0.0f && end > at && !piece(majorant, at, end))
      return;
    if (!(next[axis] < length))
      return;
    at = std::max(at, end);
    block[axis] += perLength[axis] > 0.0f ? 1 : -1;
    next[axis] = crossing(axis, 0);
  }
}

/// How far light flies before it meets something, and what comes through. Both are unbiased, whatever the
/// majorants are: Woodcock and others' delta tracking, and ratio tracking (Novák, Selle, Jarosz: Residual
/// ratio tracking, 2014).
template <class T>
class FreeWay {
public:
  FreeWay(const PathTerms& terms, const Medium<T>& medium) : m_terms(terms), m_medium(medium) {}

  /// Where the next collision lies; absent: the way of `length` meets nothing.
  std::optional<glm::vec3> collision(const glm::vec3& place, const glm::vec3& direction, float length,
                                     PathRandom& random) const {
    std::optional<glm::vec3> met;
    const glm::vec3 perLength = direction * m_terms.perLength;
    float left = depth(random);
    forEachStretch(m_terms.majorants, place, perLength, length, [&](float majorant, float at, float end) {
      while (true) {
        const float step = left / majorant;
        if (!(at + step < end)) {
          left -= (end - at) * majorant;
          left = std::max(left, 0.0f);
          return true;
        }
        at += step;
        const glm::vec3 there = place + at * perLength;
        if (random.next() * majorant < m_medium.extinctionAt(there)) {
          met = there;
          return false;
        }
        left = depth(random);
      }
    });
    return met;
  }

  /// Of light that comes along a way, how much comes through: its mean is exp(-τ).
  float transmittance(const glm::vec3& place, const glm::vec3& direction, PathRandom& random) const {
    const glm::vec3 perLength = direction * m_terms.perLength;
    float through = 1.0f;
    float left = depth(random);
    forEachStretch(m_terms.majorants, place, perLength, lengthInBox(m_terms, place, direction),
                   [&](float majorant, float at, float end) {
                     while (true) {
                       const float step = left / majorant;
                       if (!(at + step < end)) {
                         left = std::max(left - (end - at) * majorant, 0.0f);
                         return true;
                       }
                       at += step;
                       through *=
                           std::max(1.0f - m_medium.extinctionAt(place + at * perLength) / majorant, 0.0f);
                       // What hardly counts ends by chance, and counts for those that did.
                       if (through < little) {
                         if (!(random.next() * little < through)) {
                           through = 0.0f;
                           return false;
                         }
                         through = little;
                       }
                       left = depth(random);
                     }
                   });
    return through;
  }

private:
  static constexpr float little = 0.25f;

  // The depth that light passes before it meets something.
  static float depth(PathRandom& random) { return -std::log(1.0f - random.next()); } // of multiples of 2⁻²⁴

  const PathTerms& m_terms;
  const Medium<T>& m_medium;
};

} // namespace limn::cpu
