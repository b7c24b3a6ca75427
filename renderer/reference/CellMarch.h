// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/CellChords.h"
#include "scene/steps/CellRule.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn {

/// What lies at a place of a ray: extinction over the unit distance, and lit colour.
struct CellNode {
  double extinction = 0.0;
  glm::dvec3 color{0.0};
};

/// What a part of a ray absorbs and the light that it adds.
struct CellLight {
  double alpha = 0.0;
  glm::dvec3 color{0.0};
};

/// One panel between three nodes, `depth` unit distances long. Extinction κ and colour c are quadratics; with
/// T = exp(-τ), τ in closed form, ∫Tκc ds = αc(0) + ∫(T - T(1))c' ds: exact for one colour however opaque.
inline CellLight cellPanel(const CellNode& a, const CellNode& b, const CellNode& c, double depth) {
  CellLight light;
  light.alpha = oneMinusExpNeg(depth * (a.extinction + 4.0 * b.extinction + c.extinction) / 6.0);
  const glm::dvec3 begin = 4.0 * (b.color - a.color) - (c.color - a.color);
  const glm::dvec3 gain = 4.0 * (c.color - a.color) - 8.0 * (b.color - a.color);
  light.color = light.alpha * a.color;
  for (const auto& [place, weight] : {std::pair{0.5 - std::sqrt(0.15), 5.0 / 18.0}, std::pair{0.5, 4.0 / 9.0},
                                      std::pair{0.5 + std::sqrt(0.15), 5.0 / 18.0}}) {
    const double square = place * place, cube = square * place;
    const double before = (place - 1.5 * square + 2.0 / 3.0 * cube) * a.extinction +
                          (2.0 * square - 4.0 / 3.0 * cube) * b.extinction +
                          (2.0 / 3.0 * cube - 0.5 * square) * c.extinction;
    const double behind = light.alpha - oneMinusExpNeg(depth * std::max(before, 0.0));
    light.color += weight * behind * (begin + place * gain);
  }
  return light;
}

/// The integral along a ray, cell by cell (scene/steps/CellRule.h). Places are in mm behind the span's begin.
template <class T>
class CellMarch {
public:
  CellMarch(const PictureTerms& terms, const RaySamples<T>& samples)
      : m_terms(terms), m_samples(samples), m_points(terms.scene.transferFunction.points),
        m_chords(terms, samples), m_values(terms.segments.values) {
    if (!terms.hasLooks)
      for (const ControlPoint& point : m_points)
        m_values.push_back(point.value);
  }

  /// Integrates front to back: `node(place, segment, scalar)` says what lies at a place whose scalar belongs
  /// to a segment of the function (point `segment - 1` to point `segment`), `add(light)` composites a piece
  /// and gives the transmittance behind it, `isEnd()` ends the ray. Returns how many nodes were looked at.
  /// A piece whose light does not stand still is cut into parts `cuts` times at most.
  template <class NodeAt, class Add, class IsEnd>
  int march(double fineness, int cuts, const NodeAt& node, const Add& add, const IsEnd& isEnd) {
    m_limit = largestPieceChange(fineness);
    m_transmittance = 1.0;
    m_spent = 0;
    for (double entry = 0.0; entry < m_chords.end();) {
      const double exit = m_chords.exitFrom(entry);
      cut(entry, exit);
      for (const Piece& piece : m_pieces)
        if (integrate(piece, cuts, node, add, isEnd))
          return m_spent;
      entry = exit;
    }
    return m_spent;
  }

private:
  struct Piece {
    double from = 0.0, to = 0.0; // mm
    std::size_t segment = 0;
  };

  // The pieces of a chord on which the function is linear, as far as they show.
  void cut(double entry, double exit) {
    m_pieces.clear();
    const double length = exit - entry;
    const ChordCubic cubic = m_chords.scalars(entry, exit);
    std::vector<double>& places = m_places;
    places.assign({0.0, 1.0});
    for (const double value : m_values)
      cubic.addCrossings(value, places);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (places[i + 1] - places[i] < 1e-12)
        continue;
      const std::size_t segment = segmentOf(cubic.at(0.5 * (places[i] + places[i + 1])));
      const Piece piece{entry + places[i] * length,
                        places[i + 1] == 1.0 ? exit : entry + places[i + 1] * length, segment};
      if (showsAnything(segment) && piece.to > piece.from)
        m_pieces.push_back(piece);
    }
  }

  // The first of the points above a value, or the gap of looks that holds it.
  std::size_t segmentOf(double value) const {
    return static_cast<std::size_t>(std::upper_bound(m_values.begin(), m_values.end(), value) -
                                    m_values.begin());
  }

  static bool showsAnything(const std::vector<ControlPoint>& points, std::size_t segment) {
    return (segment > 0 && points[segment - 1].opacity > 0.0) ||
           (segment < points.size() && points[segment].opacity > 0.0);
  }

  // Under any look that there is: which voxels are near is asked at nodes.
  bool showsAnything(std::size_t segment) const {
    if (!m_terms.hasLooks)
      return showsAnything(m_points, segment);
    for (std::size_t i = 0; i < m_terms.looks.functions.size(); ++i)
      if (showsAnything(m_terms.looks.functions[i].points, m_terms.segments.segments[segment][i]))
        return true;
    return false;
  }

  // Adds a piece, or its parts where its light does not stand still. Returns whether the ray has ended.
  template <class NodeAt, class Add, class IsEnd>
  bool integrate(const Piece& piece, int cuts, const NodeAt& nodeAt, const Add& add, const IsEnd& isEnd) {
    const double length = piece.to - piece.from;
    const double depth = length / m_terms.unitMm;
    const auto look = [&](double share) {
      ++m_spent;
      const double place = share == 1.0 ? piece.to : piece.from + share * length;
      return nodeAt(place, piece.segment, m_samples.scalarAt(place));
    };
    std::vector<CellNode>& nodes = m_nodes;
    nodes = {look(0.0), look(0.5), look(1.0)};
    CellLight light = panels(nodes, depth);
    bool isMoving = m_transmittance * light.alpha > faintPieces * m_limit;
    while (isMoving && static_cast<int>(nodes.size()) < cellNodes) {
      std::vector<CellNode> finer(2 * nodes.size() - 1);
      for (std::size_t i = 0; i < finer.size(); ++i)
        finer[i] = i % 2 == 0 ? nodes[i / 2] : look(double(i) / double(finer.size() - 1));
      nodes.swap(finer);
      const CellLight before = light;
      light = panels(nodes, depth);
      const glm::dvec3 change = glm::abs(light.color - before.color);
      const double off = std::max({change.r, change.g, change.b, std::abs(light.alpha - before.alpha),
                                   unforeseenIn(nodes, 2.0 * depth / double(nodes.size() - 1))});
      isMoving = m_transmittance * off > m_limit;
    }
    if (!isMoving || cuts == 0) {
      m_transmittance = add(light);
      return isEnd();
    }
    for (int part = 0; part < cellParts; ++part) {
      const double to = part + 1 == cellParts ? piece.to : piece.from + (part + 1) * length / cellParts;
      if (integrate({piece.from + part * length / cellParts, to, piece.segment}, cuts - 1, nodeAt, add,
                    isEnd))
        return true;
    }
    return false;
  }

  // The panels between nodes, `depth` unit distances long together, front to back.
  CellLight panels(const std::vector<CellNode>& nodes, double depth) const {
    CellLight light;
    for (std::size_t i = 0; i + 2 < nodes.size(); i += 2) {
      CellLight next =
          cellPanel(nodes[i], nodes[i + 1], nodes[i + 2], 2.0 * depth / double(nodes.size() - 1));
      // Where light jumps between nodes, the quadratic through them runs over what colours can be.
      if (!m_terms.terms.isUnlimited)
        next.color = glm::clamp(next.color, 0.0, next.alpha);
      light.color += (1.0 - light.alpha) * next.color;
      light.alpha += (1.0 - light.alpha) * next.alpha;
    }
    return light;
  }

  // How much light every second node adds that the quadratics through the others did not foresee.
  static double unforeseenIn(const std::vector<CellNode>& nodes, double depth) {
    double sum = 0.0, left = 1.0;
    for (std::size_t i = 0; i + 4 < nodes.size(); i += 4)
      for (const bool isFirst : {true, false}) {
        const CellNode& at = nodes[isFirst ? i + 1 : i + 3];
        const CellNode &near = nodes[isFirst ? i : i + 4], &far = nodes[isFirst ? i + 4 : i];
        const glm::dvec3 off =
            glm::abs(at.color - (0.375 * near.color + 0.75 * nodes[i + 2].color - 0.125 * far.color));
        const double taken = left * oneMinusExpNeg(depth * at.extinction);
        sum += taken * std::max({off.r, off.g, off.b});
        left -= taken;
      }
    return sum;
  }

  const PictureTerms& m_terms;
  const RaySamples<T>& m_samples;
  const std::vector<ControlPoint>& m_points;
  CellChords<T> m_chords;
  std::vector<double> m_values; // between which all functions are lines
  double m_limit = 0.0;
  double m_transmittance = 1.0;
  int m_spent = 0;
  std::vector<double> m_places;
  std::vector<Piece> m_pieces;
  std::vector<CellNode> m_nodes;
};

} // namespace limn
