// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <optional>

namespace limn {

/// The squared distances of a point to planes, each weighted by an area (M. Garland, P. Heckbert, "Surface
/// Simplification Using Quadric Error Metrics", SIGGRAPH 1997): xᵀAx - 2bᵀx + c.
struct Quadric {
  glm::dmat3 a{0.0};
  glm::dvec3 b{0.0};
  double c = 0.0;

  static Quadric ofPlane(const glm::dvec3& normal, const glm::dvec3& point, double area) {
    const double offset = glm::dot(normal, point);
    return {area * glm::outerProduct(normal, normal), area * offset * normal, area * offset * offset};
  }
  Quadric operator+(const Quadric& other) const { return {a + other.a, b + other.b, c + other.c}; }

  double at(const glm::dvec3& x) const {
    return std::max(0.0, glm::dot(x, a * x) - 2.0 * glm::dot(b, x) + c);
  }
  /// Of all planes; their normals have unit length.
  double area() const { return a[0][0] + a[1][1] + a[2][2]; }

  /// Where the sum is least; nothing where the planes do not fix a point well.
  std::optional<glm::dvec3> least() const {
    const double third = area() / 3.0, determinant = glm::determinant(a);
    constexpr double leastShare = 1e-5; // of the determinant of planes in all directions
    if (!(determinant > leastShare * third * third * third))
      return std::nullopt;
    return glm::inverse(a) * b;
  }
};

} // namespace limn
